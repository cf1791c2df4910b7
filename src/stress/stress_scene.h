#pragma once

#include <string>

#include "profile/profile.h"
#include "scene/scene.h"
#include "source/source.h"
#include "stress/stress_point.h"

namespace runout {

/// Where the mass of a random scene comes from. A sliver is a type B whose base is within a degree of the
/// face; a sheet a box 20 to 50 times as long as thick; a column stands at the foot of a vertical wall; a
/// block starts in the air, its lower edge at the drop height.
enum class SourceKind { rectangle, a, b, c, sliver, sheet, column, falling_block, count };

std::string to_string(SourceKind kind);

/// Ground and source of a random scene, before any check, as a case would give them.
struct StressSite {
    Polyline section;  ///< chainage and elevation, m
    ProfileOptions face;
    SourceSpec source;
    bool free = false;  ///< the mass starts as a column or a block of its own, which no case may say
};

StressSite stress_site(const StressPoint& point);

/// The scene of a point, on a section long enough for the mass to stop on by its energy line. Throws
/// InputError where the mass does not fit the hillside, as it would for a user.
Scene stress_scene(const StressPoint& point, const std::string& name);

}  // namespace runout
