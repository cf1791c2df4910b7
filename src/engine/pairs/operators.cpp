#include "engine/pairs/operators.h"

#include <algorithm>

#include "engine/threads/node_array.h"

namespace runout {

PairRows pair_rows(const PairBlock& block, const Neighbours& n) {
    const auto arrays = [](const PairBlock& b) {
        return PairArrays{b.column.data(), b.gx.data(), b.gy.data(), b.stiffness.data()};
    };
    const int rows = std::min(rows_per_block, n.first_boundary - block.first_row);
    const bool last = &block == &n.blocks.back();
    return {arrays(block), block.first_row, rows / lanes, block.offset,
            last ? PairArrays{} : arrays(*(&block + 1))};
}

void soil_velocities(const Neighbours& n, const Soil& soil, std::vector<FloatPair>& velocity) {
    set_rest(velocity, soil.count, n.nodes, FloatPair{});
    for (int i = 0; i < soil.count; ++i)
        velocity[i] = {static_cast<float>(soil.vx[i]), static_cast<float>(soil.vy[i])};
}

VelocityGradient boundary_velocity_gradient(const Neighbours& n, int a, const FloatPair* velocity) {
    VelocityGradient g;
    for (int k = n.boundary_start[a]; k < n.boundary_start[a + 1]; ++k) {
        const BoundaryPair& pair = n.boundary_pairs[k];
        g.xx += static_cast<double>(velocity[pair.soil].x) * pair.own_gx;
        g.xy += static_cast<double>(velocity[pair.soil].x) * pair.own_gy;
        g.yx += static_cast<double>(velocity[pair.soil].y) * pair.own_gx;
        g.yy += static_cast<double>(velocity[pair.soil].y) * pair.own_gy;
    }
    return g;
}

}  // namespace runout
