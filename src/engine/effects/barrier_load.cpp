#include "engine/effects/barrier_load.h"

namespace runout {

BarrierLoad::BarrierLoad(const Polyline& outline, const BedLine& bed, const Wall& wall,
                         const Discretisation& discretisation)
    : outline_(outline), volume_(discretisation.volume()) {
    find_segments(bed, wall);
}

void BarrierLoad::find_segments(const BedLine& bed, const Wall& wall) {
    for (int s = 0; s < bed.segments(); ++s)
        if (bed.start(s) == outline_.front()) first_ = s;
    on_barrier_.clear();
    for (int b = 0; b < wall.boundary_count; ++b) on_barrier_.push_back(is_barrier(wall.segment[b]) ? 1 : 0);
}

void BarrierLoad::measure(const Neighbours& n, const Soil& soil, const Wall& wall, double dt) {
    Vec2 total{0, 0};
    double moment = 0.0;
    for (const PairBlock& block : n.blocks) {
        for (const WallPair& pair : block.wall_pairs) {
            if (on_barrier_[pair.boundary] == 0) continue;
            const double p = soil.pressure[pair.row] + wall.pressure[pair.boundary];
            const double sxx = soil.sxx[pair.row] + wall.sxx[pair.boundary];
            const double sxy = soil.sxy[pair.row] + wall.sxy[pair.boundary];
            const Vec2 force{volume_ * ((p + sxx) * pair.gx + sxy * pair.gy),
                             volume_ * (sxy * pair.gx + (p - sxx) * pair.gy)};
            const Vec2 arm = Vec2{wall.x[pair.boundary], wall.y[pair.boundary]} - outline_.front();
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
