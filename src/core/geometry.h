#pragma once

#include <vector>

#include "core/vec2.h"

namespace runout {

/// An open chain of points.
using Polyline = std::vector<Vec2>;

/// A simple polygon, counter-clockwise, the first point not repeated at the end.
using Polygon = std::vector<Vec2>;

}  // namespace runout
