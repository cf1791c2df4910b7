#pragma once

#include "core/geometry.h"

namespace runout {

/// The rigid bed as a chain of segments with soil on the left of the direction of travel (above, when the
/// chain runs downhill towards +x).
class BedLine {
  public:
    explicit BedLine(Polyline points, bool closed = false);

    struct Nearest {
        double distance = 0;  ///< signed: positive on the soil's side and beyond a free end, m
        Vec2 normal{0, 1};    ///< unit, into the soil's side, at the nearest point
        int segment = 0;
    };

    /// Nearest point of the whole chain.
    [[nodiscard]] Nearest nearest(const Vec2& point) const;
    /// Nearest point among the segments within `reach` of `segment` (chain order).
    [[nodiscard]] Nearest nearest(const Vec2& point, int segment, int reach) const;

    /// For a point away from the bed: found below an open chain, and nothing near (at an infinite distance)
    /// above it. Finds the segment by bisection.
    [[nodiscard]] Nearest below(double x, double y) const;

    [[nodiscard]] int segments() const {
        return static_cast<int>(closed_ ? points_.size() : points_.size() - 1);
    }
    [[nodiscard]] Vec2 start(int segment) const { return points_[static_cast<std::size_t>(segment)]; }
    [[nodiscard]] Vec2 end(int segment) const {
        return points_[static_cast<std::size_t>(segment + 1) % points_.size()];
    }
    /// Unit normal of a segment, into the soil's side.
    [[nodiscard]] Vec2 normal(int segment) const;
    [[nodiscard]] const Polyline& points() const { return points_; }
    [[nodiscard]] bool closed() const { return closed_; }

    /// Bed elevation at x for an open chain: the highest point where a vertical face stands; clamped beyond
    /// the ends.
    [[nodiscard]] double elevation(double x) const;

  private:
    Polyline points_;
    bool closed_;
};

}  // namespace runout
