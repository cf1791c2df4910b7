#pragma once

#include "core/geometry.h"

namespace runout {

/// What the soil does to a barrier, per metre of width.
struct BarrierForce {
    Vec2 force{0, 0};    ///< N/m, x towards the run-out
    double moment = 0;   ///< about the foot of its face, overturning towards the run-out positive, N
    Vec2 impulse{0, 0};  ///< of the force since release, N s/m
};

}  // namespace runout
