#pragma once

#include "engine/effects/effects.h"
#include "engine/particles/kernel.h"
#include "engine/particles/soil.h"

namespace runout {

/// Coulomb friction of two parallel walls, distance W apart: each particle loses 2 p' tan(delta) dt / (rho W)
/// of its speed, and never more than it has. Across the channel soil at yield in plane strain presses with
/// its mean stress p', less the pore pressure (per node, null: dry). Returns the energy it took, J/kg summed
/// over the particles.
double brake_by_side_walls(const SideWalls& walls, const Discretisation& discretisation,
                           const std::vector<double>* pore_pressure, double dt, Soil& soil);

}  // namespace runout
