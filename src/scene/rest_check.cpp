#include "scene/rest_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

#include "engine/friction/yield_strength.h"

namespace runout {
namespace {

constexpr double enough_strength = 0.01;  // a hundred times the fall: 0.57 deg
constexpr const char* ways_out = "or run.time_limit_s as well, and the run ends there";

/// Part of the bed on which a mass could lie, as far as one word on its friction holds.
struct BedPart {
    double from = 0, to = 0;  ///< x, m
    double angle = 0;         ///< of the base friction, rad; NaN: rough
    bool in_range = false;    ///< of effects.base_friction.ranges
};

/// Friction of the base at x. Of ranges the latest holds, as in the engine.
BedPart friction_at(const BaseFriction& friction, double x) {
    BedPart part{.from = x, .to = x, .angle = friction.angle};
    for (const FrictionRange& range : friction.ranges) {
        if (x < range.from || x >= range.to) continue;
        part.angle = range.angle;
        part.in_range = true;
    }
    return part;
}

/// Adds what one segment of the bed has, cut where ranges begin and end. A part goes on over segments.
void add_segment(const BaseFriction& friction, const Vec2& a, const Vec2& b, std::vector<BedPart>& parts) {
    std::vector<double> cuts = {a.x(), b.x()};
    for (const FrictionRange& range : friction.ranges)
        for (const double end : {range.from, range.to})
            if (end > a.x() && end < b.x()) cuts.push_back(end);
    std::ranges::sort(cuts);
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        BedPart part = friction_at(friction, 0.5 * (cuts[i - 1] + cuts[i]));
        part.from = cuts[i - 1];
        part.to = cuts[i];
        const bool goes_on =
            !parts.empty() && parts.back().to == part.from && parts.back().in_range == part.in_range &&
            (parts.back().angle == part.angle || (std::isnan(parts.back().angle) && std::isnan(part.angle)));
        if (goes_on)
            parts.back().to = part.to;
        else
            parts.push_back(part);
    }
}

/// The parts of the bed less steep than the soil's friction angle: no soil lies on what is steeper, whatever
/// the friction there.
std::vector<BedPart> parts_to_lie_on(const Scene& scene) {
    std::vector<BedPart> parts;
    const Polyline& bed = scene.source.bed;
    for (std::size_t i = 1; i < bed.size(); ++i) {
        const Vec2 along = bed[i] - bed[i - 1];
        const bool steep = std::abs(along.y()) > along.x() * std::tan(scene.material.friction_angle);
        if (along.x() > 0 && !steep) add_segment(*scene.effects.base_friction, bed[i - 1], bed[i], parts);
    }
    return parts;
}

std::optional<BedPart> slippery_part(const Scene& scene) {
    const double long_enough = std::sqrt(scene.source.area);
    for (const BedPart& part : parts_to_lie_on(scene))
        if (!std::isnan(part.angle) && std::tan(part.angle) < enough_strength &&
            part.to - part.from >= long_enough)
            return part;
    return std::nullopt;
}

/// r_u of soil that starts at x: linear between the points, constant beyond them, as in the engine.
double ratio_at(const std::vector<Vec2>& field, double x) {
    const auto next = std::ranges::find_if(field, [x](const Vec2& point) { return point.x() >= x; });
    if (next == field.begin()) return field.front().y();
    if (next == field.end()) return field.back().y();
    const Vec2& before = *std::prev(next);
    return before.y() + (next->y() - before.y()) * (x - before.x()) / (next->x() - before.x());
}

/// Greatest r_u that the soil of the source starts with.
double greatest_ratio(const PorePressure& water, const Source& source) {
    if (water.field.empty()) return water.ratio;
    const auto [low, high] =
        std::ranges::minmax(source.outline, {}, [](const Vec2& corner) { return corner.x(); });
    double greatest = std::max(ratio_at(water.field, low.x()), ratio_at(water.field, high.x()));
    for (const Vec2& point : water.field)
        if (point.x() > low.x() && point.x() < high.x()) greatest = std::max(greatest, point.y());
    return greatest;
}

/// Share of its friction that water leaves the soil for good, where that is least.
double share_left_by_water(const PorePressure& water, const Source& source) {
    const double excess = std::isfinite(water.dissipation_time) ? 0.0 : water.base_excess;
    return 1.0 - greatest_ratio(water, source) - excess;
}

void check_water(const Scene& scene, double dry_strength, const PlaceOfKey& place) {
    if (!scene.effects.pore_pressure) return;
    const PorePressure& water = *scene.effects.pore_pressure;
    const double share = share_left_by_water(water, scene.source);
    if (share * dry_strength >= enough_strength) return;
    const double most = 1.0 - enough_strength / dry_strength;
    const bool by_excess = water.base_excess > 0 && std::isinf(water.dissipation_time) &&
                           greatest_ratio(water, scene.source) <= most;
    throw InputError(place(by_excess             ? "effects.pore_pressure.base_excess_ratio"
                           : water.field.empty() ? "effects.pore_pressure.ratio"
                                                 : "effects.pore_pressure.ratio_points"),
                     "leaves nothing that would bring the mass to rest: the water bears all of it",
                     fmt::format("give up to {:.3g} in all, {}", std::floor(1000 * most) / 1000, ways_out));
}

}  // namespace

void check_comes_to_rest(const Scene& scene, const PlaceOfKey& place) {
    const bool cohesive = scene.effects.cohesion && scene.effects.cohesion->strength > 0;
    if (cohesive || scene.run.time_limit > 0) return;
    const double own = std::sin(scene.material.friction_angle);
    if (own < enough_strength)
        throw InputError(place("material.friction_angle_deg"),
                         "leaves nothing that would bring the mass to rest",
                         fmt::format("give 0.58 deg or more, {}", ways_out));
    check_water(scene, own, place);
    if (!scene.effects.base_friction) return;
    if (const std::optional<BedPart> part = slippery_part(scene)) {
        const double ends[] = {scene.profile.to_section({part->from, 0}).x(),
                               scene.profile.to_section({part->to, 0}).x()};
        throw InputError(
            place(part->in_range ? "effects.base_friction.ranges" : "effects.base_friction.angle_deg"),
            fmt::format("leaves nothing that would bring the mass to rest from chainage {:.6g} to {:.6g} m",
                        std::min(ends[0], ends[1]), std::max(ends[0], ends[1])),
            fmt::format("give 0.58 deg or more there, {}", ways_out));
    }
}

}  // namespace runout
