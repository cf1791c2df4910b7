#pragma once

#include <vector>

#include "engine/cell_grid.h"
#include "engine/kernel.h"
#include "engine/neighbours.h"
#include "engine/soil.h"
#include "engine/wall.h"

namespace runout {

/// Soil cells along one kernel support: smaller cells leave fewer candidates that are too far.
constexpr int cells_per_support = 2;

/// Particles within the support of one, in the order they were met, and the geometry of each pair.
struct PairList {
    int count = 0;
    std::vector<int> column;
    std::vector<double> dx, dy, r2, gx, gy, stiffness, kernel;

    void reserve(std::size_t size) {
        if (column.size() >= size) return;
        column.resize(size);
        for (auto* field : {&dx, &dy, &r2, &gx, &gy, &stiffness, &kernel}) field->resize(size);
    }
};

/// One row while it is collected: soil pairs, wall pairs and the sums that come with them.
struct PairRow {
    PairList soil, wall;
    std::vector<WallPair> merged;
    double kernel_sum = 0, stiffness_sum = 0;
    double surface_x = 0, surface_y = 0;
    double moment[4] = {};
    int nearest_boundary = -1;

    void clear() {
        soil.count = wall.count = 0;
        merged.clear();
        kernel_sum = stiffness_sum = surface_x = surface_y = 0;
        for (double& m : moment) m = 0;
        nearest_boundary = -1;
    }
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(soil.count) + merged.size(); }
};

/// Finds the row of soil particle i in a grid of support / cells_per_support: who is within the support, in
/// the order of the cells, and the sums over them. On return wall pairs are merged into their boundary
/// particles. `row` has been cleared.
void find_pair_row(const CellGrid& grid, const Discretisation& discretisation, const Soil& soil,
                   const Wall& wall, int i, PairRow& row);

}  // namespace runout
