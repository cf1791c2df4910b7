#pragma once

#include "core/geometry.h"
#include "scene/effects.h"

namespace runout {

/// The rigid bed under this ground with what the effects make of it: lowered by the erodible layer, with the
/// barrier on it. The ground itself where there is neither.
Polyline shape_bed(const Polyline& ground, const Effects& effects);

/// The same effects with the erodible layer as deep as the nearest whole number of particles, at least one: a
/// layer of one and a half would start squeezed.
Effects with_whole_layers(Effects effects, double spacing);

/// Outline of the erodible layer, counter-clockwise: between the ground and the same lowered by its depth.
Polygon layer_outline(const Polyline& ground, const ErodibleBed& layer);

/// Outline of the barrier from the foot of its face over its top to its back.
Polyline barrier_outline(const Polyline& ground, const Barrier& barrier);

/// Area within an outline, m2; positive when it goes counter-clockwise.
double polygon_area(const Polygon& outline);

}  // namespace runout
