#pragma once

#include "engine/pairs/operators.h"
#include "engine/pairs/particle_system.h"

namespace runout {

/// Plain velocity gradient at soil particle `row` of the block, 1/s, with no slip on the bed line itself.
///
/// For friction the bed is particles at rest, the first of them half a spacing behind the line. That makes no
/// difference while strength does not depend on the rate. Where it does, the flow would slip on the line, and
/// the rate next to it would come out too small. So the wall's particles are given a velocity against that of
/// the soil, in proportion to their distance from the line (Morris, Fox & Zhu 1997). This is exact for a
/// velocity that is linear and 0 on the line.
///
/// `plain`: the gradient with the bed at rest, 1/s; it is returned where no bed is near. A distance below a
/// quarter of a spacing counts as a quarter.
VelocityGradient gradient_without_slip(const ParticleSystem& particles, const PairBlock& block, int row,
                                       const VelocityGradient& plain, double spacing);

}  // namespace runout
