#pragma once

#include <array>
#include <vector>

#include "engine/cell_grid.h"
#include "engine/kernel.h"
#include "engine/neighbours.h"
#include "engine/pair_kernels.h"
#include "engine/soil.h"
#include "engine/wall.h"

namespace runout {

/// Soil cells along one kernel support: smaller cells leave fewer candidates that are too far.
constexpr int cells_per_support = 2;
static_assert(2 * cells_per_support + 1 <= NearQuery::max_ranges);

/// Particles within the support of one, in the order they were met. Separations in single precision, taken
/// from positions in double: what one particle sees of a pair is the exact negative of what the other sees.
struct NearList {
    int count = 0;
    std::vector<std::int32_t> column;
    std::vector<float> dx, dy;  ///< x_i - x_j, m

    void reserve(std::size_t size) {
        if (column.size() >= size) return;
        column.resize(size);
        dx.resize(size);
        dy.resize(size);
    }
};

/// Sums over the pairs of one row.
struct RowSums {
    double kernel = 0;                    ///< of W, 1/m2
    double stiffness = 0;                 ///< of k
    double surface_x = 0, surface_y = 0;  ///< of V gradW, 1/m
    double xx = 0, xy = 0, yy = 0;        ///< moments -V x gradW
};

/// Wall particles near one soil particle, merged into their boundary particles.
struct WallRow {
    NearList near;
    std::vector<float> gx, gy, stiffness, kernel;
    std::vector<WallPair> merged;
    RowSums sums;
    int nearest_boundary = -1;
};

/// What finding pairs needs besides the particles.
struct PairFinder {
    WendlandKernel kernel;
    GeometryConstants constants;
    float support;   ///< m
    float support2;  ///< m2

    explicit PairFinder(const Discretisation& discretisation);

    /// Soil within the support of soil particle i, in a grid of support / cells_per_support.
    void find_soil(const CellGrid& grid, const Soil& soil, int i, NearList& near) const;
    /// Wall within the support of a point; on return the pairs are merged and summed.
    void find_wall(const Wall& wall, double x, double y, WallRow& row) const;
};

}  // namespace runout
