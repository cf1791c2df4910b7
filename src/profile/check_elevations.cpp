#include "profile/check_elevations.h"

#include <fmt/format.h>

#include <cmath>

#include "core/input_error.h"

namespace runout {
namespace {

constexpr const char* what_to_give =
    "if it stands for missing data, leave the point out where the ground between its neighbours is straight, "
    "or survey it; if not, check the unit and the column";

std::string chainage_text(const SectionPoints& section, std::size_t i) {
    const std::string number = section.lines.empty() ? fmt::format("point {}, ", i + 1) : "";
    return fmt::format("{}chainage {:.10g} m", number, section.points[i].x());
}

InputPlace place_of(const SectionPoints& section, std::size_t i) {
    const int line = i < section.lines.size() ? section.lines[i] : 0;
    return {section.origin, line, fmt::format("{}, elevation_m", chainage_text(section, i)),
            fmt::format("{:.10g}", section.points[i].y())};
}

}  // namespace

void check_elevations(const SectionPoints& section) {
    for (std::size_t i = 0; i < section.points.size(); ++i) {
        const double elevation = section.points[i].y();
        if (!is_elevation(elevation))
            throw InputError(place_of(section, i),
                             fmt::format("is not the elevation of any ground ({:g} to {:g} m)",
                                         lowest_ground_m, highest_ground_m),
                             what_to_give);
        if (i == 0) continue;
        const double step = elevation - section.points[i - 1].y();
        if (std::abs(step) > greatest_step_m)
            throw InputError(
                place_of(section, i),
                fmt::format("lies {:.6g} m {} the point before it, and more than {:g} m is no ground",
                            std::abs(step), step > 0 ? "above" : "below", greatest_step_m),
                what_to_give);
    }
}

}  // namespace runout
