#include "engine/effects/barrier.h"

#include <algorithm>
#include <cmath>

#include "engine/pairs/operators.h"
#include "engine/particles/bed_line.h"

namespace runout {

Polyline barrier_outline(const Polyline& ground, const Barrier& barrier) {
    const BedLine line(ground);
    const Vec2 foot{barrier.x, line.elevation(barrier.x)};
    // cos / sin and not 1 / tan: a vertical face is vertical to the last digit.
    const double lean = barrier.height * std::cos(barrier.inclination) / std::sin(barrier.inclination);
    const Vec2 front = foot + Vec2{std::abs(lean) < 1e-12 * barrier.height ? 0.0 : lean, barrier.height};
    const Vec2 back = front + Vec2{barrier.thickness, 0.0};
    return {foot, front, back, {back.x(), std::min(back.y(), line.elevation(back.x()))}};
}

BarrierLoad::BarrierLoad(const Polyline& outline, const Wall& wall, const Discretisation& discretisation)
    : outline_(outline), volume_(discretisation.volume()) {
    find_segments(wall);
}

void BarrierLoad::find_segments(const Wall& wall) {
    for (int s = 0; s < wall.bed_line.segments(); ++s)
        if (wall.bed_line.start(s) == outline_.front()) first_ = s;
    on_barrier_.clear();
    for (int b = 0; b < wall.boundary_count; ++b) on_barrier_.push_back(is_barrier(wall.segment[b]) ? 1 : 0);
}

void BarrierLoad::measure(const ParticleSystem& particles, double dt) {
    const Wall& wall = particles.wall;
    Vec2 total{0, 0};
    double moment = 0.0;
    for (const PairBlock& block : particles.neighbours.blocks) {
        for (const WallPair& pair : block.wall_pairs) {
            if (on_barrier_[pair.wall_index] == 0) continue;
            const Vec2 force = volume_ * pair_traction(particles, pair);
            const Vec2 arm = Vec2{wall.x[pair.wall_index], wall.y[pair.wall_index]} - outline_.front();
            total += force;
            moment += arm.y() * force.x() - arm.x() * force.y();
        }
    }
    now_.force = total + guard_ / dt;
    now_.moment = moment;
    now_.impulse += dt * total + guard_;
    guard_ = {0, 0};
}

void BarrierLoad::add_guard_impulse(int segment, const Vec2& impulse) {
    if (is_barrier(segment)) guard_ += impulse;
}

}  // namespace runout
