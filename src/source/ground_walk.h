#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/geometry.h"

namespace runout {

/// A point of the ground, known exactly: ground[segment] + fraction * (ground[segment + 1] -
/// ground[segment]).
struct GroundPoint {
    std::size_t segment = 0;
    double fraction = 0;  ///< 0 at the uphill end of the segment, 1 at the downhill end
};

/// A piece of one segment, walked from one fraction to another.
struct Stretch {
    std::size_t segment = 0;
    double from = 0;
    double to = 0;
};

/// The point, rounded once; a vertex exactly.
Vec2 position(const Polyline& ground, const GroundPoint& point);

/// Vertex `index` as the end of the segment downhill of it (of the last segment for the last vertex).
GroundPoint at_vertex(const Polyline& ground, std::size_t index);

/// The same point, seen as part of the segment uphill of it where it is a vertex.
GroundPoint on_segment_above(const GroundPoint& point);

/// The way along the ground from one point to another, in either direction, one stretch a segment.
std::vector<Stretch> walk(const GroundPoint& from, const GroundPoint& to);

/// First point at `elevation` (m above the toe) on the way; none when the way does not reach it.
std::optional<GroundPoint> first_at_elevation(const Polyline& ground, const std::vector<Stretch>& way,
                                              double elevation);

/// Elevation of the ground at x, which lies on the section; the upper one at a vertical face.
double elevation_at(const Polyline& ground, double x);

/// Inclination of a segment, radians, positive where it descends; pi/2 for a vertical face.
double inclination(const Polyline& ground, std::size_t segment);

/// Largest of width and height of the points: the scale against which rounding is judged.
double extent(const Polyline& points);

/// The point of a polyline that is nearest to `point`, and its distance, m.
Vec2 nearest(const Vec2& point, const Polyline& line);
double distance(const Vec2& point, const Polyline& line);

/// Without repeated points and points within `tolerance` of the straight line between those kept. Ends are
/// kept.
Polyline without_needless_points(const Polyline& line, double tolerance);
/// The same for a closed outline, whose first point has no privilege.
Polygon without_needless_corners(const Polygon& outline, double tolerance);

}  // namespace runout
