// Masses between a basal slip surface and a back scarp: type B under the face, type C back to the crest
// surface.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "source/area_search.h"
#include "source/shapes.h"
#include "source/spec_check.h"

namespace runout {
namespace {

double inclination_between(const Vec2& low, const Vec2& high) {
    return std::atan2(high.y() - low.y(), low.x() - high.x());
}

double crest_height(const Profile& profile) {
    return profile.ground[profile.crest].y();
}

/// Base between horizontal and the face, scarp between the face and vertical.
void require_angles_around_face(const SourceSpec& spec, const Vec2& exit, const Vec2& face_top) {
    const double face = inclination_between(exit, face_top);
    if (spec.base_angle >= face)
        refuse(spec, &SourceSpec::base_angle, "is not flatter than the face",
               fmt::format("give less than {} degrees", figure(degrees(face))));
    if (spec.scarp_angle <= face)
        refuse(spec, &SourceSpec::scarp_angle, "is not steeper than the face",
               fmt::format("give more than {} and at most 90 degrees", figure(degrees(face))));
}

void require_base_and_scarp(const SourceSpec& spec) {
    required(spec, &SourceSpec::base_angle, "give the dip of the basal slip surface, such as 35");
    required(spec, &SourceSpec::scarp_angle, "give the inclination of the back scarp, such as 80");
}

/// The slip planes of a spec through two points of the ground, and what they cut off.
class Planes {
  public:
    Planes(const Profile& profile, const SourceSpec& spec) : ground_(profile.ground), spec_(spec) {}

    [[nodiscard]] std::optional<Region> region(const GroundPoint& exit, const GroundPoint& top) const {
        return wedge(ground_, {exit, top, spec_.base_angle, spec_.scarp_angle});
    }
    /// 0 where the planes cut nothing off; grows as `top` moves uphill, up to where the base comes out of the
    /// ground.
    [[nodiscard]] double area(const GroundPoint& exit, const GroundPoint& top) const {
        const auto cut = region(exit, top);
        return cut ? cut->area() : 0.0;
    }

