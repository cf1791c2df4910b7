#pragma once

#include "core/geometry.h"

namespace runout {

/// How a polygon lies to the ground; exact areas, rounded once, m2.
struct PolygonPlace {
    double area = 0;
    double in_ground = 0;  ///< part of it
    double air_below = 0;  ///< between its underside and the ground
};

/// `outline` is simple and lies over the section; the ground goes from its uphill to its distal end.
PolygonPlace polygon_place(const Polyline& ground, const Polygon& outline);

}  // namespace runout
