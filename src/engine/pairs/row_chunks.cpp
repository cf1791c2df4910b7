#include "engine/pairs/row_chunks.h"

#include <algorithm>
#include <numeric>

#include "engine/pairs/neighbours.h"
#include "engine/threads/node_array.h"

namespace runout {
namespace {

constexpr int least_blocks_of_chunk = 4;
// What one costs: they are done one by one, but in half of the passes only.
constexpr long pairs_of_boundary_pair = 3;

int block_of(int row) {
    return row / rows_per_block;
}

}  // namespace

void RowCutter::cut(const Wall& wall, int threads, Neighbours& n) {
    place_boundary(n);
    find_reach(n, wall);
    find_work(n);
    int count = most_chunks();
    cut_blocks(count);
    while (reaches_too_far()) cut_blocks(count = std::max(2, count - 1 - count / 8));
    RowChunks& chunks = n.chunks;
    list_chunks(n, chunks);
    const int shares = std::max(1, std::min(threads, count));
    make_room(chunks.share_start, shares + 1);
    chunks.share_start.clear();
    for (int t = 0; t <= shares; ++t) chunks.share_start.push_back(t * count / shares);
}

void RowCutter::place_boundary(const Neighbours& n) {
    fit(beside_, n.active_count());
    for (int a = 0; a < n.active_count(); ++a) {
        const int first = n.boundary_pairs[n.boundary_start[a]].soil;
        const int last = n.boundary_pairs[n.boundary_start[a + 1] - 1].soil;
        beside_[a] = block_of(first + (last - first) / 2);
    }
}

void RowCutter::find_reach(const Neighbours& n, const Wall& wall) {
    const int blocks = static_cast<int>(n.blocks.size());
    fit(reach_, blocks);
    for (int b = 0; b < blocks; ++b) reach_[b] = block_of(n.blocks[b].highest);
    const auto join = [&](int one, int other) {
        int& reach = reach_[std::min(one, other)];
        reach = std::max({reach, one, other});
    };
    for (int a = 0; a < n.active_count(); ++a) {
        join(beside_[a], block_of(n.boundary_pairs[n.boundary_start[a]].soil));
        join(beside_[a], block_of(n.boundary_pairs[n.boundary_start[a + 1] - 1].soil));
        const int b = n.active[a];
        for (int k = wall.neighbour_start[b]; k < wall.neighbour_start[b + 1]; ++k) {
            const int other = n.node_of_boundary[wall.neighbour[k]];
            if (other >= 0) join(beside_[a], beside_[other - n.first_boundary_node]);
        }
    }
}

void RowCutter::find_work(const Neighbours& n) {
    const int blocks = static_cast<int>(n.blocks.size());
    set_all(work_, blocks + 1, 0L);
    for (int b = 0; b < blocks; ++b) work_[b + 1] = n.blocks[b].offset[slices_per_block];
    for (int a = 0; a < n.active_count(); ++a)
        work_[beside_[a] + 1] += pairs_of_boundary_pair * (n.boundary_start[a + 1] - n.boundary_start[a]);
    std::partial_sum(work_.begin(), work_.end(), work_.begin());
}

/// How many chunks there may be at most. An even number, so that two threads have the same work.
int RowCutter::most_chunks() const {
    int length = least_blocks_of_chunk;
    const int blocks = static_cast<int>(reach_.size());
    for (int b = 0; b < blocks; ++b) length = std::max(length, reach_[b] - b);
    const int count = blocks / length;
    return count < 2 ? std::min(blocks, 2) : count - count % 2;
}

/// Cuts the blocks into `count` chunks, none empty, with as equal work as whole blocks allow.
void RowCutter::cut_blocks(int count) {
    const int blocks = static_cast<int>(reach_.size());
    make_room(start_, blocks + 1);
    start_.assign(1, 0);
    for (int c = 1; c < count; ++c) {
        const long before = work_.back() * c / count;
        const auto at = std::lower_bound(work_.begin(), work_.end(), before) - work_.begin();
        start_.push_back(std::clamp(static_cast<int>(at), start_.back() + 1, blocks - count + c));
    }
    start_.push_back(blocks);
}

bool RowCutter::reaches_too_far() const {
    for (std::size_t c = 0; c + 3 < start_.size(); ++c) {
        const auto furthest = *std::max_element(reach_.begin() + start_[c], reach_.begin() + start_[c + 1]);
        if (furthest >= start_[c + 2]) return true;
    }
    return false;
}

void RowCutter::list_chunks(const Neighbours& n, RowChunks& chunks) {
    const int count = static_cast<int>(start_.size()) - 1;
    make_room(chunks.list, count);
    chunks.list.assign(count, {});
    fit(chunk_of_, n.blocks.size());
    for (int c = 0; c < count; ++c) {
        chunks.list[c].first_block = start_[c];
        chunks.list[c].last_block = start_[c + 1];
        std::fill(chunk_of_.begin() + start_[c], chunk_of_.begin() + start_[c + 1], c);
    }
    for (int a = 0; a < n.active_count(); ++a) ++chunks.list[chunk_of_[beside_[a]]].last_active;
    make_room(cursor_, count);
    cursor_.clear();
    int placed = 0;
    for (RowChunk& chunk : chunks.list) {
        chunk.first_active = placed;
        placed = chunk.last_active += placed;
        cursor_.push_back(chunk.first_active);
    }
    fit(chunks.active, n.active_count());
    for (int a = 0; a < n.active_count(); ++a) chunks.active[cursor_[chunk_of_[beside_[a]]]++] = a;
}

}  // namespace runout
