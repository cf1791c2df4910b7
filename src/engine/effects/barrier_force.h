#pragma once

#include "core/geometry.h"

namespace runout {

/// What the soil does to a barrier, per metre of width. In the frame of the problem: x towards the run-out.
struct BarrierForce {
    Vec2 force{0, 0};    ///< N/m
    double moment = 0;   ///< about the foot of its face, N; positive: overturning towards the run-out
    Vec2 impulse{0, 0};  ///< of the force since release, N s/m
};

}  // namespace runout
