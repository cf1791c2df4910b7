#pragma once

#include "core/geometry.h"

namespace runout {

/// Soil that comes down in one piece, and the ground that it leaves.
struct Mass {
    Polygon outline{};  ///< m
    Polyline bed{};     ///< from the uphill end to the distal end, x never decreases, m
    double area = 0;    ///< within the outline, m2
};

}  // namespace runout
