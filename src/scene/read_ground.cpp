#include "scene/read_ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/input_error.h"
#include "scene/parameters.h"
#include "source/source_types.h"

namespace runout {
namespace {

using Keys = std::vector<std::string_view>;

// Of a section that is drawn in a local system these say nothing.
constexpr std::array keys_of_the_map = {"section.elevation_unit", "section.smoothing_m"};

/// A key that says how to read one format has no effect on another.
void check_keys_of_format(const CaseSpec& spec, std::string_view format, const Keys& its_keys) {
    for (const SectionFormat& other : section_formats())
        for (const std::string_view key : other.keys)
            if (spec.has(key) && std::ranges::find(its_keys, key) == its_keys.end())
                throw InputError(spec.place(key), fmt::format("does not apply to {}", format),
                                 fmt::format("leave it out; it belongs to {}", other.name));
}

/// Puts a section that comes without a map where the case says it lies.
void place_on_map(const SectionSpec& section, Profile& profile) {
    if (!section.placing.origin.allFinite()) return;
    const Chainage head = profile.chainage_at(profile.ground.front().x());
    const Chainage end = profile.chainage_at(profile.ground.back().x());
    profile.map_line = placed_line(section.placing, std::min(head, end), std::max(head, end));
}

SectionContent read_local_section(const CaseSpec& spec) {
    constexpr std::string_view format = "a section in a local system";
    check_keys_of_format(spec, format, {"section.unit", "section.dxf_layers"});
    for (const char* key : keys_of_the_map)
        if (spec.has(key))
            throw InputError(spec.place(key), fmt::format("does not apply to {}", format),
                             "leave it out; section.unit is the unit of both coordinates");
    const SectionFileOptions& options = spec.section.format;
    return section_of_drawing(read_local_lines(spec.section.map.line), {options.dxf_layers, options.unit});
}

SectionContent read_own_file(const CaseSpec& spec) {
    const SectionFormat& format = format_of_section(spec.section.file);
    check_keys_of_format(spec, format.name, format.keys);
    return format.read(spec.section.file, spec.section.format);
}

/// Whether the case says of the source what only a shape with sizes has.
bool says_sizes(const CaseSpec& spec) {
    return std::ranges::any_of(parameters(), [&](const Parameter& parameter) {
        return !parameter.applies_to.empty() && !takes_points(parameter.applies_to.front()) &&
               spec.has(parameter.key);
    });
}

SourceType drawn_type(const CaseSpec& spec, const DrawnMass& mass) {
    if (!mass.outline.empty() && !mass.slip_line.empty())
        throw InputError(spec.place("source.type"),
                         fmt::format("must be said: an outline is drawn ({}), and a slip line ({})",
                                     mass.outline_from, mass.slip_line_from),
                         "give polygon or slip_surface");
    return mass.outline.empty() ? SourceType::slip_surface : SourceType::polygon;
}

}  // namespace

bool is_on_map(const SectionSpec& section) {
    const MapSection& map = section.map;
    if (map.line.file.empty()) return false;
    return !map.raster.empty() || !map.line.crs.empty() || !are_local_lines(map.line);
}

Ground read_ground(const CaseSpec& spec) {
    const SectionSpec& section = spec.section;
    if (is_on_map(section)) {
        check_keys_of_format(spec, "a line on the map", {});
        return {read_map_section(section.map, section.options), {}};
    }
    SectionContent content = section.file.empty() ? read_local_section(spec) : read_own_file(spec);
    Ground ground{make_profile(content.section, section.options), std::move(content.mass)};
    place_on_map(section, ground.profile);
    return ground;
}

SourceSpec with_drawn_mass(const CaseSpec& spec, const DrawnMass& mass, std::vector<std::string>& assumed) {
    SourceSpec source = spec.source;
    const bool drawn = !mass.outline.empty() || !mass.slip_line.empty();
    if (!drawn || spec.has("source.points")) return source;
    if (!spec.has("source.type")) {
        if (says_sizes(spec)) return source;
        source.type = drawn_type(spec, mass);
        assumed.push_back(fmt::format("source.type = {}, as drawn", to_string(source.type)));
    }
    if (!takes_points(source.type)) return source;
    const bool outline = row_of(source.type).placement == Placement::by_outline;
    const std::vector<SectionPoint>& points = outline ? mass.outline : mass.slip_line;
    if (points.empty()) return source;
    source.points = points;
    assumed.push_back(fmt::format("source.points = the {} points of {}", points.size(),
                                  outline ? mass.outline_from : mass.slip_line_from));
    return source;
}

}  // namespace runout
