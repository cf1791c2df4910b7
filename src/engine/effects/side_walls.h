#pragma once

#include "engine/effects.h"
#include "engine/particles/discretisation.h"
#include "engine/particles/soil.h"

namespace runout {

/// Coulomb friction of two parallel walls, W apart. Each particle loses 2 p' tan(delta) dt / (rho W) of its
/// speed, and never more than it has. p' is the mean stress less the pore pressure: soil at yield in plane
/// strain presses with it across the channel. `pore_pressure`: per node, Pa; null: dry. Returns the energy
/// taken, J/kg summed over the particles.
double brake_by_side_walls(const SideWalls& walls, const Discretisation& discretisation,
                           const std::vector<double>* pore_pressure, double dt, Soil& soil);

}  // namespace runout
