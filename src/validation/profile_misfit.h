#pragma once

#include <vector>

#include "core/geometry.h"
#include "measures/measures.h"

namespace runout {

/// Surface of a deposit: chainage and elevation by top, m.
std::vector<Vec2> deposit_surface(const std::vector<DepositRow>& deposit);

/// The same from particles: the highest in bins of two spacings; grains that touch no other are left out.
std::vector<Vec2> snapshot_surface(const Snapshot& snapshot, double spacing);

/// For drawing: the surface from the wall at x = 0 and down to the level bed half a bin behind its last
/// point.
std::vector<Vec2> drawn_to_bed(std::vector<Vec2> surface, double spacing);

/// Height of a line at x: linear between its points, level before the first, down to zero `tail` after the
/// last.
double height_at(const std::vector<Vec2>& line, double x, double tail);

/// A line and the distance behind its last point at which it has come down to zero.
struct Surface {
    std::vector<Vec2> points;
    double tail = 0;
};

/// Integral of |a - b| over 0 <= x <= end, m2.
double area_between(const Surface& a, const Surface& b, double end);

}  // namespace runout
