#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "engine/pairs/neighbours.h"
#include "engine/particles/cell_grid.h"
#include "engine/particles/discretisation.h"
#include "engine/particles/kernel.h"
#include "engine/particles/soil.h"
#include "engine/particles/wall.h"
#include "engine/simd/pair_kernels.h"

namespace runout {

/// Soil cells along one kernel support. The smaller the cells, the fewer candidates are too far.
constexpr int cells_per_support = 2;

/// Particles within the support of a point, in the order in which they were found. Separations are in single
/// precision but taken from positions in double precision, so that the two particles of a pair have exactly
/// opposite ones.
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

/// The same for the soil rows of a slice: entry e of lane l stands at 16 e + l.
struct NearSlice {
    std::array<int, lanes> count{};
    std::vector<std::int32_t> column;
    std::vector<FloatPair> separation;  ///< x_i - x_j, m
    std::vector<std::int32_t> candidate;

    [[nodiscard]] int width() const { return *std::max_element(count.begin(), count.end()); }
    void reserve(std::size_t entries) {
        if (column.size() >= entries * lanes) return;
        column.resize(entries * lanes);
        separation.resize(entries * lanes);
    }
};

/// Sums over the pairs of one row.
struct RowSums {
    double kernel_sum = 0;                ///< of W, 1/m2
    double stiffness = 0;                 ///< of k
    double surface_x = 0, surface_y = 0;  ///< of V gradW, 1/m
    double xx = 0, xy = 0, yy = 0;        ///< moments -V x gradW
};

/// Wall particles near one soil particle, merged into their boundary particles.
struct WallRow {
    NearList near;
    std::vector<float> gx, gy, stiffness, kernel_value;
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

    /// Soil within the support of each soil particle of [first, last), a slice or the start of one, in the
    /// grid of support / cells_per_support that sorted the soil.
    void find_soil(const CellGrid& grid, const Soil& soil, int first, int last, NearSlice& near) const;
    /// Wall within the support of a point; on return the pairs are merged and summed.
    void find_wall(const Wall& wall, double x, double y, WallRow& row) const;
};

}  // namespace runout
