#pragma once

#include <vector>

namespace runout {

/// Calls f(0) ... f(threads - 1), each on a thread of its own: f(t) does the share of thread t, and what it
/// writes belongs to that share alone, so that the result does not depend on the number of threads.
template <class Function>
void on_threads(int threads, const Function& f) {
    if (threads <= 1) {  // a team of one is made and thrown away again, which costs more than short loops
        for (int t = 0; t < threads; ++t) f(t);
        return;
    }
#pragma omp parallel for schedule(static) num_threads(threads)
    for (int t = 0; t < threads; ++t) f(t);
}

/// Where each thread's share of a range begins, and one past the end of the last: the same number each.
inline std::vector<int> even_shares(int size, int threads) {
    std::vector<int> start;
    for (int t = 0; t <= threads; ++t)
        start.push_back(static_cast<int>(static_cast<long>(size) * t / threads));
    return start;
}

/// Calls f(t, first, last) for each thread's share t of a range, see even_shares.
template <class Function>
void for_each_share(const std::vector<int>& start, const Function& f) {
    on_threads(static_cast<int>(start.size()) - 1, [&](int t) { f(t, start[t], start[t + 1]); });
}

}  // namespace runout
