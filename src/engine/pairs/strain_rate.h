#pragma once

#include "engine/pairs/neighbours.h"
#include "engine/pairs/operators.h"
#include "engine/particles/bed_line.h"
#include "engine/particles/soil.h"

namespace runout {

/// Plain velocity gradient at soil particle `row` of the block, 1/s, with no slip on the bed line itself.
///
/// For friction the bed is particles at rest, the first of them half a spacing behind the line. That makes no
/// difference while strength does not depend on the rate. Where it does, the flow would slip on the line, and
/// the rate next to it would come out too small. So the wall's particles are given a velocity against that of
/// the soil, in proportion to their distance from the line (Morris, Fox & Zhu 1997). This is exact for a
/// velocity that is linear and 0 on the line.
///
/// `plain`: the gradient with the bed at rest, 1/s; `near`: the bed's nearest point to the particle; a
/// distance below a quarter of a spacing counts as a quarter.
VelocityGradient gradient_without_slip(const PairBlock& block, const Neighbours& n, const Soil& soil, int row,
                                       const VelocityGradient& plain, const BedLine::Nearest& near,
                                       double spacing);

}  // namespace runout
