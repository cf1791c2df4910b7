#pragma once

#include <algorithm>
#include <vector>

namespace runout {

/// Calls f(0) ... f(count - 1), on `threads` threads. What f(i) writes belongs to i alone, so the result does
/// not depend on the number of threads.
template <class Function>
void for_each_block(int count, int threads, const Function& f) {
    if (threads <= 1) {  // a team of one is made and thrown away again, which costs more than short loops
        for (int i = 0; i < count; ++i) f(i);
        return;
    }
#pragma omp parallel for schedule(static) num_threads(threads)
    for (int i = 0; i < count; ++i) f(i);
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
    const int shares = static_cast<int>(start.size()) - 1;
    for_each_block(shares, shares, [&](int t) { f(t, start[t], start[t + 1]); });
}

/// Numbers that one thread works on at a time.
constexpr int piece = 512;

/// Calls f(first, last) for consecutive pieces of [0, size), on `threads` threads.
template <class Function>
void for_each_piece(int size, int threads, const Function& f) {
    for_each_block((size + piece - 1) / piece, threads,
                   [&](int p) { f(p * piece, std::min(size, (p + 1) * piece)); });
}

/// The terms added in order.
template <class Term>
Term sum_of(const std::vector<Term>& terms) {
    Term sum{};
    for (const Term& term : terms) sum += term;
    return sum;
}

/// Sum of f(i) over i, each term computed on any thread and added in order: the same to the last bit for any
/// number of threads. `partial` is scratch that keeps its memory from call to call.
template <class Term, class Function>
Term sum_blocks(int count, int threads, std::vector<Term>& partial, const Function& f) {
    partial.resize(static_cast<std::size_t>(count));
    for_each_block(count, threads, [&](int i) { partial[static_cast<std::size_t>(i)] = f(i); });
    return sum_of(partial);
}

/// Sum of f(first, last) over consecutive pieces of [0, size), see sum_blocks.
template <class Term, class Function>
Term sum_pieces(int size, int threads, std::vector<Term>& partial, const Function& f) {
    return sum_blocks((size + piece - 1) / piece, threads, partial,
                      [&](int p) { return f(p * piece, std::min(size, (p + 1) * piece)); });
}

}  // namespace runout
