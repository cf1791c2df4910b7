#pragma once

#include <vector>

#include "engine/particles/kernel.h"
#include "source/source.h"

namespace runout {

/// Particles that fill the source.
struct Packing {
    std::vector<double> x, y;  ///< m
    double spacing = 0;        ///< effective dl: count * spacing^2 = area of the source, to rounding, m
};

/// Fills the source with about area / spacing^2 particles on a lattice along its base, then lets them settle
/// into even density against a shell around the outline, so that no particle starts squeezed in a corner. A
/// rectangle gets a lattice stretched to fit and needs no settling. A `seed` other than 0 moves the particles
/// off the lattice at random, by up to a quarter of a spacing each way, before they settle.
Packing pack_source(const Source& source, double spacing, double smoothing_ratio, int seed = 0);

}  // namespace runout
