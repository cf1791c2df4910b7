#pragma once

#include <vector>

namespace runout {

struct Neighbours;

/// What one thread works on at a time: the rows of a block, or a piece of the boundary particles.
struct RowTask {
    int block = -1;           ///< -1: boundary particles [first, last) of RowChunks::boundary
    int first = 0, last = 0;  ///< nothing: a block
};

/// Blocks of pair rows cut into consecutive chunks so that every pair of soil that does not sleep is of one
/// chunk or of two that follow each other. A boundary particle belongs to a chunk as well: all soil it is
/// paired with is in that, the one before or the one after.
struct RowChunks {
    std::vector<int> block_start;     ///< blocks of chunk c: [block_start[c], block_start[c+1])
    std::vector<int> boundary_start;  ///< boundary particles of chunk c: [boundary_start[c], ...[c+1])
    std::vector<int> boundary;        ///< active boundary particles, chunk by chunk
    /// Tasks of chunk c: [task_start[c], task_start[c+1]). Boundary particles stand after a block of soil
    /// that they touch, so that threads which take a share of the tasks each have their share of both, side
    /// by side.
    std::vector<int> task_start;
    std::vector<RowTask> tasks;
    int widest = 0;  ///< most tasks of a chunk

    [[nodiscard]] int count() const { return static_cast<int>(block_start.size()) - 1; }
};

/// Active boundary particles that one thread works on at a time: about as long as on a block.
constexpr int boundary_chunk = 32;

/// Cuts the rows into chunks; keeps the memory from call to call.
class RowCutter {
  public:
    void cut(Neighbours& n);

  private:
    void find_reach(const Neighbours& n);
    void cut_blocks(int blocks, RowChunks& chunks);
    void place_boundary(const Neighbours& n, RowChunks& chunks);
    static void list_tasks(const Neighbours& n, RowChunks& chunks);

    std::vector<int> next_;        ///< per block: the last block that is to be in its chunk or the next
    std::vector<int> after_next_;  ///< per block: the last that is to be no further than two chunks on
    std::vector<int> chunk_of_;    ///< per block
    std::vector<int> cursor_;
};

}  // namespace runout
