#include "engine/friction/velocity_filter.h"

#include "engine/pairs/operators.h"
#include "engine/pairs/strain_rate.h"
#include "engine/threads/node_array.h"

namespace runout {

void VelocityFilter::find_gradients(const ParticleSystem& particles) {
    const Neighbours& n = particles.neighbours;
    const Soil& soil = particles.soil;
    soil_velocities(n, soil, velocity_);
    set_all(gradient_, soil.count, VelocityGradient{});
    for (const PairBlock& block : n.blocks) {
        for_each_velocity_gradient(block, n, velocity_.data(), [&](int i, const VelocityGradient& plain) {
            gradient_[i] =
                gradient_without_slip(particles, block, i, plain, discretisation_.spacing).corrected(n, i);
        });
    }
}

void VelocityFilter::find_change(const PairBlock& block, const Neighbours& n, const Soil& soil) {
    for_each_pair(block, n, [&](int i, int j, int k) {
        if (j >= n.soil_count) return;
        const VelocityGradient& a = gradient_[i];
        const VelocityGradient& b = gradient_[j];
        const double dx = soil.x[j] - soil.x[i];
        const double dy = soil.y[j] - soil.y[i];
        change_[i] += static_cast<double>(block.stiffness[k]) *
                      Vec2{soil.vx[j] - soil.vx[i] - 0.5 * ((a.xx + b.xx) * dx + (a.xy + b.xy) * dy),
                           soil.vy[j] - soil.vy[i] - 0.5 * ((a.yx + b.yx) * dx + (a.yy + b.yy) * dy)};
    });
}

double VelocityFilter::apply(ParticleSystem& particles) {
    const Neighbours& n = particles.neighbours;
    Soil& soil = particles.soil;
    find_gradients(particles);
    change_.assign(static_cast<std::size_t>(soil.count), Vec2{0, 0});
    for (const PairBlock& block : n.blocks) find_change(block, n, soil);
    double taken = 0.0;
    for (int i = 0; i < soil.count; ++i) {
        if (n.is_asleep(i)) continue;
        const Vec2 before{soil.vx[i], soil.vy[i]};
        const Vec2 after = before + fraction_ / discretisation_.lattice_stiffness * change_[i];
        soil.vx[i] = after.x();
        soil.vy[i] = after.y();
        taken += 0.5 * (before.squaredNorm() - after.squaredNorm());
    }
    return taken;
}

}  // namespace runout