  private:
    const Polyline& ground_;
    const SourceSpec& spec_;
};

/// The mass between base and scarp; it reaches from `exit` to `top` in one piece.
Region connected_mass(const Profile& profile, const SourceSpec& spec, const GroundPoint& exit,
                      const GroundPoint& top) {
    auto region = Planes(profile, spec).region(exit, top);
    if (region && region->touches(profile.ground, top)) return *std::move(region);
    refuse(spec, "source.type",
           fmt::format("{} finds no connected mass between base and back scarp", to_string(spec.type)),
           "the ground between them must stay above the base and below the scarp; change "
           "source.base_angle_deg or "
           "source.scarp_angle_deg, or give a slip_surface");
}

Source finished(const Profile& profile, const SourceSpec& spec, const GroundPoint& exit,
                const GroundPoint& top) {
    const Region region = connected_mass(profile, spec, exit, top);
    if (given(spec.area) && given(spec.height) && !agree(region.area(), spec.area))
        refuse(
            spec, &SourceSpec::area, "contradicts source.height_m",
            fmt::format("leave one of them out; with this height the area is {} m2", figure(region.area())));
    return source_from(region, profile, spec, corner_at(profile.ground, exit),
                       corner_at(profile.ground, top));
}

// ---- type B

bool apex_is_given(const SourceSpec& spec) {
    return given(spec.drop_height) && spec.datum == DropDatum::head;
}

GroundPoint apex_above(const Profile& profile, const SourceSpec& spec, const GroundPoint& exit) {
    const double low = position(profile.ground, exit).y();
    const double crest = crest_height(profile);
    const double room = crest - low;
    if (spec.height > room * (1 + 1e-9))
        refuse(spec, &SourceSpec::height,
               fmt::format("puts the apex {} m above the toe, above the crest at {} m",
                           figure(low + spec.height), figure(crest)),
               fmt::format("give at most {} m", figure(room)));
    const auto way = walk(exit, at_vertex(profile.ground, profile.crest));
    const double elevation = agree(spec.height, room) ? crest : low + spec.height;
    return first_at_elevation(profile.ground, way, elevation)
        .value_or(at_vertex(profile.ground, profile.crest));
}

/// How far an exit point that was read off a drawing may miss the foot of the face, m.
double reading_error(const Profile& profile) {
    return std::max(0.05, 0.002 * crest_height(profile));
}

/// The exit point where it can be one: where the ground right above it is flatter than the base, as on a berm
/// or on level ground before the face, the base comes out of it at once. A miss by no more than a reading
/// error is mended.
GroundPoint where_base_goes_in(const Profile& profile, const SourceSpec& spec, const GroundPoint& exit) {
    const Polyline& ground = profile.ground;
    const Vec2 given_at = position(ground, exit);
    const std::size_t above = on_segment_above(exit).segment;
    if (inclination(ground, above) > spec.base_angle) return exit;
    std::size_t segment = above;
    while (segment > profile.crest && inclination(ground, segment) <= spec.base_angle) --segment;
    const bool steep = inclination(ground, segment) > spec.base_angle;
    const Vec2 foot = ground[segment + 1];
    if (steep && (foot - given_at).norm() <= std::min(reading_error(profile), 0.01 * crest_height(profile)))
        return at_vertex(ground, segment + 1);
    refuse(
        spec, "source.type",
        fmt::format(
            "{} has its exit point P at {}, and the ground right above it is flatter than the base ({} deg), "
            "which comes out of it at once",
            to_string(spec.type), shown(profile, given_at), figure(degrees(spec.base_angle))),
        steep ? fmt::format("put P at the foot of the steep part, {}: give section.toe_chainage_m = {}, or "
                            "source.drop_height_m = {} with source.drop_height_datum = base",
                            shown(profile, foot), figure(profile.chainage_at(foot.x()).m), figure(foot.y()))
              : "give a flatter source.base_angle_deg");
}

[[noreturn]] void refuse_area(const SourceSpec& spec, double greatest, const std::string& why) {
    if (!(greatest > 0))
        refuse(spec, &SourceSpec::area, "cannot be had: base and back scarp cut nothing off",
               "give a flatter source.base_angle_deg or a steeper source.scarp_angle_deg");
    refuse(spec, &SourceSpec::area, why, fmt::format("give at most {} m2", figure(greatest)));
}

GroundPoint apex_with_area(const Profile& profile, const SourceSpec& spec, const GroundPoint& exit) {
    const GroundPoint crest = at_vertex(profile.ground, profile.crest);
    const Planes planes(profile, spec);
    const auto area_below = [&](const GroundPoint& top) { return planes.area(exit, top); };
    if (const auto apex = point_with_area(walk(exit, crest), area_below, spec.area)) return *apex;
    const auto whole = planes.region(exit, crest);
    const bool in_one_piece = whole && whole->touches(profile.ground, crest);
    refuse_area(spec, area_below(crest),
                in_one_piece ? "puts the apex above the crest"
                             : "is more than the base cuts off before it comes out of the face");
}

GroundPoint exit_with_area(const Profile& profile, const SourceSpec& spec, const GroundPoint& apex) {
    const GroundPoint toe = at_vertex(profile.ground, profile.toe);
    const Planes planes(profile, spec);
    const auto area_above = [&](const GroundPoint& exit) { return planes.area(exit, apex); };
    if (const auto exit = point_with_area(walk(apex, toe), area_above, spec.area)) return *exit;
    refuse_area(spec, area_above(toe), "puts the lower end of the source below the toe");
}

GroundPoint exit_below(const Profile& profile, const SourceSpec& spec, const GroundPoint& apex) {
    if (given(spec.height))
        return on_face(profile, spec, spec.drop_height - spec.height, &SourceSpec::height,
                       "the lower end of the source");
    if (given(spec.area)) return exit_with_area(profile, spec, apex);
    return at_vertex(profile.ground, profile.toe);
}

GroundPoint apex_of(const Profile& profile, const SourceSpec& spec, const GroundPoint& exit) {
    if (given(spec.height)) return apex_above(profile, spec, exit);
    if (given(spec.area)) return apex_with_area(profile, spec, exit);
    return at_vertex(profile.ground, profile.crest);
}

Source derive_b_below_apex(const Profile& profile, const SourceSpec& spec) {
    const GroundPoint apex =
        on_face(profile, spec, spec.drop_height, &SourceSpec::drop_height, "the head of the source");
    const Vec2 head = position(profile.ground, apex);
    if (!(head.y() > 0))
        refuse(spec, &SourceSpec::drop_height, "leaves no room for a source below its head",
               "give a greater height");
    require_angles_around_face(spec, {0, 0}, head);
    const GroundPoint exit = exit_below(profile, spec, apex);
    return finished(profile, spec, where_base_goes_in(profile, spec, exit), apex);
}

/// P where the base daylights: at the drop height when that is measured to the base, otherwise at the toe.
GroundPoint given_exit(const Profile& profile, const SourceSpec& spec) {
    if (!given(spec.drop_height)) return at_vertex(profile.ground, profile.toe);
    const GroundPoint exit =
        on_face(profile, spec, spec.drop_height, &SourceSpec::drop_height, "the lower end of the source");
    if (position(profile.ground, exit).y() >= crest_height(profile))
        refuse(spec, &SourceSpec::drop_height, "puts the lower end of the source at the crest",
               fmt::format("give less than {} m", figure(crest_height(profile))));
    return exit;
}

// ---- type C

GroundPoint exit_below_crest(const Profile& profile, const SourceSpec& spec) {
    const double crest = crest_height(profile);
    if (!given(spec.height)) {
        const bool exit_is_given = spec.datum == DropDatum::base;
        return exit_is_given ? given_exit(profile, spec) : at_vertex(profile.ground, profile.toe);
    }
    if (spec.height > crest * (1 + 1e-9))
        refuse(spec, &SourceSpec::height, "puts the lower end of the source below the toe",
               fmt::format("give at most {} m, the height of the crest", figure(crest)));
    return on_face(profile, spec, crest - spec.height, &SourceSpec::height, "the lower end of the source");
}

/// Type C is placed by its height and its area; a drop height may repeat what follows from them.
void require_drop_height_agrees(const SourceSpec& spec, const Source& source) {
    if (!given(spec.drop_height) || agree(spec.drop_height, source.drop_height)) return;
    refuse(spec, &SourceSpec::drop_height, "contradicts the other measures of the source",
           fmt::format("leave it out or give {} m, which follows from them", figure(source.drop_height)));
}

}  // namespace

Source derive_b(const Profile& profile, const SourceSpec& spec) {
    require_face(profile, spec);
    require_base_and_scarp(spec);
    if (apex_is_given(spec)) return derive_b_below_apex(profile, spec);
    const GroundPoint given_at = given_exit(profile, spec);
    require_angles_around_face(spec, position(profile.ground, given_at), profile.ground[profile.crest]);
    const GroundPoint exit = where_base_goes_in(profile, spec, given_at);
    return finished(profile, spec, exit, apex_of(profile, spec, exit));
}

Source derive_c(const Profile& profile, const SourceSpec& spec) {
    require_face(profile, spec);
    require_base_and_scarp(spec);
    const double area =
        required(spec, &SourceSpec::area, "give the area of the source, which places the back scarp");
    if (profile.crest == 0)
        refuse(spec, "source.type",
               fmt::format("C needs ground behind the crest, and {} ends there", profile.origin),
               "give a longer section, or a source of type B");
    const GroundPoint given_at = exit_below_crest(profile, spec);
    require_angles_around_face(spec, position(profile.ground, given_at), profile.ground[profile.crest]);
    const GroundPoint exit = where_base_goes_in(profile, spec, given_at);

    const GroundPoint crest = at_vertex(profile.ground, profile.crest);
    const GroundPoint end = at_vertex(profile.ground, 0);
    const Planes planes(profile, spec);
    const auto area_below = [&](const GroundPoint& top) { return planes.area(exit, top); };
    const double least = connected_mass(profile, spec, exit, crest).area();
    const auto top = area > least ? point_with_area(walk(crest, end), area_below, area) : std::nullopt;
    if (!top && !(area_below(end) > least))
        refuse(spec, &SourceSpec::area, "cannot be had: base and back scarp cut off nothing behind the crest",
               "give a flatter source.base_angle_deg, a steeper source.scarp_angle_deg or a longer section");
    if (!top)
        refuse(spec, &SourceSpec::area,
               area > least ? "is more than base and back scarp cut off on this section"
                            : "puts the back scarp on the face and not behind the crest",
               fmt::format("give more than {} and at most {} m2", figure(least), figure(area_below(end))));
    const SourceSpec without_height = [&] {
        SourceSpec s = spec;
        s.height = SourceSpec::unset;  // here height and area are both needed and do not exclude each other
        return s;
    }();
    const Source source = finished(profile, without_height, exit, *top);
    require_drop_height_agrees(spec, source);
    return source;
}

}  // namespace runout
