#pragma once

#include "core/geometry.h"

namespace runout {

/// Soil that comes down in one piece, and the ground that it leaves. In a plane frame, y upwards, x towards
/// the run-out.
struct Mass {
    Polygon outline{};  ///< corners, counter-clockwise, m
    Polyline ground{};  ///< what it leaves, from the uphill to the distal end; x never decreases, m
    double area = 0;    ///< within the outline, m2; must be that of the outline
};

}  // namespace runout
