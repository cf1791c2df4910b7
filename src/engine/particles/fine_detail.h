#pragma once

#include "core/geometry.h"

namespace runout {

/// The chain as particles of this spacing can meet it: where its points stand closer than two spacings, those
/// are left out that lie within a quarter of a spacing of the straight way past them. Particles cannot follow
/// teeth finer than themselves, and would skip from one to the next as on ice. The ends stay.
Polyline without_fine_detail(const Polyline& chain, double spacing);

}  // namespace runout
