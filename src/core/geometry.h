#pragma once

#include <Eigen/Core>
#include <vector>

namespace runout {

/// A point or vector in the plane of the section, SI units.
using Vec2 = Eigen::Vector2d;

/// An open chain of points.
using Polyline = std::vector<Vec2>;

/// A simple polygon, counter-clockwise, the first point not repeated at the end.
using Polygon = std::vector<Vec2>;

}  // namespace runout
