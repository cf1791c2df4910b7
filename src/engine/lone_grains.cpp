#include "engine/lone_grains.h"

#include <algorithm>

namespace runout {

Vec2 velocity_on_bed(const LoneGrain& grain, const Vec2& gain, double dt) {
    const Vec2 free = grain.velocity + gain;
    const double approach = free.dot(grain.normal);
    // What is left of the clearance may be used up, and no more.
    const double allowed = std::max(approach, -std::max(0.0, grain.clearance) / dt);
    const double impulse = allowed - approach;
    if (impulse <= 0.0) return free;
    const Vec2 slip = free - approach * grain.normal;
    const double speed = slip.norm();
    const double kept = speed > 0.0 ? std::max(0.0, 1.0 - grain.strength * impulse / speed) : 0.0;
    return kept * slip + allowed * grain.normal;
}

}  // namespace runout
