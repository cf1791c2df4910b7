#include "scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/units.h"
#include "scene/case_checks.h"
#include "scene/case_spec.h"
#include "scene/length_check.h"
#include "scene/parameters.h"
#include "scene/place_effects.h"
#include "scene/read_ground.h"
#include "scene/rest_check.h"
#include "source/polygon_place.h"
#include "source/source_types.h"

namespace runout {
namespace {

// Fewer particles have no inside; more would not end within days and are a slip of the unit.
constexpr double fewest_particles = 4;
constexpr double most_particles = 5e6;

constexpr int cohesive_friction_iterations = 60;
constexpr double cohesive_pressure_tolerance = 1e-3;

/// Gives `value` a default and says so; a value that the user gave stays.
void assume(double& value, double fallback, const std::string& sentence, std::vector<std::string>& assumed) {
    if (!std::isnan(value)) return;
    value = fallback;
    assumed.push_back(sentence);
}

/// For the messages of the geometry: where each key of the source stands, or would stand.
std::map<std::string, InputPlace> source_places(const CaseSpec& spec) {
    std::map<std::string, InputPlace> places;
    for (const Parameter& parameter : parameters())
        if (parameter.key.starts_with("source.")) places.emplace(parameter.key, spec.place(parameter.key));
    return places;
}

/// What an engineer would try first when only a section is at hand: a wedge (type B) with the angles of the
/// paper's Fig. 15.
SourceSpec with_defaults(const CaseSpec& spec, const DrawnMass& drawn, std::vector<std::string>& assumed) {
    SourceSpec source = with_drawn_mass(spec, drawn, assumed);
    source.places = source_places(spec);
    if (!spec.has("source.type") && source.type == SourceSpec{}.type)
        assumed.push_back("source.type = " + to_string(source.type));
    if (uses(source.type, &SourceSpec::base_angle))
        assume(source.base_angle, radians(35), "source.base_angle_deg = 35", assumed);
    if (uses(source.type, &SourceSpec::scarp_angle))
        assume(source.scarp_angle, radians(80), "source.scarp_angle_deg = 80", assumed);
    return source;
}

/// Where derive_source put a source whose place or height was left open.
void say_where_it_was_put(const CaseSpec& spec, const Site& site, std::vector<std::string>& assumed) {
    const Source& source = site.source;
    const bool placed = row_of(source.type).placement == Placement::by_drop_height;
    const bool sized_by_area = placed && spec.has("source.area_m2");
    if (uses(source.type, &SourceSpec::height) && !sized_by_area && !spec.has("source.height_m"))
        assumed.push_back(fmt::format("source.height_m = {:.6g}", height_of(site.profile, source)));
    if (placed && !spec.has("source.drop_height_m"))
        assumed.push_back(fmt::format("source.drop_height_m = {:.6g}", source.drop_height));
}

/// A mass drawn by hand is part of the hill, or stands on the ground. What is drawn over the surface or hangs
/// in the air is a slip, and would run out as if it were real.
void check_polygon_place(const CaseSpec& spec, const Site& site) {
    if (row_of(site.source.type).placement != Placement::by_outline) return;
    constexpr double drawing_error = 0.01;  // of the area: coordinates are decimals
    const PolygonPlace place = polygon_place(site.profile.ground, site.source.outline);
    const double outside = place.area - place.in_ground;
    const double slack = drawing_error * place.area;
    if (outside <= slack || (place.in_ground <= slack && place.air_below <= slack)) return;
    const bool hangs = place.in_ground <= slack;
    throw InputError(
        spec.place("source.points"),
        hangs ? fmt::format("lies in the air: all of its {:.4g} m2, with {:.4g} m2 of air below it",
                            place.area, place.air_below)
              : fmt::format("lies partly in the air: {:.4g} of its {:.4g} m2", outside, place.area),
        "give a polygon within the hill, or one that stands on the ground and has nothing in it");
}

void check_particle_count(const CaseSpec& spec, double area) {
    const double spacing = spec.run.particle_spacing;
    if (spacing <= 0) return;  // from the resolution, whose range bounds the number
    const double count = area / (spacing * spacing);
    const double finest = std::sqrt(area / most_particles);
    const double coarsest = std::sqrt(area / fewest_particles);
    if (count < fewest_particles || count > most_particles)
        throw InputError(spec.place("run.particle_spacing_m"),
                         fmt::format("makes {:.3g} particles of a source of {:.4g} m2", count, area),
                         fmt::format("valid: {:.3g} to {:.3g} m", finest, coarsest));
}

void check_friction_angle(const CaseSpec& spec) {
    if (std::isnan(spec.material.friction_angle))
        throw InputError(spec.place("material.friction_angle_deg"), "is missing",
                         "give the internal friction angle, 0 <= number < 80 deg");
}

/// Cohesive soil is elastic where it does not yield; with the usual numbers it is so soft and so noisy that a
/// standing cut sags.
RunSettings run_settings(const CaseSpec& spec, std::vector<std::string>& assumed) {
    RunSettings run = spec.run;
    if (!spec.effects.cohesion || spec.effects.cohesion->strength <= 0) return run;
    if (!spec.has("run.friction_iterations") && run.friction == FrictionScheme::projected) {
        run.friction_iterations = cohesive_friction_iterations;
        assumed.push_back(
            fmt::format("run.friction_iterations = {}, for a cohesive soil", run.friction_iterations));
    }
    if (!spec.has("run.pressure_tolerance")) {
        run.pressure_tolerance = cohesive_pressure_tolerance;
        assumed.push_back(
            fmt::format("run.pressure_tolerance = {}, for a cohesive soil", run.pressure_tolerance));
    }
    return run;
}

}  // namespace

Profile make_ground(const CaseSpec& spec) {
    check_keys_go_together(spec);
    return read_ground(spec).profile;
}

Site make_site(const CaseSpec& spec) {
    check_keys_go_together(spec);
    Ground ground = read_ground(spec);
    Site site;
    site.profile = std::move(ground.profile);
    site.source = derive_source(site.profile, with_defaults(spec, ground.mass, site.assumed));
    check_polygon_place(spec, site);
    say_where_it_was_put(spec, site, site.assumed);
    return site;
}

Scene make_scene(const CaseSpec& spec) {
    check_friction_angle(spec);
    Site site = make_site(spec);
    check_particle_count(spec, site.source.area);
    check_lengths(spec, site.source.area);
    Effects effects = place_effects(spec, site);
    std::vector<Place> places = located_places(spec, site);
    const RunSettings run = run_settings(spec, site.assumed);
    Scene scene{.name = spec.name,
                .profile = std::move(site.profile),
                .source = std::move(site.source),
                .material = spec.material,
                .effects = std::move(effects),
                .places = std::move(places),
                .run = run,
                .assumed = std::move(site.assumed)};
    check_comes_to_rest(scene, [&](std::string_view key) { return spec.place(key); });
    return scene;
}

}  // namespace runout
