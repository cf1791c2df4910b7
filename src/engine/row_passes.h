#pragma once

#include <algorithm>

#include "engine/operators.h"
#include "engine/parallel.h"

namespace runout {

/// Does one task: rows(run, last) as for_each_awake_run, or boundary(a) for each of its boundary particles.
template <class Rows, class Boundary>
void do_task(const Neighbours& n, const RowTask& task, const Rows& rows, const Boundary& boundary) {
    if (task.block >= 0) return for_each_awake_run(n.blocks[task.block], n, rows);
    for (int k = task.first; k < task.last; ++k) boundary(n.chunks.boundary[k]);
}

/// Runs `passes` passes over all rows: rows(pass, rows, last) as for_each_awake, boundary(pass, a) for every
/// active boundary particle, on `threads` threads. In a pass, rows may read of their neighbours what earlier
/// passes wrote, and write only what is their own and no neighbour reads in the same pass. The result is that
/// of one pass after the other.
///
/// The passes follow each other through the chunks two apart, so that the pairs of a chunk are still in the
/// cache when the next pass comes to it: memory is read once for all passes (temporal blocking). When a pass
/// is at chunk c, the one before has left c + 1, and works on c + 2.
template <class Rows, class Boundary>
void for_each_pass(const Neighbours& n, int passes, int threads, const Rows& rows, const Boundary& boundary) {
    const RowChunks& chunks = n.chunks;
    const auto work = [&](int pass, int chunk, int task) {
        const int t = chunks.task_start[chunk] + task;
        if (t >= chunks.task_start[chunk + 1]) return;
        do_task(
            n, chunks.tasks[t], [&](const PairRows& run, int last) { rows(pass, run, last); },
            [&](int a) { boundary(pass, a); });
    };
    for (int stage = 0; stage < chunks.count() + 2 * (passes - 1); ++stage) {
        const int first = std::max(0, (stage - chunks.count() + 2) / 2);
        const int last = std::min(passes - 1, stage / 2);
        if (last < first) continue;  // with one chunk, every other stage
        for_each_block((last - first + 1) * chunks.widest, threads, [&](int t) {
            const int pass = first + t / chunks.widest;
            work(pass, stage - 2 * pass, t % chunks.widest);
        });
    }
}

}  // namespace runout
