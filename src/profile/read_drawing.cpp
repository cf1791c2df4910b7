#include "profile/read_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/input_error.h"
#include "core/length_unit.h"
#include "profile/check_elevations.h"
#include "profile/drawing_layers.h"
#include "profile/join_lines.h"

namespace runout {
namespace {

constexpr const char* unit_key = "section.unit";

// Drawings in metres are often marked as millimetres or inches, which is what programs begin with. Where the
// marked unit makes a section as short as this, and metres would make one too, the user must say which.
constexpr double doubtfully_short_m = 20;
constexpr double longest_in_metres_m = 2000;

/// Lines of one layer.
struct LayerLines {
    std::vector<Polyline> pieces;
    double off_the_curve = 0;
};

double greatest_extent(const std::vector<Polyline>& pieces) {
    Vec2 low = pieces.front().front();
    Vec2 high = low;
    for (const Polyline& piece : pieces)
        for (const Vec2& p : piece) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
    return (high - low).maxCoeff();
}

LayerLines lines_of(const Drawing& drawing, const std::string& layer) {
    LayerLines lines;
    for (const DrawnLine& line : drawing.lines) {
        if (line.layer != layer) continue;
        if (!line.level)
            throw InputError(
                {drawing.file, 0, "layer", layer}, "has lines in three dimensions",
                "a section is drawn flat, x = chainage and y = elevation; a line on the map with "
                "elevations is section.line");
        lines.pieces.push_back(line.points);
        lines.off_the_curve = std::max(lines.off_the_curve, line.off_the_curve);
    }
    return lines;
}

/// The unit of the drawing, and how it is known.
struct UnitChoice {
    LengthUnit unit;
    std::string reason;
};

UnitChoice unit_of(const Drawing& drawing, const DrawingOptions& options,
                   const std::vector<Polyline>& ground) {
    if (!options.unit.empty()) return {known_length_unit(options.unit), "as section.unit says"};
    if (drawing.unit.empty() && drawing.imperial)
        throw InputError({drawing.file, 0, unit_key, ""},
                         "is missing: the drawing says that it is not metric, and not what its unit is",
                         "give --unit ft, us-ft, in or m");
    if (drawing.unit.empty()) return {*length_unit("m"), "as the drawing says nothing else"};
    const LengthUnit unit = *length_unit(drawing.unit);
    const double extent = greatest_extent(ground);
    if (unit.metres < length_unit("ft")->metres && extent * unit.metres < doubtfully_short_m &&
        extent < longest_in_metres_m)
        throw InputError(
            {drawing.file, 0, unit_key, ""},
            fmt::format(
                "is missing: {} says {}, in which the section is {:.3g} m long, and drawings in metres "
                "({:.4g} m) are often marked so",
                drawing.unit_from, unit.name, extent * unit.metres, extent),
            fmt::format("give --unit {} or --unit m", drawing.unit));
    return {unit, fmt::format("as {} says", drawing.unit_from)};
}

std::vector<Polyline> in_metres(std::vector<Polyline> pieces, double metres) {
    for (Polyline& piece : pieces)
        for (Vec2& p : piece) p *= metres;
    return pieces;
}

/// A map has northings where a section has elevations.
void check_no_plan(const Drawing& drawing, const std::vector<Polyline>& pieces) {
    for (const Polyline& piece : pieces)
        for (const Vec2& p : piece)
            if (!(p.y() >= lowest_ground_m && p.y() <= highest_ground_m))
                throw InputError(
                    {drawing.file, 0, "y", fmt::format("{:.10g}", p.y())},
                    fmt::format("is the elevation of no ground ({:g} to {:g} m), at x = {:.10g}",
                                lowest_ground_m, highest_ground_m, p.x()),
                    "draw a section as x = chainage and y = elevation, and say its unit with --unit where it "
                    "is "
                    "not metres; a line on a plan is section.line, with elevations of its own or of a "
                    "section.raster");
}

std::string file_name(const Drawing& drawing) {
    return std::filesystem::path(drawing.file).filename().string();
}

std::string count_of(std::size_t lines) {
    return lines == 1 ? "1 line" : fmt::format("{} lines", lines);
}

std::string how_it_was_read(const LayerRoles& roles, const LayerLines& ground, const UnitChoice& choice) {
    std::string text =
        fmt::format("read as: x = chainage and y = elevation in {}, {}; ground: {} on layer {}",
                    choice.unit.name, choice.reason, count_of(ground.pieces.size()), roles.ground);
    if (ground.off_the_curve > 0)
        text += fmt::format(", splines in pieces that are up to about {:.2g} m off them",
                            ground.off_the_curve * choice.unit.metres);
    if (!roles.source.empty()) text += fmt::format("; source: layer {}", roles.source);
    if (!roles.slip.empty()) text += fmt::format("; slip line: layer {}", roles.slip);
    return text;
}

}  // namespace

SectionContent section_of_drawing(const Drawing& drawing, const DrawingOptions& options) {
    const LayerRoles roles = layer_roles(drawing, options.layers);
    const LayerLines ground = lines_of(drawing, roles.ground);
    const UnitChoice choice = unit_of(drawing, options, ground.pieces);
    const auto joined = [&](const LayerLines& lines, const std::string& layer, Course course) {
        return join_lines(in_metres(lines.pieces, choice.unit.metres), course,
                          {drawing.file, "layer " + layer});
    };
    const auto from = [&](const std::string& layer) {
        return fmt::format("layer {} of {}", layer, file_name(drawing));
    };
    SectionContent content;
    SectionPoints& section = content.section;
    section.origin = drawing.file;
    section.read_as = how_it_was_read(roles, ground, choice);
    check_no_plan(drawing, in_metres(ground.pieces, choice.unit.metres));
    section.points = joined(ground, roles.ground, Course::open);
    check_elevations(section);
    if (!roles.source.empty()) {
        content.mass.outline =
            section_points(joined(lines_of(drawing, roles.source), roles.source, Course::closed));
        content.mass.outline_from = from(roles.source);
    }
    if (!roles.slip.empty()) {
        content.mass.slip_line =
            section_points(joined(lines_of(drawing, roles.slip), roles.slip, Course::open));
        content.mass.slip_line_from = from(roles.slip);
    }
    return content;
}

}  // namespace runout
