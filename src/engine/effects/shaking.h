#pragma once

#include "core/geometry.h"
#include "engine/effects/effects.h"

namespace runout {

/// How the ground is accelerated, and what that does to soil seen from the ground. Linear between the
/// instants of a record; still after its end.
class GroundMotion {
  public:
    explicit GroundMotion(Shaking shaking) : shaking_(std::move(shaking)) {}

    /// m/s2, in the local frame.
    [[nodiscard]] Vec2 acceleration(double time) const;
    /// Instant after which a record has nothing more to say, s; 0 for a constant coefficient.
    [[nodiscard]] double ends() const { return shaking_.time.empty() ? 0.0 : shaking_.time.back(); }

  private:
    Shaking shaking_;
};

}  // namespace runout
