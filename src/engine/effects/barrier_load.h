#pragma once

#include <vector>

#include "engine/pairs/neighbours.h"
#include "engine/particles/bed_line.h"
#include "engine/particles/soil.h"
#include "engine/particles/wall.h"
#include "scene/effects.h"

namespace runout {

/// What the soil does to a barrier, per metre of width.
struct BarrierForce {
    Vec2 force{0, 0};    ///< N/m, x towards the run-out
    double moment = 0;   ///< about the foot of its face, overturning towards the run-out positive, N
    Vec2 impulse{0, 0};  ///< of the force since release, N s/m
};

/// Adds up the forces of the pairs between the soil and the barrier's part of the bed.
class BarrierLoad {
  public:
    /// `outline`: of the barrier, its points in the chain of the bed; see barrier_outline.
    BarrierLoad(const Polyline& outline, const BedLine& bed, const Wall& wall,
                const Discretisation& discretisation);

    /// For a bed that has changed elsewhere.
    void find_segments(const BedLine& bed, const Wall& wall);
    /// Once a step, after the pressure is known.
    void measure(const Neighbours& n, const Soil& soil, const Wall& wall, double dt);
    /// The guard of the wall took this impulse of a particle (kg m/s) from the soil at a segment of the bed.
    void add_guard_impulse(int segment, const Vec2& impulse);

    [[nodiscard]] const BarrierForce& now() const { return now_; }

  private:
    [[nodiscard]] bool is_barrier(int segment) const { return segment >= first_ && segment < first_ + 3; }

    Polyline outline_;
    double volume_;
    int first_ = 0;                 ///< segment of the bed that is the face
    std::vector<char> on_barrier_;  ///< per boundary particle
    Vec2 guard_{0, 0};              ///< impulse since the last measure
    BarrierForce now_;
};

}  // namespace runout
