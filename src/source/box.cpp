// Rectangles: on the face (type "rectangle") and with a base that dips into the hill (type A).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "source/shapes.h"
#include "source/spec_check.h"

namespace runout {
namespace {

struct BoxSize {
    double length = 0;
    double thickness = 0;
};

/// Length from any two of length, thickness, length/thickness and area.
double length_from(const SourceSpec& s) {
    if (given(s.length)) return s.length;
    if (given(s.thickness)) return given(s.aspect) ? s.aspect * s.thickness : s.area / s.thickness;
    return std::sqrt(s.area * s.aspect);
}

double thickness_from(const SourceSpec& s, double length) {
    if (given(s.thickness)) return s.thickness;
    return given(s.aspect) ? length / s.aspect : s.area / length;
}

void require_agreement(const SourceSpec& spec, SpecKey key, double follows) {
    if (!given(spec.*key) || agree(spec.*key, follows)) return;
    refuse(spec, key, "contradicts the other measures of the box",
           fmt::format("leave it out or give {}, which follows from them", figure(follows)));
}

BoxSize box_size(const SourceSpec& spec) {
    const int known = given(spec.length) + given(spec.thickness) + given(spec.aspect) + given(spec.area);
    if (known < 2)
        refuse(spec, "source.length_m",
               known == 0 ? "is missing, and so are its alternatives"
                          : "is missing, and one measure alone makes no box",
               "give two of source.length_m, source.thickness_m, source.aspect_ratio and source.area_m2");
    BoxSize size;
    size.length = length_from(spec);
    size.thickness = thickness_from(spec, size.length);
    require_agreement(spec, &SourceSpec::aspect, size.length / size.thickness);
    require_agreement(spec, &SourceSpec::area, size.length * size.thickness);
    return size;
}

double segment_length(const Polyline& ground, std::size_t i) {
    return (ground[i + 1] - ground[i]).norm();
}

/// The upper end of the base where the box begins at the top of a straight segment of the face.
GroundPoint head_of_face(const Profile& profile, const SourceSpec& spec) {
    if (!given(spec.drop_height)) return at_vertex(profile.ground, profile.crest);
    return on_face(profile, spec, spec.drop_height, &SourceSpec::drop_height, "the head of the source");
}

GroundPoint foot_of_box(const Profile& profile, const SourceSpec& spec, double length) {
    if (spec.datum == DropDatum::base && given(spec.drop_height))
        return on_segment_above(on_face(profile, spec, spec.drop_height, &SourceSpec::drop_height,
                                        "the lower end of the source"));
    const GroundPoint head = head_of_face(profile, spec);
    return {head.segment, head.fraction + length / segment_length(profile.ground, head.segment)};
}

void require_on_one_segment(const Profile& profile, const SourceSpec& spec, const GroundPoint& foot,
                            double length) {
    constexpr double rounding = 1e-12;
    const double whole = segment_length(profile.ground, foot.segment);
    const double head = foot.fraction - length / whole;
    if (head >= -rounding && foot.fraction <= 1 + rounding) return;
    const bool from_head = !(spec.datum == DropDatum::base && given(spec.drop_height));
    const double room = whole * (from_head ? 1 - head : foot.fraction);
    refuse(spec, &SourceSpec::length,
           fmt::format("makes the box {} m long, too long for the straight part of the face", figure(length)),
           fmt::format("at most {} m fit there, or give another source.drop_height_m",
                       figure(std::max(room, 0.0))));
}

/// The base of a type A must stay in the hill all the way.
void require_base_in_hill(const Profile& profile, const SourceSpec& spec, const Vec2& exit,
                          const Vec2& head) {
    const Polyline& ground = profile.ground;
    if (head.x() < ground.front().x())
        refuse(spec, "source.type", "A goes beyond the uphill end of the section",
               fmt::format("make the source shorter or the section longer than {} m uphill of the toe",
                           figure(-head.x())));
    const double slope = std::tan(spec.base_angle);
    const auto covered = [&](double x) {
        return elevation_at(ground, x) >= exit.y() + slope * (exit.x() - x) - 1e-12 * extent(ground);
    };
    bool inside = covered(head.x());
    for (const Vec2& p : ground)
        if (p.x() > head.x() && p.x() < exit.x()) inside = inside && covered(p.x());
    if (!inside)
        refuse(spec, &SourceSpec::base_angle, "lets the base come out of the hillside",
               "give a base flatter than the face, or a shorter source");
}

}  // namespace

Source derive_rectangle(const Profile& profile, const SourceSpec& spec) {
    require_face(profile, spec);
    const BoxSize size = box_size(spec);
    const GroundPoint foot = foot_of_box(profile, spec, size.length);
    require_on_one_segment(profile, spec, foot, size.length);

    const Polyline& ground = profile.ground;
    const double whole = segment_length(ground, foot.segment);
    const Region region = box_on_ground(ground, foot, size.length / whole, size.thickness / whole);
    const Vec2 exit = corner_at(ground, foot);
    const Vec2 head = corner_at(ground, {foot.segment, foot.fraction - size.length / whole});
    return source_from(region, profile, spec, exit, head);
}

Source derive_a(const Profile& profile, const SourceSpec& spec) {
    require_face(profile, spec);
    const double dip =
        required(spec, &SourceSpec::base_angle, "give the dip of the basal slip surface, such as 35");
    const BoxSize size = box_size(spec);
    const bool head_given = given(spec.drop_height) && spec.datum == DropDatum::head;
    const double rise = size.length * std::sin(dip);
    const double exit_height = !given(spec.drop_height) ? 0.0 : spec.drop_height - (head_given ? rise : 0.0);
    const GroundPoint foot = on_segment_above(
        on_face(profile, spec, exit_height, &SourceSpec::drop_height, "the lower end of the source"));

    const Vec2 exit = corner_at(profile.ground, foot);
    const double face = inclination(profile.ground, foot.segment);
    if (dip >= face)
        refuse(spec, &SourceSpec::base_angle, "is not flatter than the face",
               fmt::format("give less than {} degrees", figure(degrees(face))));
    const Vec2 head = exit + size.length * Vec2(-std::cos(dip), std::sin(dip));
    require_base_in_hill(profile, spec, exit, head);
    return source_from(box_at_dip(profile.ground, foot, dip, size.length, size.thickness), profile, spec,
                       exit, head);
}

}  // namespace runout
