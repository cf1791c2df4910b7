#pragma once

#include "core/geometry.h"

namespace runout {

/// The rigid bed as a chain of straight segments. Soil is on the left of the direction of travel: above, when
/// the chain runs downhill towards +x.
class BedLine {
  public:
    /// Through `points`, m, at least two and no two that follow each other equal. Closed: the last is joined
    /// to the first. An open chain has x that never decreases. None of this is checked.
    explicit BedLine(Polyline points, bool closed = false);

    /// Where a point is nearest to the chain.
    struct Nearest {
        double distance = 0;  ///< signed: positive on the soil's side and beyond a free end, m
        Vec2 normal{0, 1};    ///< unit, into the soil's side, at the nearest point
        int segment = 0;      ///< that it is on, from 0
    };

    /// Nearest point of the whole chain.
    [[nodiscard]] Nearest nearest(const Vec2& point) const;
    /// Nearest point among `segment` and the `reach` segments to either side of it along the chain.
    [[nodiscard]] Nearest nearest(const Vec2& point, int segment, int reach) const;

    /// For a point far from the bed: quick, since the segment is found by bisection. Below an open chain the
    /// nearest point of all; above it, beyond its ends or for a closed chain an infinite distance.
    [[nodiscard]] Nearest below(double x, double y) const;

    /// How many segments there are.
    [[nodiscard]] int segments() const {
        return static_cast<int>(closed_ ? points_.size() : points_.size() - 1);
    }
    /// Where a segment begins, m.
    [[nodiscard]] Vec2 start(int segment) const { return points_[static_cast<std::size_t>(segment)]; }
    /// Where a segment ends, m.
    [[nodiscard]] Vec2 end(int segment) const {
        return points_[static_cast<std::size_t>(segment + 1) % points_.size()];
    }
    /// Unit normal of a segment, into the soil's side.
    [[nodiscard]] Vec2 normal(int segment) const;
    /// The points that it was made from, m.
    [[nodiscard]] const Polyline& points() const { return points_; }
    /// Whether the last point is joined to the first.
    [[nodiscard]] bool closed() const { return closed_; }

    /// Elevation of an open chain at x, m. Where a vertical face stands it is that of the highest point
    /// there; beyond an end it is that of the end.
    [[nodiscard]] double elevation(double x) const;

  private:
    Polyline points_;
    bool closed_;
};

}  // namespace runout
