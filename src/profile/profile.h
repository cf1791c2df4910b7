#pragma once

#include <limits>
#include <string>

#include "core/geometry.h"

namespace runout {

/// The ground surface along a section, in a local frame: the toe of the cut is the origin, x grows in the
/// direction of run-out, y upwards. `ground` runs from the uphill end to the distal end, x never decreases,
/// and a vertical face is two points with the same x. There is no overhang and no repeated point.
///
/// Differences to the toe are taken once, so map-grid chainages of 10^6 m lose nothing in what follows.
struct Profile {
    Polyline ground;
    std::size_t crest = 0;  ///< index of the upper edge of the cut in `ground`; <= toe
    std::size_t toe = 0;    ///< index of the foot of the cut; ground[toe] is (0, 0)

    double toe_chainage_m = 0;
    double toe_elevation_m = 0;
    bool descends_with_chainage = true;  ///< false: the section was mirrored to run out towards +x

    std::string origin;  ///< file (and line feature) it came from

    /// Local point -> (chainage, elevation) of the file.
    [[nodiscard]] Vec2 to_section(const Vec2& local) const;
    /// (chainage, elevation) of the file -> local point.
    [[nodiscard]] Vec2 to_local(const Vec2& section) const;
    /// Mean inclination of the cut from toe to crest, radians; pi/2 for a vertical face, 0 where there is no face.
    [[nodiscard]] double slope_angle() const;
};

/// What the user may say about a section beyond its points. NaN = found on the profile.
struct ProfileOptions {
    double toe_chainage_m = std::numeric_limits<double>::quiet_NaN();
    double crest_chainage_m = std::numeric_limits<double>::quiet_NaN();
};

/// Profile from (chainage, elevation) points in file order, chainage never decreasing. Finds the direction of
/// descent, the toe and the crest. `place_of(i)`-style line numbers come with the points for error messages.
/// Throws InputError: fewer than two points, overhang, repeated point, no descent, toe or crest not on the section.
Profile make_profile(const std::vector<Vec2>& points, const std::vector<int>& lines, const std::string& file,
                     const ProfileOptions& options);

/// CSV with a header naming `chainage_m` and `elevation_m` (any order; `#` starts a comment). Throws InputError.
Profile read_profile_csv(const std::string& path, const ProfileOptions& options);

/// Elevations sampled on a line across a raster. Throws InputError.
struct DemLine {
    std::string raster;      ///< any GDAL raster
    std::string line;        ///< any GDAL vector data set with one line feature
    double sampling_m = 0;   ///< distance between samples; 0: half a raster cell
};
Profile read_profile_dem(const DemLine& dem, const ProfileOptions& options);

}  // namespace runout
