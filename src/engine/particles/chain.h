#pragma once

#include "core/geometry.h"

namespace runout {

// Chains of points whose x never decreases, such as a ground.

/// The part between two x, its ends included.
Polyline between(const Polyline& chain, double from, double to);

/// The chain with what lies between the ends of `piece` replaced by it.
Polyline replaced(const Polyline& chain, const Polyline& piece);

/// Area within an outline, m2; positive when it goes counter-clockwise.
double polygon_area(const Polygon& outline);

}  // namespace runout
