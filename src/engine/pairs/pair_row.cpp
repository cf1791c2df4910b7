#include "engine/pairs/pair_row.h"

#include <limits>

namespace runout {
namespace {

WallPair& wall_pair(WallRow& row, int wall_index) {
    for (WallPair& pair : row.merged) {
        if (pair.wall_index == wall_index) return pair;
    }
    row.merged.emplace_back();
    row.merged.back().wall_index = wall_index;
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
        pair.own_kernel_value = row.kernel_value[k];
    }
}

void sum(WallRow& row) {
    const NearList& near = row.near;
    for (int k = 0; k < near.count; ++k) {
        row.sums.kernel_sum += row.kernel_value[k];
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

/// Wall particles within the support of a point.
void find_near(const Wall& wall, double x, double y, float support2, NearList& near) {
    NearQuery query{.x = x, .y = y};
    int candidates = 0;
    wall.grid.around(x, y, 1, [&](int first, int last) {
        query.first[query.ranges] = first;
        query.last[query.ranges] = last;
        ++query.ranges;
        candidates += last - first;
    });
    near.count = 0;
    if (candidates == 0) return;
    near.reserve(static_cast<std::size_t>(candidates + 1));
    near.count = pair_kernels().select_near(wall.ordered_x.data(), wall.ordered_y.data(), query, support2,
                                            near.column.data(), near.dx.data(), near.dy.data());
}

/// Returns one past the last of the particles from `first` on that stand in the same column of cells as the
/// first; they are in the order of the grid. On return `cells` are those that they stand in.
int end_of_column(const CellGrid& grid, const Soil& soil, int first, int last, CellGrid::Window& cells) {
    const long column = grid.column(soil.x[first]);
    int end = first + 1;
    while (end < last && grid.column(soil.x[end]) == column) ++end;
    cells = {column, column, grid.tier(soil.y[first]), grid.tier(soil.y[end - 1])};
    return end;
}

}  // namespace

PairFinder::PairFinder(const Discretisation& discretisation)
    : kernel(discretisation.smoothing_length),
      constants(geometry_constants(kernel, discretisation)),
      support(static_cast<float>(kernel.support())),
      support2(support * support) {}

void PairFinder::find_soil(const CellGrid& grid, const Soil& soil, int first, int last,
                           NearSlice& near) const {
    near.count.fill(0);
    for (int i = first; i < last;) {
        CellGrid::Window cells;
        const int end = end_of_column(grid, soil, i, last, cells);
        near.candidate.clear();
        grid.around(cells, cells_per_support, [&](int from, int to) {
            for (int k = from; k < to; ++k) near.candidate.push_back(k);
        });
        const auto candidates = static_cast<int>(near.candidate.size());
        near.reserve(near.candidate.size() + 1);
        const std::uint32_t asking = (1U << (end - first)) - (1U << (i - first));
        pair_kernels().select_near_slice(soil.x.data(), soil.y.data(),
                                         {first, asking, candidates, near.candidate.data()}, support2,
                                         {near.count.data(), near.column.data(), near.separation.data()});
        i = end;
    }
}

void PairFinder::find_wall(const Wall& wall, double x, double y, WallRow& row) const {
    row.merged.clear();
    row.sums = {};
    row.nearest_boundary = -1;
    find_near(wall, x, y, support2, row.near);
    if (row.near.count == 0) return;
    for (auto* field : {&row.gx, &row.gy, &row.stiffness, &row.kernel_value}) {
        if (field->size() < row.near.column.size()) field->resize(row.near.column.size());
    }
    pair_kernels().pair_geometry({row.near.count, row.near.dx.data(), row.near.dy.data(), row.gx.data(),
                                  row.gy.data(), row.stiffness.data(), row.kernel_value.data()},
                                 constants);
    merge(wall, row);
    sum(row);
}

}  // namespace runout
