#pragma once

#include <vector>

namespace runout {

/// Calls f(0) ... f(count - 1), on `threads` threads. What f(i) writes belongs to i alone, so the result does
/// not depend on the number of threads.
template <class Function>
void for_each_block(int count, int threads, const Function& f) {
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (int i = 0; i < count; ++i) f(i);
}

/// Sum of f(i) over i, each term computed on any thread and added in order: the same to the last bit for any
/// number of threads. `partial` is scratch that keeps its memory from call to call.
template <class Function>
double sum_blocks(int count, int threads, std::vector<double>& partial, const Function& f) {
    partial.resize(static_cast<std::size_t>(count));
    for_each_block(count, threads, [&](int i) { partial[static_cast<std::size_t>(i)] = f(i); });
    double sum = 0.0;
    for (const double term : partial) sum += term;
    return sum;
}

}  // namespace runout
