#pragma once

#include "engine/pairs/operators.h"
#include "engine/pairs/particle_system.h"

namespace runout {

/// Plain velocity gradient at soil particle `row` of the block with no slip on the bed line itself. To
/// friction the bed is particles at rest, the first of them half a spacing behind the line, which makes no
/// difference while strength does not depend on the rate. Where it does, the flow would slip on the line and
/// the rate next to it would come out too small. So the particle sees the bed move against it in proportion
/// to the distance from the line (Morris, Fox & Zhu 1997): exact for a velocity that is linear and 0 on the
/// line. `plain`: with the bed at rest, and what is returned where no bed is near; distances below a quarter
/// of a spacing count as that.
VelocityGradient gradient_without_slip(const ParticleSystem& particles, const PairBlock& block, int row,
                                       const VelocityGradient& plain, double spacing);

}  // namespace runout
