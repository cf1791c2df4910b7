#include "engine/pair_row.h"

#include <cmath>
#include <limits>

#include "engine/pair_kernels.h"

namespace runout {
namespace {

/// Appends the particles of a cell range that lie within the support. Branchless: every candidate is written,
/// and kept by moving on.
template <class Index>
void collect(PairList& list, const std::vector<double>& px, const std::vector<double>& py, double x, double y,
             double support2, int first, int last, const Index& index) {
    list.reserve(static_cast<std::size_t>(list.count + last - first));
    int count = list.count;
    for (int k = first; k < last; ++k) {
        const int j = index(k);
        const double dx = x - px[j];
        const double dy = y - py[j];
        const double r2 = dx * dx + dy * dy;
        list.column[count] = j;
        list.dx[count] = dx;
        list.dy[count] = dy;
        list.r2[count] = r2;
        count += r2 < support2 ? 1 : 0;
    }
    list.count = count;
}

WallPair& wall_pair(PairRow& row, int boundary) {
    for (WallPair& pair : row.merged) {
        if (pair.boundary == boundary) return pair;
    }
    row.merged.emplace_back();
    row.merged.back().boundary = boundary;
    return row.merged.back();
}

/// Geometry of every pair of a list, added to the row's sums.
void add_pairs(PairRow& row, PairList& list, const GeometryConstants& constants) {
    pair_kernels().pair_geometry({list.count, list.dx.data(), list.dy.data(), list.r2.data(), list.gx.data(),
                                  list.gy.data(), list.stiffness.data(), list.kernel.data()},
                                 constants);
    for (int k = 0; k < list.count; ++k) {
        row.kernel_sum += list.kernel[k];
        row.stiffness_sum += list.stiffness[k];
        row.surface_x += list.gx[k];
        row.surface_y += list.gy[k];
        row.moment[0] -= list.dx[k] * list.gx[k];
        row.moment[1] -= list.dx[k] * list.gy[k];
        row.moment[3] -= list.dy[k] * list.gy[k];
    }
    row.moment[2] = row.moment[1];  // gradW lies along the pair
}

GeometryConstants geometry_constants(const WendlandKernel& kernel, const Discretisation& d) {
    return {kernel.inverse_smoothing_length(), kernel.value_scale(), kernel.slope_scale() * d.volume(),
            -2.0 * d.volume() / d.density * kernel.slope_scale(), d.eta2()};
}

/// Merges the wall particles of a row into their boundary particles.
void merge_wall(PairRow& row, const Wall& wall) {
    double nearest2 = std::numeric_limits<double>::infinity();
    const PairList& list = row.wall;
    for (int k = 0; k < list.count; ++k) {
        const int q = list.column[k];
        WallPair& pair = wall_pair(row, wall.group[q]);
        pair.gx += static_cast<float>(list.gx[k]);
        pair.gy += static_cast<float>(list.gy[k]);
        pair.stiffness += static_cast<float>(list.stiffness[k]);
        if (list.r2[k] < nearest2) {
            nearest2 = list.r2[k];
            row.nearest_boundary = wall.group[q];
        }
        if (q != wall.group[q]) continue;
        pair.own = true;
        pair.own_gx = static_cast<float>(list.gx[k]);
        pair.own_gy = static_cast<float>(list.gy[k]);
        pair.own_kernel = list.kernel[k];
    }
}

}  // namespace

void find_pair_row(const CellGrid& grid, const Discretisation& discretisation, const Soil& soil,
                   const Wall& wall, int i, PairRow& row) {
    const WendlandKernel kernel(discretisation.smoothing_length);
    const GeometryConstants constants = geometry_constants(kernel, discretisation);
    const double x = soil.x[i];
    const double y = soil.y[i];
    const double support2 = kernel.support() * kernel.support();
    grid.around(x, y, cells_per_support, [&](int first, int last) {
        const auto self = [](int k) { return k; };
        const bool holds_i = first <= i && i < last;
        collect(row.soil, soil.x, soil.y, x, y, support2, first, holds_i ? i : last, self);
        if (holds_i) collect(row.soil, soil.x, soil.y, x, y, support2, i + 1, last, self);
    });
    wall.grid.around(x, y, 1, [&](int first, int last) {
        collect(row.wall, wall.x, wall.y, x, y, support2, first, last, [&](int k) { return wall.order[k]; });
    });
    row.kernel_sum = kernel.value(0.0);
    add_pairs(row, row.soil, constants);
    add_pairs(row, row.wall, constants);
    merge_wall(row, wall);
}

}  // namespace runout
