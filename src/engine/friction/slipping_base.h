#pragma once

#include "engine/pairs/neighbours.h"
#include "engine/particles/wall.h"
#include "engine/simd/pair_kernels.h"

namespace runout {

// Where the base is weaker than the soil (Wall::slips), the soil slides on it as on a plane. The stress of
// the wall alone carries the traction, and the soil above keeps its own strength. Were that soil to yield
// like the base, it would be a weak layer as thick as the kernel's reach: it flows out from under a mass that
// the base holds, which then comes down grain by grain.

/// Takes out of the velocity gradients of the rows what their pairs with a slipping base put in: slip is no
/// strain of the soil. `velocity`: per node, m/s.
void leave_out_slip(const PairRows& rows, const Neighbours& n, const Wall& wall, const FloatPair* velocity,
                    VelocityGradients& gradients);

/// In `force`, the divergence of `stress` (per node, Pa), puts 2 s_b of the wall in place of s_i + s_b for
/// the pairs of the rows with a slipping base.
void carry_by_wall(const PairRows& rows, const Neighbours& n, const Wall& wall, const FloatPair* stress,
                   FloatPair* force);

}  // namespace runout
