#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "profile/profile.h"
#include "profile/read_section_table.h"
#include "said.h"
#include "source/source.h"

// Sections, descriptions of sources, and what every source must satisfy.

namespace runout {

inline constexpr double face_angle = radians(70);
inline constexpr double base_angle = radians(35);
inline constexpr double scarp_angle = radians(80);

inline std::string error_of(const Profile& profile, const SourceSpec& spec) {
    return input_error([&] { derive_source(profile, spec); });
}

inline Profile profile_of(const std::vector<Vec2>& points) {
    return make_profile({points, {}, "section.csv"}, {});
}

/// A straight face between level ground.
inline Profile cut(double angle, double height, double back, double out) {
    const double width = height / std::tan(angle);
    return profile_of({{-back - width, height}, {-width, height}, {0, 0}, {out, 0}});
}

inline Profile shipped(const std::string& name) {
    return make_profile(read_section_table(RUNOUT_SOURCE_DIR "/profiles/" + name, {}), {});
}

inline SourceSpec type_b() {
    SourceSpec spec;
    spec.type = SourceType::b;
    spec.base_angle = base_angle;
    spec.scarp_angle = scarp_angle;
    return spec;
}

inline SourceSpec fig15() {
    SourceSpec spec = type_b();
    spec.type = SourceType::c;
    spec.height = 0.15;
    spec.area = 0.0043;
    return spec;
}

inline SourceSpec box(double length, double thickness) {
    SourceSpec spec;
    spec.type = SourceType::rectangle;
    spec.length = length;
    spec.thickness = thickness;
    return spec;
}

/// `points` are (chainage, elevation).
inline SourceSpec free_shape(SourceType type, const std::vector<Vec2>& points) {
    SourceSpec spec;
    spec.type = type;
    spec.points = section_points(points);
    return spec;
}

/// Triangle on a face of angle a whose third side is `side` long, with angles a - base and scarp - a beside
/// it.
inline double triangle_area(double side, double base, double face, double scarp) {
    return side * side / 2 * std::sin(face - base) * std::sin(scarp - face) / std::sin(scarp - base);
}

inline double area_below(const Polyline& line) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        sum += (line[i + 1].x() - line[i].x()) * (line[i + 1].y() + line[i].y()) / 2;
    return sum;
}

inline double signed_area(const Polygon& p) {
    double twice = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2& a = p[i];
        const Vec2& b = p[(i + 1) % p.size()];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return twice / 2;
}

inline double distance_to_corner(const Polygon& outline, const Vec2& p) {
    double nearest_corner = 1e300;
    for (const Vec2& q : outline) nearest_corner = std::min(nearest_corner, (p - q).norm());
    return nearest_corner;
}

inline void expect_bed_is_a_ground(const Source& source, const Profile& profile) {
    EXPECT_EQ(source.bed.front(), profile.ground.front());
    EXPECT_EQ(source.bed.back(), profile.ground.back());
    for (std::size_t i = 0; i + 1 < source.bed.size(); ++i) {
        EXPECT_LE(source.bed[i].x(), source.bed[i + 1].x());
        EXPECT_NE(source.bed[i], source.bed[i + 1]);
    }
}

/// The mass is ground: what it holds is missing in the bed.
inline void expect_cut_from_ground(const Source& source, const Profile& profile) {
    expect_bed_is_a_ground(source, profile);
    const double missing = area_below(profile.ground) - area_below(source.bed);
    EXPECT_NEAR(missing, source.area, 1e-12 * std::abs(area_below(profile.ground)));
    EXPECT_NEAR(signed_area(source.outline), source.area, 1e-12 * std::max(1.0, source.area));
}

}  // namespace runout
