#pragma once

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "engine/operators.h"
#include "engine/parallel.h"

namespace runout {

/// Rows of soil [first, last).
struct RowRange {
    int first = 0, last = 0;
};

/// Of a chunk, asleep or not.
inline RowRange soil_rows(const Neighbours& n, int chunk) {
    const RowChunk& c = n.chunks.list[chunk];
    return {c.first_block * rows_per_block, std::min(c.last_block * rows_per_block, n.soil_count)};
}

/// Calls f(i) for the rows of soil of a chunk, asleep or not.
template <class Function>
void for_each_soil(const Neighbours& n, int chunk, const Function& f) {
    const RowRange rows = soil_rows(n, chunk);
    for (int i = rows.first; i < rows.last; ++i) f(i);
}

/// Calls f(a) for the active boundary particles of a chunk.
template <class Function>
void for_each_boundary(const Neighbours& n, int chunk, const Function& f) {
    const RowChunk& c = n.chunks.list[chunk];
    for (int k = c.first_boundary; k < c.last_boundary; ++k) f(n.chunks.boundary[k]);
}

/// Calls f(i) for the rows of soil of a chunk, asleep or not, then for its boundary nodes.
template <class Function>
void for_each_node(const Neighbours& n, int chunk, const Function& f) {
    for_each_soil(n, chunk, f);
    for_each_boundary(n, chunk, [&](int a) { f(n.first_boundary + a); });
}

/// Calls f(rows, last) for the rows of a chunk that do not sleep, see for_each_awake_run.
template <class Function>
void for_each_awake(const Neighbours& n, int chunk, const Function& f) {
    const RowChunk& c = n.chunks.list[chunk];
    for (int b = c.first_block; b < c.last_block; ++b) for_each_awake_run(n.blocks[b], n, f);
}

/// Calls f(block, i, gradient) with the plain velocity gradient of every row of soil of a chunk.
template <class Function>
void for_each_velocity_gradient(const Neighbours& n, int chunk, const FloatPair* velocity,
                                const Function& f) {
    const RowChunk& c = n.chunks.list[chunk];
    for (int b = c.first_block; b < c.last_block; ++b) {
        for_each_velocity_gradient(n.blocks[b], n, velocity, [&](int i, const VelocityGradient& gradient) {
            f(n.blocks[b], i, gradient);
        });
    }
}

/// Calls f(c) for each chunk, each thread its share.
template <class Function>
void for_each_chunk(const RowChunks& chunks, const Function& f) {
    on_threads(chunks.shares(), [&](int share) {
        for (int c = chunks.share_start[share]; c < chunks.share_start[share + 1]; ++c) f(c);
    });
}

/// The terms of the chunks, added in order: the same to the last bit for any number of threads.
template <class Term>
Term sum_of(const std::vector<Term>& terms) {
    Term sum{};
    for (const Term& term : terms) sum += term;
    return sum;
}

/// Sum of f(c) over the chunks, see sum_of. `partial` is scratch that keeps its memory from call to call.
template <class Term, class Function>
Term sum_chunks(const RowChunks& chunks, std::vector<Term>& partial, const Function& f) {
    fit(partial, chunks.count());
    for_each_chunk(chunks, [&](int c) { partial[c] = f(c); });
    return sum_of(partial);
}

/// Greatest f(c) over the chunks, none below 0.
template <class Function>
double max_chunks(const RowChunks& chunks, std::vector<double>& partial, const Function& f) {
    sum_chunks(chunks, partial, f);
    double greatest = 0.0;
    for (const double term : partial) greatest = std::max(greatest, term);
    return greatest;
}

/// Where threads tell each other how far they have come with the first and the last chunk of their share,
/// which those of the shares before and after may touch.
class PassGates {
  public:
    void close(int shares) {
        if (gates_.size() < static_cast<std::size_t>(shares)) gates_ = std::vector<Gate>(shares);
        for (Gate& gate : gates_) gate.first = gate.last = 0;
    }
    void await_first(int share, int passes) const { await(gates_[share].first, passes); }
    void await_last(int share, int passes) const { await(gates_[share].last, passes); }
    void open_first(int share, int passes) { gates_[share].first.store(passes, std::memory_order_release); }
    void open_last(int share, int passes) { gates_[share].last.store(passes, std::memory_order_release); }

  private:
    struct alignas(64) Gate {                // a cache line of its own
        std::atomic<int> first{0}, last{0};  ///< passes done
    };
    static void await(const std::atomic<int>& done, int passes) {
        constexpr int patience =
            10000;  // turns; where there are fewer cores than threads, the other must run
        for (int turn = 0; done.load(std::memory_order_acquire) < passes; ++turn)
            if (turn > patience) std::this_thread::yield();
    }
    std::vector<Gate> gates_;
};

/// Runs the passes of one share, chunk by chunk: pass p of a chunk follows pass p - 1 of the next, so that
/// the pairs of a chunk are still in the cache when the next pass comes to it (temporal blocking). Shares
/// that follow each other begin where they touch, or end there: so each has long done what the other waits
/// for.
template <class Work>
void run_share(const RowChunks& chunks, int share, int passes, PassGates& gates, const Work& work) {
    const int first = chunks.share_start[share];
    const int last = chunks.share_start[share + 1] - 1;
    const bool falls = share % 2 == 0 && chunks.shares() > 1;
    const int count = last - first + 1;
    for (int stage = 0; stage < count + passes - 1; ++stage) {
        for (int pass = std::max(0, stage - count + 1); pass <= std::min(passes - 1, stage); ++pass) {
            const int chunk = falls ? last - (stage - pass) : first + (stage - pass);
            if (chunk == first && share > 0) gates.await_last(share - 1, pass);
            if (chunk == last && share + 1 < chunks.shares()) gates.await_first(share + 1, pass);
            work(pass, chunk);
            if (chunk == first) gates.open_first(share, pass + 1);
            if (chunk == last) gates.open_last(share, pass + 1);
        }
    }
}

/// Runs `passes` passes over all chunks: work(pass, chunk), each thread its share. In a pass, a chunk may
/// read of itself and of the two beside it what earlier passes wrote, and write only what is its own and no
/// other reads in the same pass. The result is that of one pass after the other.
template <class Work>
void for_each_pass(const RowChunks& chunks, int passes, PassGates& gates, const Work& work) {
    const int shares = chunks.shares();
    gates.close(shares);
    if (shares == 1) return run_share(chunks, 0, passes, gates, work);
#pragma omp parallel num_threads(shares)
    {
        if (omp_get_num_threads() == shares) {
            run_share(chunks, omp_get_thread_num(), passes, gates, work);
        } else if (omp_get_thread_num() == 0) {  // there are not as many threads to be had
            for (int pass = 0; pass < passes; ++pass)
                for (int chunk = 0; chunk < chunks.count(); ++chunk) work(pass, chunk);
        }
    }
}

}  // namespace runout
