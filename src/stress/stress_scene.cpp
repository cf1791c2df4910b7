#include "stress/stress_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/units.h"
#include "scene/rest_check.h"
#include "stress/hillside.h"

namespace runout {
namespace {

constexpr double sliver_angle_deg = 1.0;
constexpr double lowest_elevation = -400.0;       // m, of ground as it is
constexpr double steepest_slide = radians(80.0);  // of a face; down a steeper one soil rather falls

template <class Choice>
Choice chosen(double value) {
    const int last = static_cast<int>(Choice::count) - 1;
    return static_cast<Choice>(std::clamp(static_cast<int>(value), 0, last));
}

Effects effects_of(const StressPoint& p) {
    Effects effects;
    if (p.base_friction_share < 1)
        effects.base_friction = BaseFriction{radians(p.base_friction_share * p.friction_angle_deg)};
    return effects;
}

/// sin(phi), or the tangent of the friction angle of the base where that is less.
double strength_on_bed(const StressPoint& p) {
    const double own = std::sin(radians(p.friction_angle_deg));
    const auto base = effects_of(p).base_friction;
    return base ? std::min(own, std::tan(base->angle)) : own;
}

double face_angle(const StressPoint& p, SourceKind kind) {
    if (kind == SourceKind::column) return std::numbers::pi / 2;
    return radians(p.slope_angle_deg);
}

/// Height of the ground that a source of this kind takes, over sqrt(S).
double height_of_source(const StressPoint& p, SourceKind kind) {
    switch (kind) {
        case SourceKind::column:
            return 1.2 * std::sqrt(p.aspect_ratio);
        case SourceKind::falling_block:
            return 0.5;
        case SourceKind::sheet:
            return 0.2;
        default:
            return 2.0;
    }
}

/// Long enough by the energy line from the crest to the tip of the debris, which goes further than the middle
/// of it does, and for a heap that spreads on level ground. `reach`: of the tip over that of the energy line.
double run_out_length(const StressPoint& p, double height, double reach) {
    const double strength = std::max(strength_on_bed(p), 0.01);
    const double repose = std::atan(strength);
    const double fall = p.run_out_slope_share * repose;
    const double stopping = strength - std::tan(std::max(fall, 0.0));
    return reach * height / stopping + 10 * p.size_m / std::sqrt(strength);
}

Hillside hillside_of(const StressPoint& p, SourceKind kind) {
    Hillside h;
    h.shape = kind == SourceKind::column ? HillsideShape::plain : chosen<HillsideShape>(p.hillside_shape);
    h.face_angle = face_angle(p, kind);
    const bool falls_from_height = kind != SourceKind::column;
    const double drop = falls_from_height && kind != SourceKind::falling_block ? p.drop_height_ratio : 0.0;
    h.height = p.size_m * std::max(drop, height_of_source(p, kind));
    // What lies on the crest and is pressed back slides there as far as its strength lets it.
    h.bench = p.size_m * std::max(30.0, 3.0 / std::max(strength_on_bed(p), 0.01));
    h.detail = p.detail_ratio * p.size_m;
    if (h.shape == HillsideShape::steps) h.detail = p.size_m / p.resolution;  // at the scale of a particle
    const double fall = kind == SourceKind::falling_block ? p.drop_height_ratio * p.size_m : 0.0;
    // What falls on level ground splashes both ways, in jets of up to twice the speed of the fall.
    const bool falls = kind == SourceKind::falling_block || h.face_angle > steepest_slide;
    h.run_out_length = run_out_length(p, h.height + fall + fall_of_steps(h), falls ? 5.0 : 2.5);
    if (kind == SourceKind::falling_block) h.bench = h.run_out_length;
    h.run_out_angle = p.run_out_slope_share * std::atan(strength_on_bed(p));
    return h;
}

/// Where the local frame of the hillside lies in the section.
struct SectionFrame {
    double offset;
    double direction;
    double datum;  ///< elevation of the toe, m

