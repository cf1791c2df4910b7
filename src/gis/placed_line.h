#pragma once

#include <limits>
#include <optional>
#include <string>

#include "core/section_point.h"
#include "gis/map_line.h"

namespace runout {

/// Where a section lies that comes without a map: one place on it, and which way it goes.
struct LinePlacing {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    std::string crs{};              ///< coordinate system, "EPSG:2326"
    Vec2 origin{unknown, unknown};  ///< the place of `origin_chainage`
    Chainage origin_chainage{0};
    double bearing = unknown;       ///< rad clockwise from grid north, towards increasing chainage
    std::optional<Vec2> towards{};  ///< instead of a bearing: another place on the line, in that direction
};

/// The straight line from one chainage to another, in true metres also where the scale factor of the system
/// is not 1. Throws InputError that names the key of a case: an unknown system, degrees that are none, a
/// place where the system does not hold, two places that are one.
MapLine placed_line(const LinePlacing& placing, Chainage from, Chainage to);

}  // namespace runout
