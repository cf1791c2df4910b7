#include "engine/pairs/operators.h"

#include <algorithm>
#include <cmath>

#include "engine/pairs/slipping_base.h"
#include "engine/threads/node_array.h"

namespace runout {

PairRows pair_rows(const PairBlock& block, const Neighbours& n) {
    const auto arrays = [](const PairBlock& b) {
        return PairArrays{b.column.data(), b.gx.data(), b.gy.data(), b.stiffness.data()};
    };
    const int rows = std::min(rows_per_block, n.first_boundary_node - block.first_row);
    const bool last = &block == &n.blocks.back();
    return {arrays(block), block.first_row, rows / lanes, block.offset,
            last ? PairArrays{} : arrays(*(&block + 1))};
}

void soil_velocities(const Neighbours& n, const Soil& soil, std::vector<FloatPair>& velocity) {
    set_rest(velocity, soil.count, n.nodes, FloatPair{});
    for (int i = 0; i < soil.count; ++i)
        velocity[i] = {static_cast<float>(soil.vx[i]), static_cast<float>(soil.vy[i])};
}

Vec2 pair_traction(const ParticleSystem& particles, const WallPair& pair) {
    const Soil& soil = particles.soil;
    const Wall& wall = particles.wall;
    const double p = soil.pressure[pair.row] + wall.pressure[pair.wall_index];
    double sxx = soil.sxx[pair.row] + wall.sxx[pair.wall_index];
    double sxy = soil.sxy[pair.row] + wall.sxy[pair.wall_index];
    if (wall.slips_at(pair.wall_index)) {
        const double factor = traction_factor(soil.pressure[pair.row], wall.pressure[pair.wall_index]);
        sxx = factor * wall.sxx[pair.wall_index];
        sxy = factor * wall.sxy[pair.wall_index];
    }
    return {(p + sxx) * pair.gx + sxy * pair.gy, sxy * pair.gx + (p - sxx) * pair.gy};
}

Vec2 bed_force(const ParticleSystem& particles, double volume) {
    Vec2 force{0, 0};
    for (const PairBlock& block : particles.neighbours.blocks)
        for (const WallPair& pair : block.wall_pairs) force += pair_traction(particles, pair);
    return volume * force;
}

std::vector<double> strain_rates(const ParticleSystem& particles) {
    const Neighbours& n = particles.neighbours;
    std::vector<FloatPair> velocity;
    soil_velocities(n, particles.soil, velocity);
    std::vector<double> rate(particles.soil.count, 0.0);
    for (const PairBlock& block : n.blocks) {
        for_each_velocity_gradient(block, n, velocity.data(), [&](int i, const VelocityGradient& plain) {
            const VelocityGradient g = plain.corrected(n, i);
            rate[i] = std::hypot(g.exx(), g.exy());
        });
    }
    return rate;
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
