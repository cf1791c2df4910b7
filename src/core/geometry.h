#pragma once

#include <vector>

#include "core/vec2.h"

namespace runout {

/// An open chain of two or more points, m.
using Polyline = std::vector<Vec2>;

/// A simple polygon of three or more corners, m: counter-clockwise, the first not repeated at the end.
using Polygon = std::vector<Vec2>;

}  // namespace runout
