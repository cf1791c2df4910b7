#pragma once

#include "profile/section_points.h"

namespace runout {

// Ground lies between these; what does not is a value that stands for "no data", or another unit.
constexpr double lowest_ground_m = -500;
constexpr double highest_ground_m = 9000;
constexpr double greatest_step_m = 1000;  ///< between two neighbouring points

/// Refuses elevations that no ground has, so that no hole in the data becomes a cliff. Throws InputError,
/// with line (or number of the point where a file has no lines), chainage and value: an elevation that is no
/// number or outside [lowest_ground_m, highest_ground_m], a rise or fall of more than greatest_step_m
/// between two neighbouring points.
void check_elevations(const SectionPoints& section);

}  // namespace runout
