#pragma once

#include <algorithm>

#include "engine/pairs/neighbours.h"
#include "engine/particles/wall.h"
#include "engine/simd/pair_kernels.h"

namespace runout {

// Where the base is weaker than the soil (Wall::slips), the soil slides on it as on a plane. The stress of
// the wall alone carries the traction, and the soil above keeps its own strength. Were that soil to yield
// like the base, it would be a weak layer as thick as the kernel's reach: it flows out from under a mass that
// the base holds, which then comes down grain by grain.

/// What the stress of the wall is multiplied by to carry the whole traction of a pair. Traction and normal
/// force (p_i + p_b) then have the ratio of the wall's stress and pressure. Soil that presses more than the
/// wall beneath it does so for an instant only, and counts as much as the wall: friction would shake with it.
/// Pressures in Pa.
inline double traction_factor(double soil_pressure, double wall_pressure) {
    const double pressing = std::max(0.0, soil_pressure);  // cohesive soil may pull
    return wall_pressure > pressing ? 1.0 + pressing / wall_pressure : 2.0;
}

/// The stress of each node and the pressure that bounds it, Pa.
struct NodeStress {
    const FloatPair* deviatoric = nullptr;
    const double* pressure = nullptr;
};

/// Takes out of the velocity gradients of the rows what their pairs with a slipping base put in: slip is no
/// strain of the soil. `velocity`: per node, m/s.
void leave_out_slip(const PairRows& rows, const Neighbours& n, const Wall& wall, const FloatPair* velocity,
                    VelocityGradients& gradients);

/// In `force`, the divergence of the stress, puts s_b of the wall times traction_factor in place of s_i + s_b
/// for the pairs of the rows with a slipping base.
void carry_by_wall(const PairRows& rows, const Neighbours& n, const Wall& wall, const NodeStress& stress,
                   FloatPair* force);

}  // namespace runout
