#include "profile/line_elevations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/elevation_limits.h"
#include "core/input_error.h"

namespace runout {
namespace {

/// Ground that comes to exactly 0 comes near it before; what stands this far from its neighbours is a filler.
constexpr double far_from_zero_m = 1;

constexpr const char* give_raster = "give section.raster to sample, or a line with elevations";

/// A line with its elevations in metres, and how to speak of it.
struct Heights {
    const MapSection& section;
    const SectionLine& line;
    std::vector<double> metres;

    [[nodiscard]] InputPlace feature() const {
        return {section.line.file, 0, fmt::format("feature {}", line.feature_id), "LINESTRING"};
    }
    [[nodiscard]] InputPlace vertex(std::size_t i) const {
        const Vec2& at = line.vertices[i].place;
        return {section.line.file, 0,
                fmt::format("feature {}, vertex {} of {}", line.feature_id, i + 1, line.vertices.size()),
                fmt::format("({:.10g}, {:.10g})", at.x(), at.y())};
    }
};

bool is_missing(double elevation) {
    return std::isnan(elevation);
}

void check_has_any(const Heights& heights) {
    const auto says_nothing = [](double metres) { return is_missing(metres) || metres == 0; };
    if (heights.metres.empty()) throw InputError(heights.feature(), "has no elevations", give_raster);
    if (!heights.line.height_datum.empty())
        throw InputError(
            heights.feature(),
            fmt::format("has no elevations, because its heights are {}", heights.line.height_datum),
            "give section.raster to sample, or set altitudeMode to absolute where they are elevations");
    if (std::ranges::all_of(heights.metres, says_nothing))
        throw InputError(heights.feature(), "has no elevations: all are 0", give_raster);
}

void check_values(const Heights& heights) {
    for (std::size_t i = 0; i < heights.metres.size(); ++i) {
        const double metres = heights.metres[i];
        if (is_missing(metres))
            throw InputError(heights.vertex(i), "has no elevation", "give it one, or give section.raster");
        if (is_elevation(metres)) continue;
        throw InputError(heights.vertex(i),
                         fmt::format("has {:.7g}, which is no elevation between {:g} and {:g} m",
                                     heights.line.vertices[i].elevation, lowest_ground_m, highest_ground_m),
                         "mend it, give section.elevation_unit where it counts in another unit, or give "
                         "section.raster");
    }
}

bool is_far(double metres, double side) {
    return metres * side >= far_from_zero_m;
}

/// Whether zeros from `first` to before `end` stand among elevations far from 0, as where some were missing.
/// Two or more at an end of the line are its level ground.
bool is_doubtful(const std::vector<double>& metres, std::size_t first, std::size_t end) {
    const bool has_before = first > 0;
    const bool has_after = end < metres.size();
    if (has_before && has_after) {
        const double side = metres[first - 1] > 0 ? 1 : -1;
        return is_far(metres[first - 1], side) && is_far(metres[end], side);
    }
    return end - first == 1 && std::abs(metres[has_before ? first - 1 : end]) >= far_from_zero_m;
}

void check_zeros(const Heights& heights) {
    const std::vector<double>& metres = heights.metres;
    for (std::size_t first = 0; first < metres.size(); ++first) {
        if (metres[first] != 0) continue;
        std::size_t end = first + 1;
        while (end < metres.size() && metres[end] == 0) ++end;
        if (is_doubtful(metres, first, end))
            throw InputError(heights.vertex(first),
                             "has the elevation 0 among others far from it, as where one is missing",
                             "mend it, or say section.zero_elevation = \"ground\" if it is right");
        first = end;
    }
}

}  // namespace

std::vector<Vec2> line_elevations(const MapSection& section, const SectionLine& line) {
    Heights heights{section, line, {}};
    for (const LineVertex& vertex : line.vertices)
        heights.metres.push_back(unit_m(section.options.elevation_unit) * vertex.elevation);
    check_has_any(heights);
    if (section.options.elevation_unit.empty())
        refuse_unconfirmed_unit(section.line.file, line.elevation_unit_m);
    check_values(heights);
    if (!section.zero_is_ground) check_zeros(heights);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < heights.metres.size(); ++i) {
        const Vec2 point(line.vertices[i].chainage_m, heights.metres[i]);
        if (points.empty() || point != points.back()) points.push_back(point);
    }
    return points;
}

}  // namespace runout
