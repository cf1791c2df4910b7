#pragma once

#include <vector>

#include "core/geometry.h"
#include "engine/particles/mass.h"

namespace runout {

/// Particles that fill a mass.
struct Packing {
    std::vector<Vec2> points;  ///< m
    double spacing = 0;        ///< effective dl: count * spacing^2 = area of the mass, to rounding, m
};

/// Fills the mass with about area / spacing^2 particles on a lattice along its base, then lets them settle
/// into even density against a shell around the outline, so that no particle starts squeezed in a corner. A
/// rectangle gets a lattice stretched to fit and needs no settling. A `seed` other than 0 moves the particles
/// off the lattice at random, by up to a quarter of a spacing each way, before they settle.
Packing pack_mass(const Mass& mass, double spacing, double smoothing_ratio, int seed = 0);

}  // namespace runout
