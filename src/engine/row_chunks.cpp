#include "engine/row_chunks.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/neighbours.h"
#include "engine/node_array.h"

namespace runout {
namespace {

/// Fewer blocks than this stay in one chunk: their pairs fit into the cache from pass to pass as they are.
constexpr int least_blocks_to_cut = 256;
constexpr int least_blocks_of_chunk = 8;

int block_of(int row) {
    return row / rows_per_block;
}

int first_block(const Neighbours& n, int a) {
    return block_of(n.boundary_pairs[n.boundary_start[a]].soil);
}
int last_block(const Neighbours& n, int a) {
    return block_of(n.boundary_pairs[n.boundary_start[a + 1] - 1].soil);
}

}  // namespace

void RowCutter::cut(Neighbours& n) {
    const int blocks = static_cast<int>(n.blocks.size());
    RowChunks& chunks = n.chunks;
    chunks.block_start.assign(1, 0);
    if (blocks < least_blocks_to_cut) {
        chunks.block_start.push_back(blocks);
    } else {
        find_reach(n);
        cut_blocks(blocks, chunks);
    }
    place_boundary(n, chunks);
    list_tasks(n, chunks);
}

void RowCutter::find_reach(const Neighbours& n) {
    const int blocks = static_cast<int>(n.blocks.size());
    fit(next_, blocks);
    set_all(after_next_, blocks, 0);
    for (int b = 0; b < blocks; ++b) next_[b] = block_of(n.blocks[b].highest);
    for (int a = 0; a < n.active_count(); ++a) {
        int& furthest = after_next_[first_block(n, a)];
        furthest = std::max(furthest, last_block(n, a));
    }
}

void RowCutter::cut_blocks(int blocks, RowChunks& chunks) {
    make_room(chunks.block_start, blocks / least_blocks_of_chunk + 2);
    const auto furthest = [](const std::vector<int>& reach, int first, int last) {
        return *std::max_element(reach.begin() + first, reach.begin() + last);
    };
    int before = 0;  // the two chunks that end here: [before, first) and [first, end)
    int first = 0;
    int end = 0;
    while (end < blocks) {
        int wanted = end + least_blocks_of_chunk;
        if (end > first) wanted = std::max(wanted, furthest(next_, first, end) + 1);
        if (first > before) wanted = std::max(wanted, furthest(after_next_, before, first) + 1);
        before = first;
        first = end;
        end = std::min(wanted, blocks);
        chunks.block_start.push_back(end);
    }
}

void RowCutter::place_boundary(const Neighbours& n, RowChunks& chunks) {
    const int count = chunks.count();
    fit(chunk_of_, n.blocks.size());
    for (int c = 0; c < count; ++c)
        std::fill(chunk_of_.begin() + chunks.block_start[c], chunk_of_.begin() + chunks.block_start[c + 1],
                  c);
    const auto chunk_of_boundary = [&](int a) {
        return (chunk_of_[first_block(n, a)] + chunk_of_[last_block(n, a)]) / 2;
    };
    set_all(chunks.boundary_start, count + 1, 0);
    for (int a = 0; a < n.active_count(); ++a) ++chunks.boundary_start[chunk_of_boundary(a) + 1];
    std::partial_sum(chunks.boundary_start.begin(), chunks.boundary_start.end(),
                     chunks.boundary_start.begin());
    fit(chunks.boundary, n.active_count());
    make_room(cursor_, chunks.boundary_start.size());
    cursor_.assign(chunks.boundary_start.begin(), chunks.boundary_start.end());
    for (int a = 0; a < n.active_count(); ++a) chunks.boundary[cursor_[chunk_of_boundary(a)]++] = a;
}

void RowCutter::list_tasks(const Neighbours& n, RowChunks& chunks) {
    make_room(chunks.task_start, chunks.block_start.size());
    make_room(chunks.tasks, n.blocks.size() + n.active_count() / boundary_chunk + chunks.count());
    chunks.task_start.assign(1, 0);
    chunks.tasks.clear();
    chunks.widest = 0;
    for (int c = 0; c < chunks.count(); ++c) {
        int placed = chunks.boundary_start[c];
        const int end = chunks.boundary_start[c + 1];
        const auto place_piece = [&] {
            const int first = std::exchange(placed, std::min(placed + boundary_chunk, end));
            chunks.tasks.push_back({-1, first, placed});
        };
        for (int b = chunks.block_start[c]; b < chunks.block_start[c + 1]; ++b) {
            chunks.tasks.push_back({b});
            while (placed < end && first_block(n, chunks.boundary[placed]) <= b) place_piece();
        }
        while (placed < end) place_piece();
        chunks.task_start.push_back(static_cast<int>(chunks.tasks.size()));
        chunks.widest = std::max(chunks.widest, chunks.task_start[c + 1] - chunks.task_start[c]);
    }
}

}  // namespace runout
