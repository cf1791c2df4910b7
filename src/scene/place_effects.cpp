#include "scene/place_effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "scene/make_problem.h"
#include "scene/places_on_map.h"
#include "scene/shaking_record.h"
#include "source/polygon_place.h"

namespace runout {
namespace {

/// x of a chainage that must be on the section. `key` names it in the error.
double place_x(const CaseSpec& spec, const Profile& profile, std::string_view key, double chainage) {
    const double x = profile.to_local({chainage, profile.toe_elevation_m}).x();
    const double first = profile.ground.front().x();
    const double last = profile.ground.back().x();
    if (x > first && x < last) return x;
    const auto [low, high] =
        std::minmax({profile.to_section({first, 0}).x(), profile.to_section({last, 0}).x()});
    throw InputError(spec.place(key), fmt::format("is not on the section at chainage {:.6g} m", chainage),
                     fmt::format("valid: {:.6g} < chainage < {:.6g} m", low, high));
}

/// Two chainages as x in rising order. A range may end beyond the section.
std::pair<double, double> place_range(const CaseSpec& spec, const Profile& profile, std::string_view key,
                                      double from, double to) {
    if (!(from < to))
        throw InputError(spec.place(key), fmt::format("has a range from {:.6g} to {:.6g} m", from, to),
                         "give from < to");
    const double a = profile.to_local({from, 0}).x();
    const double b = profile.to_local({to, 0}).x();
    return std::minmax(a, b);
}

BaseFriction place_base_friction(const CaseSpec& spec, const Profile& profile) {
    constexpr const char* key = "effects.base_friction.ranges";
    BaseFriction friction = *spec.effects.base_friction;
    for (FrictionRange& range : friction.ranges) {
        if (!(range.angle >= 0 && range.angle < radians(80)))
            throw InputError(spec.place(key), fmt::format("has an angle of {:.6g} deg", degrees(range.angle)),
                             "valid: 0 <= angle < 80 deg");
        std::tie(range.from, range.to) = place_range(spec, profile, key, range.from, range.to);
    }
    std::ranges::sort(friction.ranges, {}, &FrictionRange::from);
    for (std::size_t i = 1; i < friction.ranges.size(); ++i)
        if (friction.ranges[i].from < friction.ranges[i - 1].to)
            throw InputError(spec.place(key), "has ranges that overlap",
                             "give each part of the bed one angle");
    return friction;
}

Cohesion checked_cohesion(const CaseSpec& spec) {
    const Cohesion& cohesion = *spec.effects.cohesion;
    const double slope = std::tan(spec.material.friction_angle);
    if (slope > 0 && cohesion.tension > cohesion.strength / slope)
        throw InputError(
            spec.place("effects.cohesion.tension_cut_off_kpa"), "is more than this soil can bear",
            fmt::format("valid: up to c / tan(phi) = {:.4g} kPa", 1e-3 * cohesion.strength / slope));
    return cohesion;
}

PorePressure place_pore_pressure(const CaseSpec& spec, const Profile& profile) {
    constexpr const char* key = "effects.pore_pressure.ratio_points";
    PorePressure pore = *spec.effects.pore_pressure;
    for (std::size_t i = 0; i < pore.field.size(); ++i) {
        if (!(pore.field[i].y() >= 0 && pore.field[i].y() <= 1))
            throw InputError(spec.place(key), fmt::format("has r_u = {:.6g}", pore.field[i].y()),
                             "valid: 0 <= r_u <= 1");
        if (i > 0 && pore.field[i].x() <= pore.field[i - 1].x())
            throw InputError(spec.place(key), "does not rise in chainage", "give the points by chainage");
    }
    for (Vec2& point : pore.field) point.x() = profile.to_local({point.x(), 0}).x();
    if (!profile.descends_with_chainage) std::ranges::reverse(pore.field);
    return pore;
}

/// Lower end of the source, as x.
double end_of(const Source& source) {
    double end = source.outline.front().x();
    for (const Vec2& corner : source.outline) end = std::max(end, corner.x());
    return end;
}

Barrier place_barrier(const CaseSpec& spec, const Site& site) {
    Barrier barrier = *spec.effects.barrier;
    const double chainage = barrier.x;
    barrier.x = place_x(spec, site.profile, "effects.barrier.chainage_m", chainage);
    const double source_end = end_of(site.source);
    if (barrier.x < source_end)
        throw InputError(spec.place("effects.barrier.chainage_m"),
                         "puts the barrier into the source or uphill of it",
                         fmt::format("the source ends at chainage {:.6g} m",
                                     site.profile.to_section({source_end, 0}).x()));
    if (barrier.thickness == 0) barrier.thickness = 0.5 * barrier.height;
    const double back = barrier.x + barrier.height / std::tan(barrier.inclination) + barrier.thickness;
    if (back >= site.profile.ground.back().x())
        throw InputError(spec.place("effects.barrier.chainage_m"),
                         "puts the barrier's back beyond the section", "lengthen the section");
    return barrier;
}

Shaking place_shaking(const CaseSpec& spec) {
    if (spec.shaking_record.empty()) {
        Shaking constant;
        constant.horizontal = {-spec.pseudo_static.x() * spec.run.gravity};
        constant.vertical = {-spec.pseudo_static.y() * spec.run.gravity};
        return constant;
    }
    Shaking shaking = read_shaking_record(spec.shaking_record, spec.run.gravity);
    if (shaking.time.back() < spec.run.time_limit)
        throw InputError(spec.place("effects.shaking.record"),
                         fmt::format("ends at {:.6g} s, before run.time_limit_s = {:.6g}",
                                     shaking.time.back(), spec.run.time_limit),
                         "lengthen the record (zeros: the ground is still), or shorten the run");
    return shaking;
}

/// What of a mass lies in the hill can leave it once. `ground`: what the source and earlier masses have left.
void check_taken_once(const CaseSpec& spec, const Site& site, const Polyline& ground, const Polygon& outline,
                      std::size_t number) {
    constexpr double drawing_error = 0.01;  // of the area: coordinates are decimals
    const PolygonPlace before = polygon_place(site.profile.ground, outline);
    const double gone = before.in_ground - polygon_place(ground, outline).in_ground;
    if (gone > drawing_error * before.area)
        throw InputError(
            spec.place("effects.release.mass.points"),
            fmt::format("overlaps: {:.4g} of the {:.4g} m2 of mass {} have left the hill with the "
                        "source or an earlier mass",
                        gone, before.area, number),
            "give each [[effects.release.mass]] ground of its own");
}

StagedRelease place_release(const CaseSpec& spec, const Site& site) {
    StagedRelease release = *spec.effects.release;
    Profile ground = site.profile;
    ground.ground = site.source.bed;
    double previous = 0;
    for (LaterMass& later : release.masses) {
        if (!(later.time > previous) || later.mass.outline.empty())
            throw InputError(spec.place("effects.release.mass.time_s"),
                             "is not a later time with the points of its mass",
                             "give each [[effects.release.mass]] a time_s, rising, and points");
        previous = later.time;
        SourceSpec shape;
        shape.type = SourceType::polygon;
        shape.points = section_points(later.mass.outline);  // not placed yet
        shape.places = {{"source.points", spec.place("effects.release.mass.points")}};
        const Source source = derive_source(ground, shape);
        check_taken_once(spec, site, ground.ground, source.outline,
                         static_cast<std::size_t>(&later - release.masses.data()) + 1);
        later.mass = mass_of(source);
        ground.ground = source.bed;
    }
    return release;
}

ErodibleBed place_erodible_bed(const CaseSpec& spec, const Profile& profile) {
    ErodibleBed layer = *spec.effects.erodible_bed;
    place_x(spec, profile, "effects.erodible_bed.from_chainage_m", layer.from);
    place_x(spec, profile, "effects.erodible_bed.to_chainage_m", layer.to);
    std::tie(layer.from, layer.to) =
        place_range(spec, profile, "effects.erodible_bed.from_chainage_m", layer.from, layer.to);
    return layer;
}

}  // namespace

Effects place_effects(const CaseSpec& spec, const Site& site) {
    Effects effects = spec.effects;
    if (effects.base_friction) effects.base_friction = place_base_friction(spec, site.profile);
    if (effects.cohesion) effects.cohesion = checked_cohesion(spec);
    if (effects.pore_pressure) effects.pore_pressure = place_pore_pressure(spec, site.profile);
    if (effects.barrier) effects.barrier = place_barrier(spec, site);
    if (effects.shaking) effects.shaking = place_shaking(spec);
    if (effects.release) effects.release = place_release(spec, site);
    if (effects.erodible_bed) effects.erodible_bed = place_erodible_bed(spec, site.profile);
    return effects;
}

namespace {

/// Of the near and the far edge.
void check_on_ground(const CaseSpec& spec, const Site& site, const Place& place) {
    constexpr double rounding = 1e-9;
    const double source_end = end_of(site.source);
    const double end_chainage = site.profile.to_section({source_end, 0}).x();
    if (place.x < source_end - rounding)
        throw InputError(spec.place("place.chainage_m"),
                         fmt::format("puts {} into the source or uphill of it", place.name),
                         fmt::format("the source ends at chainage {:.6g} m", end_chainage));
    const double last = site.profile.ground.back().x();
    if (place.x + place.width > last)
        throw InputError(spec.place("place.width_m"), fmt::format("ends {} beyond the section", place.name),
                         fmt::format("valid: up to {:.6g} m", last - place.x));
}

}  // namespace

std::vector<Place> located_places(const CaseSpec& spec, Site& site) {
    const Profile& profile = site.profile;
    std::vector<Place> places = spec.places;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (std::isnan(places[i].x))
            throw InputError(spec.place("place.chainage_m"),
                             fmt::format("is missing for [[place]] {}", i + 1),
                             "give its chainage in metres");
        places[i].x = place_x(spec, profile, "place.chainage_m", places[i].x);
        if (places[i].name.empty()) places[i].name = fmt::format("place-{}", i + 1);
        check_on_ground(spec, site, places[i]);
        const auto end = places.begin() + static_cast<std::ptrdiff_t>(i);
        const auto same = std::ranges::find(places.begin(), end, places[i].name, &Place::name);
        if (same != end)
            throw InputError(spec.place("place.name"),
                             fmt::format("names [[place]] {} and {} alike: {}", same - places.begin() + 1,
                                         i + 1, places[i].name),
                             "give each a name of its own");
    }
    for (Place& place : places_on_map(spec, site, end_of(site.source), places))
        places.push_back(std::move(place));
    return places;
}

}  // namespace runout
