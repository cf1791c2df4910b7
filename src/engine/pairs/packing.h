#pragma once

#include <vector>

#include "core/geometry.h"
#include "engine/mass.h"

namespace runout {

/// Particles that fill a mass.
struct Packing {
    std::vector<Vec2> points;  ///< one per particle, m
    double spacing = 0;  ///< effective dl, m: number of points x spacing^2 = area of the mass, to rounding
};

/// Fills the mass with about area / spacing^2 particles, at least one. They stand on a lattice along the base
/// of the mass, and then settle into even density within its outline, so that no particle starts squeezed in
/// a corner. A rectangle gets a lattice stretched to fit and needs no settling.
///
/// `spacing`: wanted dl, m; `smoothing_ratio`: h/dl. A `seed` other than 0 moves the particles off the
/// lattice at random, by up to a quarter of a spacing each way, before they settle: the same way for the same
/// seed on every machine.
Packing pack_mass(const Mass& mass, double spacing, double smoothing_ratio, int seed = 0);

}  // namespace runout
