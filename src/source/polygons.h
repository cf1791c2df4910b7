#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/geometry.h"
#include "source/ground_walk.h"

namespace runout {

/// A simple polygon whose corners are known exactly. Numbers are rounded only when they are read off, so that
/// a box on a face touches it without a gap, and areas are good to the last digit.
///
/// All of CGAL is behind this class: constructions and Boolean operations by its exact kernel.
class Region {
  public:
    struct Exact;  ///< the polygon in CGAL's terms
    explicit Region(std::shared_ptr<const Exact> exact);

    /// Corners, counter-clockwise, none of them on a straight line between its neighbours.
    [[nodiscard]] Polygon outline() const;
    /// m2
    [[nodiscard]] double area() const;
    /// Area above the straight line through `point` that rises uphill (towards -x) at `angle`, m2.
    [[nodiscard]] double area_above(const Vec2& point, double angle) const;
    /// Area of the part that lies in the ground, m2.
    [[nodiscard]] double area_in(const Polyline& ground) const;
    /// Area of what is neither ground nor region, and has some of the region above it, m2.
    [[nodiscard]] double air_below(const Polyline& ground) const;
    /// Whether a point of the ground lies exactly on the outline.
    [[nodiscard]] bool touches(const Polyline& ground, const GroundPoint& point) const;
    /// What is left of the ground when the region and all ground vertically above it have gone, from the
    /// uphill to the distal end. A region that only stands on the ground leaves it as it is. The region lies
    /// within the section.
    [[nodiscard]] Polyline bed_in(const Polyline& ground) const;

  private:
    std::shared_ptr<const Exact> exact_;
};

/// The point, rounded once, so that it equals the corner of a region that lies there.
Vec2 corner_at(const Polyline& ground, const GroundPoint& point);

/// Box whose base lies exactly on one segment of the ground, from `foot` uphill. Length and thickness are
/// multiples of the segment's length.
Region box_on_ground(const Polyline& ground, const GroundPoint& foot, double length, double thickness);

/// Box whose base rises from `foot` towards -x at `dip`; the thickness is normal to the base, on its upper
/// side. m.
Region box_at_dip(const Polyline& ground, const GroundPoint& foot, double dip, double length,
                  double thickness);

/// Two slip planes: the base rises from `exit` into the hill, the back scarp comes down from `top`; both are
/// on the ground. Angles above the horizontal, rising uphill; the scarp is steeper than the base and at most
/// vertical.
struct WedgeCut {
    GroundPoint exit;
    GroundPoint top;
    double base_angle = 0;
    double scarp_angle = 0;
};

/// The connected ground above the base and in front of the scarp that has `exit` on its outline; none when
/// there is no ground between them. It touches `top` as well unless the base comes out of the ground before
/// it meets the scarp; then it ends there, and moving `top` farther uphill adds nothing.
std::optional<Region> wedge(const Polyline& ground, const WedgeCut& cut);

/// None when the outline crosses or touches itself or has no area. Either orientation.
std::optional<Region> simple_polygon(const std::vector<Vec2>& corners);

/// The pieces of ground above a line (x never decreasing), largest first; none when the line doubles back on
/// itself.
std::optional<std::vector<Region>> ground_above(const Polyline& ground, const Polyline& line);

}  // namespace runout
