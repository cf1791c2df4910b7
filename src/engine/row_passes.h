#pragma once

#include <algorithm>

#include "engine/operators.h"
#include "engine/parallel.h"

namespace runout {

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
        const int block = chunks.block_start[chunk] + task;
        if (block < chunks.block_start[chunk + 1]) {
            return for_each_awake_run(n.blocks[block], n,
                                      [&](const PairRows& run, int last) { rows(pass, run, last); });
        }
        const int first =
            chunks.boundary_start[chunk] + (block - chunks.block_start[chunk + 1]) * boundary_chunk;
        const int last = std::min(chunks.boundary_start[chunk + 1], first + boundary_chunk);
        for (int k = first; k < last; ++k) boundary(pass, chunks.boundary[k]);
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
