#include "scene/case_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "scene/accuracy_target.h"
#include "scene/parameters.h"

namespace runout {
namespace {

struct Rivals {
    std::string_view first;
    std::string_view second;
};

/// Two ways to say the same thing.
constexpr std::array<Rivals, 12> rivals = {{
    {"section.file", "section.raster"},
    {"section.file", "section.line"},
    {"section.feature_id", "section.where"},
    {"section.origin", "section.line"},
    {"section.bearing_deg", "section.towards"},
    {"section.zero_elevation", "section.raster"},
    {"run.particle_spacing_m", "run.resolution"},
    {"effects.pore_pressure.ratio", "effects.pore_pressure.ratio_points"},
    {"effects.shaking.record", "effects.shaking.horizontal_coefficient"},
    {"effects.shaking.record", "effects.shaking.vertical_coefficient"},
    {"run.accuracy", "run.resolution"},
    {"run.accuracy", "run.particle_spacing_m"},
}};

struct Companions {
    std::string_view key;
    std::string_view needs;
};

constexpr std::array<Companions, 48> companions = {{
    {"section.columns", "section.file"},
    {"section.decimal", "section.file"},
    {"section.raster", "section.line"},
    {"section.sampling_m", "section.raster"},
    {"section.interpolation", "section.raster"},
    {"section.raster_crs", "section.raster"},
    {"section.layer", "section.line"},
    {"section.feature_id", "section.line"},
    {"section.where", "section.line"},
    {"section.line_crs", "section.line"},
    {"section.elevation_unit", "section.line"},
    {"section.zero_elevation", "section.line"},
    {"section.origin", "section.crs"},
    {"section.crs", "section.origin"},
    {"section.bearing_deg", "section.origin"},
    {"section.towards", "section.origin"},
    {"section.origin_chainage_m", "section.origin"},
    {"section.smoothing_m", "section.line"},
    {"effects.release.layers", "effects.release.layer_width_m"},
    {"effects.release.layers", "effects.release.layer_height_m"},
    {"effects.release.layer_width_m", "effects.release.layers"},
    {"effects.release.layer_height_m", "effects.release.layers"},
    {"effects.release.mass.points", "effects.release.mass.time_s"},
    {"effects.release.mass.time_s", "effects.release.mass.points"},
    {"effects.cohesion.tension_cut_off_kpa", "effects.cohesion.cohesion_kpa"},
    {"effects.rate.grain_density_kg_m3", "effects.rate.grain_diameter_m"},
    {"effects.rate.friction_increase", "effects.rate.grain_diameter_m"},
    {"effects.rate.inertial_number", "effects.rate.grain_diameter_m"},
    {"effects.pore_pressure.dissipation_time_s", "effects.pore_pressure.base_excess_ratio"},
    {"effects.barrier.chainage_m", "effects.barrier.height_m"},
    {"effects.barrier.height_m", "effects.barrier.chainage_m"},
    {"effects.barrier.inclination_deg", "effects.barrier.chainage_m"},
    {"effects.barrier.thickness_m", "effects.barrier.chainage_m"},
    {"effects.barrier.load_coefficient", "effects.barrier.chainage_m"},
    {"effects.side_walls.width_m", "effects.side_walls.friction_angle_deg"},
    {"effects.side_walls.friction_angle_deg", "effects.side_walls.width_m"},
    {"effects.erodible_bed.depth_m", "effects.erodible_bed.from_chainage_m"},
    {"effects.erodible_bed.from_chainage_m", "effects.erodible_bed.to_chainage_m"},
    {"effects.erodible_bed.to_chainage_m", "effects.erodible_bed.depth_m"},
    {"place.name", "place.chainage_m"},
    {"place.width_m", "place.chainage_m"},
    {"place.kind", "place.chainage_m"},
    {"places.layer", "places.file"},
    {"places.where", "places.file"},
    {"places.crs", "places.file"},
    {"places.name_field", "places.file"},
    {"places.kind_field", "places.file"},
    {"places.max_offset_m", "places.file"},
}};

/// "run.resolution (case.toml, line 12)"
std::string key_and_place(const InputPlace& place) {
    if (place.line > 0) return fmt::format("{} ({}, line {})", place.key, place.file, place.line);
    return fmt::format("{} ({})", place.key, place.file);
}

void check_rivals(const CaseSpec& spec) {
    for (const Rivals& pair : rivals)
        if (spec.has(pair.first) && spec.has(pair.second))
            throw InputError(spec.place(pair.first), "excludes " + key_and_place(spec.place(pair.second)),
                             "give one of the two");
}

void check_companions(const CaseSpec& spec) {
    for (const Companions& pair : companions)
        if (spec.has(pair.key) && !spec.has(pair.needs))
            throw InputError(spec.place(pair.key), fmt::format("needs {}", pair.needs), "give both");
    if (!spec.has("section.file") && !spec.has("section.line"))
        throw InputError(spec.place("section.file"), "is missing",
                         "give the cross-section as a table, or section.raster and section.line");
}

void check_placing(const CaseSpec& spec) {
    if (spec.has("section.origin") && !spec.has("section.bearing_deg") && !spec.has("section.towards"))
        throw InputError(spec.place("section.origin"), "does not say which way the section goes",
                         "give section.bearing_deg, or another place on it as section.towards");
}

std::string type_names(const std::vector<SourceType>& types) {
    std::string names;
    for (const SourceType type : types) names += (names.empty() ? "" : ", ") + to_string(type);
    return names;
}

void check_source_keys(const CaseSpec& spec) {
    for (const Parameter& parameter : parameters()) {
        const auto& types = parameter.applies_to;
        if (types.empty() || !spec.has(parameter.key)) continue;
        if (std::ranges::find(types, spec.source.type) == types.end())
            throw InputError(spec.place(parameter.key),
                             fmt::format("does not apply to source.type = {}", to_string(spec.source.type)),
                             fmt::format("it belongs to {}", type_names(types)));
    }
}

void check_friction_keys(const CaseSpec& spec) {
    if (spec.has("run.friction_iterations") && spec.run.friction == FrictionScheme::explicit_)
        throw InputError(spec.place("run.friction_iterations"), "does not apply to run.friction = explicit",
                         "leave it out, or use run.friction = projected");
}

}  // namespace

void check_keys_go_together(const CaseSpec& spec) {
    check_rivals(spec);
    check_companions(spec);
    check_placing(spec);
    check_source_keys(spec);
    check_friction_keys(spec);
    accuracy_target(spec.accuracy, spec.place("run.accuracy"));
}

}  // namespace runout
