#pragma once

#include "core/elevation_limits.h"
#include "profile/section_points.h"

namespace runout {

constexpr double greatest_step_m = 1000;  ///< between two neighbouring points

/// Refuses elevations that no ground has, so that no hole in the data becomes a cliff. Throws InputError,
/// with line (or number of the point where a file has no lines), chainage and value: an elevation that is no
/// number or outside of core/elevation_limits.h, a rise or fall of more than greatest_step_m
/// between two neighbouring points.
void check_elevations(const SectionPoints& section);

}  // namespace runout