    Vec2 operator()(const Vec2& local) const { return {offset + direction * local.x(), datum + local.y()}; }
};

/// Whole thousands of metres by which ground that falls far is raised, so that its elevations could be some
/// on earth.
double datum_of(const std::vector<Vec2>& ground) {
    const double lowest = std::ranges::min(ground, {}, [](const Vec2& p) { return p.y(); }).y();
    return lowest < lowest_elevation ? 1000.0 * std::ceil(-lowest / 1000.0) : 0.0;
}

/// A block whose lower left corner and size are given in the local frame.
SourceSpec block(const SectionFrame& in_section, const Vec2& corner, double width, double height) {
    SourceSpec spec;
    spec.type = SourceType::polygon;
    std::vector<Vec2> corners = {corner, corner + Vec2(width, 0), corner + Vec2(width, height),
                                 corner + Vec2(0, height)};
    for (Vec2& c : corners) c = in_section(c);
    spec.points = section_points(corners);
    return spec;
}

/// Its head at the crest.
SourceSpec box(const StressPoint& p, double aspect) {
    SourceSpec spec;
    spec.type = SourceType::rectangle;
    spec.length = p.size_m * std::sqrt(aspect);
    spec.thickness = p.size_m / std::sqrt(aspect);
    return spec;
}

SourceSpec dipping(const StressPoint& p, SourceType type, double dip_deg) {
    SourceSpec spec;
    spec.type = type;
    spec.base_angle = radians(dip_deg);
    spec.area = p.size_m * p.size_m;
    const double face_deg = p.slope_angle_deg;
    if (type != SourceType::a) spec.scarp_angle = radians(face_deg + p.scarp_angle_share * (90.0 - face_deg));
    if (type == SourceType::a) spec.aspect = std::clamp(p.aspect_ratio, 1.0, 3.0);
    if (type == SourceType::c) spec.height = 1.5 * p.size_m;
    return spec;
}

SourceSpec source_of(const StressPoint& p, SourceKind kind, const SectionFrame& in_section) {
    const double size = p.size_m;
    const double dip_deg = p.base_angle_share * p.slope_angle_deg;
    switch (kind) {
        case SourceKind::rectangle:
            return box(p, std::clamp(p.aspect_ratio, 0.3, 3.0));
        case SourceKind::sheet:
            return box(p, std::clamp(p.aspect_ratio, 20.0, 50.0));
        case SourceKind::a:
            return dipping(p, SourceType::a, dip_deg);
        case SourceKind::c:
            return dipping(p, SourceType::c, dip_deg);
        case SourceKind::sliver:
            return dipping(p, SourceType::b,
                           p.slope_angle_deg - sliver_angle_deg * (0.2 + 0.8 * p.base_angle_share));
        case SourceKind::column:
            return block(in_section, {0, 0}, size / std::sqrt(p.aspect_ratio),
                         size * std::sqrt(p.aspect_ratio));
        case SourceKind::falling_block:
            return block(in_section, {2 * size, p.drop_height_ratio * size}, size, size);
        case SourceKind::b:
            return dipping(p, SourceType::b, dip_deg);
        case SourceKind::count:
            break;
    }
    throw std::logic_error("no kind of source");
}

}  // namespace

std::string to_string(SourceKind kind) {
    constexpr std::array names = {"rectangle", "A", "B", "C", "sliver", "sheet", "column", "falling_block"};
    return names.at(static_cast<std::size_t>(kind));
}

StressSite stress_site(const StressPoint& p) {
    const auto kind = chosen<SourceKind>(p.source_kind);
    const std::vector<Vec2> ground = ground_of(hillside_of(p, kind));
    const SectionFrame in_section{p.offset_m, p.reversed < 1 ? 1.0 : -1.0, datum_of(ground)};
    StressSite site;
    for (const Vec2& point : ground) site.section.push_back(in_section(point));
    if (in_section.direction < 0) std::ranges::reverse(site.section);
    site.face.toe_chainage = Chainage(p.offset_m);
    site.face.crest_chainage = Chainage(in_section(ground[1]).x());
    site.source = source_of(p, kind, in_section);
    site.free = kind == SourceKind::falling_block || kind == SourceKind::column;
    return site;
}

Scene stress_scene(const StressPoint& p, const std::string& name) {
    const StressSite site = stress_site(p);
    Scene scene;
    scene.name = name;
    scene.profile = make_profile({site.section, {}, name}, site.face);
    scene.source = derive_source(scene.profile, site.source);
    scene.material.friction_angle = radians(p.friction_angle_deg);
    scene.effects = effects_of(p);
    scene.run.resolution = p.resolution;
    scene.run.gravity = p.gravity_m_s2;
    scene.run.threads = 1;
    check_comes_to_rest(scene, [&](std::string_view key) {
        return InputPlace{.file = name, .line = 0, .key = std::string(key), .value = {}};
    });
    return scene;
}

}  // namespace runout
