#pragma once

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "engine/pairs/operators.h"
#include "engine/threads/parallel.h"

namespace runout {

/// Rows of soil [first, last).
struct RowRange {
    int first = 0, last = 0;
};

/// The rows of soil of a chunk, asleep or not.
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
    for (int k = c.first_active; k < c.last_active; ++k) f(n.chunks.active[k]);
}

/// Calls f(i) for the rows of soil of a chunk, asleep or not, then for its boundary nodes.
template <class Function>
void for_each_node(const Neighbours& n, int chunk, const Function& f) {
    for_each_soil(n, chunk, f);
    for_each_boundary(n, chunk, [&](int a) { f(n.first_boundary_node + a); });
}

/// Calls f(rows, last) for the rows of a chunk that do not sleep, see for_each_awake_run.
template <class Function>
void for_each_awake(const Neighbours& n, int chunk, const Function& f) {
    const RowChunk& c = n.chunks.list[chunk];
    for (int b = c.first_block; b < c.last_block; ++b) for_each_awake_run(n.blocks[b], n, f);
}

/// Calls f(c) for each chunk, each thread its share.
template <class Function>
void for_each_chunk(const RowChunks& chunks, const Function& f) {
    on_threads(chunks.shares(), [&](int share) {
        for (int c = chunks.share_start[share]; c < chunks.share_start[share + 1]; ++c) f(c);
    });
}

/// Adds the terms of the chunks in their order. So a sum has the same bits for any number of threads.
template <class Term>
Term sum_of(const std::vector<Term>& terms) {
    Term sum{};
    for (const Term& term : terms) sum += term;
    return sum;
}

/// Sum of f(c) over the chunks, see sum_of. `partial` is scratch memory, reused from call to call.
template <class Term, class Function>
Term sum_chunks(const RowChunks& chunks, std::vector<Term>& partial, const Function& f) {
    fit(partial, chunks.count());
    for_each_chunk(chunks, [&](int c) { partial[c] = f(c); });
    return sum_of(partial);
}

/// Greatest f(c) over the chunks, or 0 if all are less.
template <class Function>
double max_chunks(const RowChunks& chunks, std::vector<double>& partial, const Function& f) {
    sum_chunks(chunks, partial, f);
    double greatest = 0.0;
    for (const double term : partial) greatest = std::max(greatest, term);
    return greatest;
}

/// Where the threads of a team tell each other how far they have come.
class TeamSignals {
  public:
    void reset(int shares) {
        if (gates_.size() < static_cast<std::size_t>(shares)) gates_ = std::vector<Gate>(shares);
        for (Gate& gate : gates_) gate.first = gate.last = 0;
        arrived_.count = released_.count = 0;
    }
    void await_first(int share, int passes) const { await(gates_[share].first, passes); }
    void await_last(int share, int passes) const { await(gates_[share].last, passes); }
    void open_first(int share, int passes) { gates_[share].first.store(passes, std::memory_order_release); }
    void open_last(int share, int passes) { gates_[share].last.store(passes, std::memory_order_release); }
    void await_arrivals(int count) const { await(arrived_.count, count); }
    void await_release(int meeting) const { await(released_.count, meeting); }
    void arrive() { arrived_.count.fetch_add(1, std::memory_order_acq_rel); }
    void release(int meeting) { released_.count.store(meeting, std::memory_order_release); }

  private:
    // Each on a cache line of its own, so that threads do not slow each other down.
    struct alignas(64) Gate {  ///< passes done with the first and the last chunk of a share
        std::atomic<int> first{0}, last{0};
    };
    struct alignas(64) Counter {
        std::atomic<int> count{0};
    };
    static void await(const std::atomic<int>& done, int wanted) {
        constexpr int patience =
            10000;  // turns; then the core is given up, since the other thread may need it
        for (int turn = 0; done.load(std::memory_order_acquire) < wanted; ++turn)
            if (turn > patience) std::this_thread::yield();
    }
    std::vector<Gate> gates_;
    Counter arrived_, released_;
};

/// One thread of a team. Together the threads go through all chunks, each through its own share.
class TeamMember {
  public:
    TeamMember(const RowChunks& chunks, int share, int shares, TeamSignals& signals)
        : share_(share),
          shares_(shares),
          first_(shares == 1 ? 0 : chunks.share_start[share]),
          last_((shares == 1 ? chunks.count() : chunks.share_start[share + 1]) - 1),
          signals_(signals) {}

    /// Calls f(c) for each chunk of the share.
    template <class Function>
    void for_each_chunk(const Function& f) const {
        for (int c = first_; c <= last_; ++c) f(c);
    }

    /// Calls work(pass, chunk) for `passes` passes over the chunks of the share. The result is that of one
    /// whole pass after the other, provided that the work of a chunk
    /// - reads only what earlier passes wrote, in this chunk and the two beside it;
    /// - writes only into this chunk, and nothing that another chunk reads in the same pass.
    ///
    /// The order is another one (temporal blocking): pass p of a chunk comes right after pass p - 1 of the
    /// next chunk, so that the pairs of a chunk are still in the cache. Of two shares that touch, both begin
    /// or both end at the place where they touch. So one rarely waits for what the other has still to do
    /// there.
    template <class Work>
    void for_each_pass(int passes, const Work& work) {
        const bool falls = share_ % 2 == 0 && shares_ > 1;
        const int count = last_ - first_ + 1;
        for (int stage = 0; stage < count + passes - 1; ++stage) {
            for (int pass = std::max(0, stage - count + 1); pass <= std::min(passes - 1, stage); ++pass) {
                const int chunk = falls ? last_ - (stage - pass) : first_ + (stage - pass);
                await_beside(chunk, passes_done_ + pass);
                work(pass, chunk);
                tell_beside(chunk, passes_done_ + pass + 1);
            }
        }
        passes_done_ += passes;
    }

    /// All threads of the team meet here. One calls alone() while the others wait.
    template <class Function>
    void synchronise(const Function& alone) {
        ++meetings_;
        if (share_ > 0) {
            signals_.arrive();
            return signals_.await_release(meetings_);
        }
        signals_.await_arrivals(meetings_ * (shares_ - 1));
        alone();
        signals_.release(meetings_);
    }

  private:
    void await_beside(int chunk, int passes) const {
        if (chunk == first_ && share_ > 0) signals_.await_last(share_ - 1, passes);
        if (chunk == last_ && share_ + 1 < shares_) signals_.await_first(share_ + 1, passes);
    }
    void tell_beside(int chunk, int passes) {
        if (chunk == first_) signals_.open_first(share_, passes);
        if (chunk == last_) signals_.open_last(share_, passes);
    }

    int share_, shares_;
    int first_, last_;  ///< chunks of the share
    TeamSignals& signals_;
    int passes_done_ = 0;
    int meetings_ = 0;
};

/// Calls work(member) on each thread of a team; with fewer threads than shares, on one thread for all of
/// them.
template <class Work>
void with_team(const RowChunks& chunks, TeamSignals& signals, const Work& work) {
    const int shares = chunks.shares();
    signals.reset(shares);
    const auto do_share = [&](int share, int of) {
        TeamMember member(chunks, share, of, signals);
        work(member);
    };
    if (shares == 1) return do_share(0, 1);
#pragma omp parallel num_threads(shares)
    {
        const int thread = omp_get_thread_num();
        if (omp_get_num_threads() == shares)
            do_share(thread, shares);
        else if (thread == 0)  // fewer threads than asked for: one does all
            do_share(0, 1);
    }
}

}  // namespace runout
