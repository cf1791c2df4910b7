#pragma once

#include <vector>

#include "profile/profile.h"

namespace runout {

/// Chainages and elevations in metres of a line that has elevations of its own; a vertical face keeps its
/// points. Throws InputError that names the feature, and the vertex with its place: a line without
/// elevations, or whose heights are counted from the ground; a vertex without one, or with a value that is no
/// elevation; a lone 0 among others, unless `section.zero_is_ground`.
std::vector<Vec2> line_elevations(const MapSection& section, const SectionLine& line);

}  // namespace runout
