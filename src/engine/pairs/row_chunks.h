#pragma once

#include <vector>

namespace runout {

struct Neighbours;
struct Wall;

/// Some blocks of pair rows that follow each other, and the boundary particles beside them.
struct RowChunk {
    int first_block = 0, last_block = 0;    ///< blocks [first_block, last_block)
    int first_active = 0, last_active = 0;  ///< of RowChunks::active
};

/// The blocks of pair rows, cut into chunks. The two ends of a pair, soil that does not sleep or wall, are in
/// the same chunk or in two that follow each other. The chunks do not depend on the number of threads. Each
/// thread has the same chunks in every pass, since a core reads what it wrote itself much faster than what
/// another wrote.
struct RowChunks {
    std::vector<RowChunk> list;
    std::vector<int> active;       ///< indices in Neighbours::active, chunk by chunk
    std::vector<int> share_start;  ///< chunks of thread t: [share_start[t], share_start[t+1]), at least one

    [[nodiscard]] int count() const { return static_cast<int>(list.size()); }
    [[nodiscard]] int shares() const { return static_cast<int>(share_start.size()) - 1; }
};

/// Cuts the rows into chunks. Keeps its memory from call to call.
class RowCutter {
  public:
    /// On return `n` has its chunks, with about the same number of pairs in each, given to at most `threads`
    /// threads.
    void cut(const Wall& wall, int threads, Neighbours& n);

  private:
    void place_boundary(const Neighbours& n);
    void find_reach(const Neighbours& n, const Wall& wall);
    void find_work(const Neighbours& n);
    [[nodiscard]] int most_chunks() const;
    void cut_blocks(int count);
    [[nodiscard]] bool reaches_too_far() const;
    void list_chunks(const Neighbours& n, RowChunks& chunks);

    std::vector<int> beside_;    ///< per active boundary particle: the block in the middle of its soil
    std::vector<int> reach_;     ///< per block: the last block that must be in its chunk or the next
    std::vector<long> work_;     ///< pairs of all blocks before this one
    std::vector<int> start_;     ///< first block of each chunk
    std::vector<int> chunk_of_;  ///< per block
    std::vector<int> cursor_;
};

}  // namespace runout
