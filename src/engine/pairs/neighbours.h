#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/pairs/row_chunks.h"
#include "engine/particles/cell_grid.h"
#include "engine/particles/discretisation.h"
#include "engine/particles/soil.h"
#include "engine/particles/wall.h"
#include "engine/simd/pair_kernels.h"

namespace runout {

/// A pair of soil and wall, seen from the soil. A boundary particle and its dummies (a group) make one pair.
struct WallPair {
    int row = 0;                   ///< soil particle
    int wall_index = 0;            ///< of the boundary particle
    int slot = 0;                  ///< its entry in the block's arrays
    float gx = 0, gy = 0;          ///< V gradW, the group's sum, 1/m
    float stiffness = 0;           ///< k, the group's sum
    float own_gx = 0, own_gy = 0;  ///< V gradW of the boundary particle alone
    double own_kernel_value = 0;   ///< W of the boundary particle alone
    bool own = false;              ///< the boundary particle itself is within the support
};

/// The pairs of up to 128 soil particles, a row each, in slices of 16 rows. Entry k of the row in lane l
/// stands at offset + 16 k + l: a loop over the lanes adds to 16 rows at once, and each row is summed in its
/// own order on every machine.
struct PairBlock {
    int first_row = 0;
    int highest = 0;  ///< highest soil row among the rows and their pairs
    int offset[slices_per_block + 1] = {};
    std::vector<std::int32_t>
        column;                 ///< node of the neighbour; padding entries point at node 0 with zero weights
    std::vector<float> gx, gy;  ///< V gradW_ij, 1/m
    std::vector<float> stiffness;      ///< k_ij of the pressure matrix
    std::vector<WallPair> wall_pairs;  ///< entries of `column` that are boundary particles
};

/// The same pair, seen from the boundary particle.
struct BoundaryPair {
    int soil = 0;
    float gx = 0, gy = 0;  ///< V gradW of the whole group, from the boundary's side
    float stiffness = 0;
    float own_gx = 0, own_gy = 0;  ///< of the boundary particle alone
};

/// Which particles are near each other, and the geometry of these pairs, for the particles where they stand
/// now.
///
/// Nodes are numbered: soil [0, soil.count), padding up to soil.padded(), then the active boundary particles,
/// those with soil within the support of their group.
struct Neighbours {
    int soil_count = 0;
    int first_boundary_node = 0;  ///< node of the first active boundary particle
    int nodes = 0;
    std::vector<PairBlock> blocks;

    std::vector<int> active;            ///< wall index of each active boundary particle, ascending
    std::vector<int> left;              ///< boundary particles that were active last time and are no longer
    std::vector<int> node_of_boundary;  ///< per boundary particle of the wall; -1: not active
    /// Where the pairs of each `active` begin in boundary_pairs, and their end.
    std::vector<int> boundary_start;
    std::vector<BoundaryPair> boundary_pairs;
    std::vector<int> boundary_soil;  ///< how many soil particles are within its own support, per `active`

    std::vector<double> density;  ///< rho / rho_0 per node, 1 on the full lattice
    /// Inverse moment matrix B^-1 of eq. 9 per node, row-major components.
    std::array<std::vector<float>, 4> correction;
    std::vector<double> stiffness_sum;  ///< sum of k over all neighbours, per soil particle
    std::vector<double> surface_x,
        surface_y;  ///< sum of V gradW, points into the soil at a free surface, 1/m
    /// Per soil particle, what its wall pairs are multiplied by: 1 for soil in company, 0 for a lone grain,
    /// which the bed line carries as a point mass.
    std::vector<float> company;
    std::vector<int> nearest_boundary;  ///< wall index, -1: no wall within the support; per soil particle

    /// Given before the search, per slice: 1 where all its rows sleep and nothing is solved; empty: nothing
    /// sleeps.
    std::vector<char> asleep;

    RowChunks chunks;  ///< of `blocks`, given to the threads of the search

    [[nodiscard]] bool is_asleep(int i) const {
        return !asleep.empty() && asleep[static_cast<std::size_t>(i / lanes)] != 0;
    }

    [[nodiscard]] int active_count() const { return static_cast<int>(active.size()); }
};

struct WallRow;

/// Builds Neighbours anew in every step. Keeps its memory from call to call.
class NeighbourSearch {
  public:
    NeighbourSearch(const Discretisation& discretisation, int threads);

    /// Sorts the soil into spatial order: all that particles carry moves with them.
    void sort(Soil& soil);
    /// On return `neighbours` describes the sorted soil and the wall around it. Rows of sleeping soil have no
    /// density and only their wall pairs, which the boundary particles need.
    void find(const Soil& soil, const Wall& wall, Neighbours& neighbours);

  private:
    void keep_shares(const Neighbours& n);
    void find_block(const Soil& soil, const Wall& wall, Neighbours& n, int block) const;
    void fade_lone_grains(Neighbours& n, int first_row, const SliceSums& soil,
                          std::array<WallRow, lanes>& wall) const;
    void write_sleeping_sums(Neighbours& n, int i, const WallRow& wall) const;
    void write_sums(Neighbours& n, int i, const SliceSums& soil, int lane, const WallRow& wall) const;
    void number_boundary(const Soil& soil, const Wall& wall, Neighbours& n);
    void fill_boundary_rows(const Wall& wall, const Soil& soil, Neighbours& n);

    Discretisation discretisation_;
    int threads_;
    double lone_kernel_sum_ = 0;     ///< sum of W over other soil up to which a grain is alone, 1/m2
    double company_kernel_sum_ = 0;  ///< and from which it is in company
    CellGrid grid_;
    std::vector<int> order_;
    std::array<std::vector<double>, 3> scratch_;
    std::array<std::vector<int>, 1> name_scratch_;
    // Shares of the threads, see even_shares.
    std::vector<int> share_blocks_;
    std::vector<int> share_rows_, share_points_;  ///< with and without the padding
    std::vector<double> moment_;
    std::vector<int> cursor_;
    RowCutter cutter_;
};

}  // namespace runout
