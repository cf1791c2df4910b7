#include "engine/pair_row.h"

#include <limits>

namespace runout {
namespace {

WallPair& wall_pair(WallRow& row, int boundary) {
    for (WallPair& pair : row.merged) {
        if (pair.boundary == boundary) return pair;
    }
    row.merged.emplace_back();
    row.merged.back().boundary = boundary;
    return row.merged.back();
}

void merge(const Wall& wall, WallRow& row) {
    float nearest2 = std::numeric_limits<float>::infinity();
    const NearList& near = row.near;
    for (int k = 0; k < near.count; ++k) {
        const int q = wall.order[near.column[k]];
        const float r2 = near.dx[k] * near.dx[k] + near.dy[k] * near.dy[k];
        WallPair& pair = wall_pair(row, wall.group[q]);
        pair.gx += row.gx[k];
        pair.gy += row.gy[k];
        pair.stiffness += row.stiffness[k];
        if (r2 < nearest2) {
            nearest2 = r2;
            row.nearest_boundary = wall.group[q];
        }
        if (q != wall.group[q]) continue;
        pair.own = true;
        pair.own_gx = row.gx[k];
        pair.own_gy = row.gy[k];
        pair.own_kernel = row.kernel[k];
    }
}

void sum(WallRow& row) {
    const NearList& near = row.near;
    for (int k = 0; k < near.count; ++k) {
        row.sums.kernel += row.kernel[k];
        row.sums.stiffness += row.stiffness[k];
        row.sums.surface_x += row.gx[k];
        row.sums.surface_y += row.gy[k];
        row.sums.xx -= near.dx[k] * row.gx[k];
        row.sums.xy -= near.dx[k] * row.gy[k];
        row.sums.yy -= near.dy[k] * row.gy[k];
    }
}

GeometryConstants geometry_constants(const WendlandKernel& kernel, const Discretisation& d) {
    return {static_cast<float>(kernel.inverse_smoothing_length()), static_cast<float>(kernel.value_scale()),
            static_cast<float>(kernel.slope_scale() * d.volume()),
            static_cast<float>(-2.0 * d.volume() / d.density * kernel.slope_scale()),
            static_cast<float>(d.eta2())};
}

/// Particles within the support of a point, out of the cells of a grid around it.
void find(const PairFinder& finder, const CellGrid& grid, int reach, const std::vector<double>& px,
          const std::vector<double>& py, NearQuery query, NearList& near) {
    int candidates = 0;
    grid.around(query.x, query.y, reach, [&](int first, int last) {
        query.first[query.ranges] = first;
        query.last[query.ranges] = last;
        ++query.ranges;
        candidates += last - first;
    });
    near.count = 0;
    if (candidates == 0) return;
    near.reserve(static_cast<std::size_t>(candidates + lanes));
    near.count = pair_kernels().select_near(px.data(), py.data(), query, finder.support2, near.column.data(),
                                            near.dx.data(), near.dy.data());
}

}  // namespace

PairFinder::PairFinder(const Discretisation& discretisation)
    : kernel(discretisation.smoothing_length),
      constants(geometry_constants(kernel, discretisation)),
      support(static_cast<float>(kernel.support())),
      support2(support * support) {}

void PairFinder::find_soil(const CellGrid& grid, const Soil& soil, int i, NearList& near) const {
    find(*this, grid, cells_per_support, soil.x, soil.y, {.x = soil.x[i], .y = soil.y[i], .self = i}, near);
}

void PairFinder::find_wall(const Wall& wall, double x, double y, WallRow& row) const {
    row.merged.clear();
    row.sums = {};
    row.nearest_boundary = -1;
    find(*this, wall.grid, 1, wall.ordered_x, wall.ordered_y, {.x = x, .y = y}, row.near);
    if (row.near.count == 0) return;
    for (auto* field : {&row.gx, &row.gy, &row.stiffness, &row.kernel}) {
        if (field->size() < row.near.column.size()) field->resize(row.near.column.size());
    }
    pair_kernels().pair_geometry({row.near.count, row.near.dx.data(), row.near.dy.data(), row.gx.data(),
                                  row.gy.data(), row.stiffness.data(), row.kernel.data()},
                                 constants);
    merge(wall, row);
    sum(row);
}

}  // namespace runout
