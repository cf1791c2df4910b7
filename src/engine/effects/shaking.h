#pragma once

#include "core/geometry.h"
#include "engine/effects.h"

namespace runout {

/// How the ground is accelerated: linear between the instants of a record, still after its end.
class GroundMotion {
  public:
    explicit GroundMotion(Shaking shaking) : shaking_(std::move(shaking)) {}

    /// Acceleration of the ground, m/s2, in the frame of the problem.
    [[nodiscard]] Vec2 acceleration(double time) const;
    /// When a record ends, s; 0 for a constant acceleration.
    [[nodiscard]] double ends() const { return shaking_.time.empty() ? 0.0 : shaking_.time.back(); }

  private:
    Shaking shaking_;
};

}  // namespace runout
