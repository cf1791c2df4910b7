#pragma once

#include <vector>

#include "engine/effects/barrier_force.h"
#include "engine/effects/effects.h"
#include "engine/pairs/particle_system.h"

namespace runout {

/// Outline of the barrier from the foot of its face over its top to its back.
Polyline barrier_outline(const Polyline& ground, const Barrier& barrier);

/// Adds up the forces of the pairs between the soil and the barrier's part of the bed.
class BarrierLoad {
  public:
    /// `outline`: of the barrier, its points in the chain of the bed; see barrier_outline.
    BarrierLoad(const Polyline& outline, const Wall& wall, const Discretisation& discretisation);

    /// For a bed that has changed elsewhere.
    void find_segments(const Wall& wall);
    /// Once a step, after the pressure is known.
    void measure(const ParticleSystem& particles, double dt);
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
