#pragma once

#include <cmath>
#include <compare>
#include <limits>
#include <vector>

#include "core/geometry.h"

namespace runout {

/// Distance along a section from where its file counts, m. It is not an x of the local frame, which counts
/// from the toe in the direction of run-out: the two are of different types, so that one cannot stand for the
/// other, and a Profile turns a chainage into an x once, on the way in.
struct Chainage {
    double m = std::numeric_limits<double>::quiet_NaN();

    constexpr Chainage() = default;  ///< not known
    constexpr explicit Chainage(double metres) : m(metres) {}

    [[nodiscard]] bool is_known() const { return !std::isnan(m); }

    /// One that is not known is neither before nor behind another.
    friend constexpr auto operator<=>(const Chainage&, const Chainage&) = default;
    /// m from b to a.
    friend constexpr double operator-(const Chainage& a, const Chainage& b) { return a.m - b.m; }
};

/// A point in the coordinates of the section's file. A Vec2 is a point of the local frame, or of a map.
struct SectionPoint {
    Chainage chainage;
    double elevation = std::numeric_limits<double>::quiet_NaN();  ///< m

    constexpr SectionPoint() = default;
    constexpr SectionPoint(Chainage along, double height) : chainage(along), elevation(height) {}
    /// As a case file writes it: {41.5, 12}, metres.
    constexpr SectionPoint(double chainage_m, double elevation_m)
        : chainage(chainage_m), elevation(elevation_m) {}

    friend constexpr bool operator==(const SectionPoint&, const SectionPoint&) = default;
};

/// Of pairs (chainage, elevation), as files and drawings have them.
inline std::vector<SectionPoint> section_points(const std::vector<Vec2>& pairs) {
    std::vector<SectionPoint> points;
    points.reserve(pairs.size());
    for (const Vec2& pair : pairs) points.emplace_back(pair.x(), pair.y());
    return points;
}

}  // namespace runout
