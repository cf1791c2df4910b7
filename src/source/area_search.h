#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "source/ground_walk.h"

namespace runout {

/// The point on the way at which `area_of` reaches `target`: to 1e-14 of it, or as near as the fraction's
/// last digit allows. `area_of` grows along the way. None when it stays below the target to the end of the
/// way.
std::optional<GroundPoint> point_with_area(const std::vector<Stretch>& way,
                                           const std::function<double(const GroundPoint&)>& area_of,
                                           double target);

}  // namespace runout
