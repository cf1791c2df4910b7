#include "profile/profile.h"

#include <cmath>

#include "profile/checked_points.h"
#include "profile/place_face.h"

namespace runout {
namespace {

/// A coordinate of almost nothing is nothing: exact arithmetic on numbers near the smallest double leaves its
/// intervals.
Vec2 without_dust(const Vec2& p) {
    constexpr double dust_m = 1e-12;
    return {std::abs(p.x()) < dust_m ? 0.0 : p.x(), std::abs(p.y()) < dust_m ? 0.0 : p.y()};
}

}  // namespace

Vec2 Profile::to_section(const Vec2& local) const {
    return {chainage_at(local.x()).m, toe_elevation_m + local.y()};
}

Chainage Profile::chainage_at(double x) const {
    return Chainage(toe_chainage_m + (descends_with_chainage ? x : -x));
}

Vec2 Profile::to_local(const SectionPoint& section) const {
    const double along = section.chainage - Chainage(toe_chainage_m);
    return {descends_with_chainage ? along : -along, section.elevation - toe_elevation_m};
}

Profile make_profile(const SectionPoints& section, const ProfileOptions& options) {
    PlacedFace placed = place_face(checked_points(section), options, section.origin);
    Profile profile;
    profile.origin = section.origin;
    profile.read_as = section.read_as;
    profile.map_line = section.map_line;
    profile.toe_given = options.toe_chainage.is_known();
    profile.crest_given = options.crest_chainage.is_known();
    profile.doubts = std::move(placed.doubts);
    profile.descends_with_chainage = placed.descends_with_chainage;
    profile.crest = placed.ends.crest;
    profile.toe = placed.ends.toe;
    profile.slope_angle = placed.inclination;

    const Vec2 toe = placed.ground[profile.toe];
    const double sign = profile.descends_with_chainage ? 1.0 : -1.0;
    profile.toe_chainage_m = sign * toe.x() + 0.0;  // + 0.0: a mirrored zero is not to print as -0
    profile.toe_elevation_m = toe.y();
    for (Vec2& p : placed.ground) p = without_dust(p - toe);
    profile.ground = std::move(placed.ground);
    return profile;
}

}  // namespace runout
