#pragma once

#include <vector>

#include "profile/section_points.h"

namespace runout {

/// Points nearer to each other than this are one, m.
constexpr double nearest_points_m = 1e-7;

/// The points of a section, of rising chainage, a vertical face as two points of one chainage. Throws
/// InputError that names the line: fewer than two points, a coordinate that is not finite or beyond 1e8 m, an
/// overhang, a repeated point (within nearest_points_m), a step up and down at one chainage.
std::vector<Vec2> checked_points(const SectionPoints& section);

}  // namespace runout
