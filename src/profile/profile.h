#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

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
    /// Mean inclination of the cut from toe to crest, radians; pi/2 for a vertical face, 0 where there is no
    /// face.
    [[nodiscard]] double slope_angle() const;
};

/// What the user may say about a section beyond its points. NaN = found on the profile.
///
/// How toe and crest are found: a segment belongs to the face when it descends at least half as steeply as
/// the steepest segment flatter than 85 deg, and at 15 deg or more (45 deg where only vertical steps
/// descend). The toe is the lower end of the most downhill such segment, the crest the upper end of the most
/// uphill one, so a berm between two batters and a wall at the foot are part of the cut. A section without
/// such a segment (a flat bed) has toe and crest at its uphill end. A given chainage replaces the search,
/// which then stays uphill of a given toe and downhill of a given crest; a point is inserted where the
/// section has none. On a vertical face the toe is its lower point and the crest its upper one.
struct ProfileOptions {
    double toe_chainage_m = std::numeric_limits<double>::quiet_NaN();
    double crest_chainage_m = std::numeric_limits<double>::quiet_NaN();
};

/// Profile from (chainage, elevation) points in file order, chainage never decreasing. The section descends
/// from its higher end to its lower one, or from a given crest to a given toe; a flat one runs out with the
/// chainage. `lines[i]` is the line of points[i] in `file` for error messages (may be empty). Of three or
/// more points of one vertical face the inner ones are dropped. Throws InputError: fewer than two points, a
/// coordinate that is not finite or beyond 1e8 m, overhang, repeated point (within 1e-7 m), a step up and
/// down at one chainage, no descent, toe or crest not on the section.
Profile make_profile(const std::vector<Vec2>& points, const std::vector<int>& lines, const std::string& file,
                     const ProfileOptions& options);

/// CSV with a header naming `chainage_m` and `elevation_m` (any order), metres. `#` starts a comment; blank
/// lines, a byte-order mark and CRLF are accepted. Throws InputError, with the line: unreadable or empty
/// file, unknown, repeated or missing column, wrong number of fields, text or NaN in a number, and whatever
/// make_profile refuses.
Profile read_profile_csv(const std::string& path, const ProfileOptions& options);

/// Elevations sampled on a line across a raster.
struct DemLine {
    std::string raster;     ///< any GDAL raster
    std::string line;       ///< any GDAL vector data set with one line feature
    double sampling_m = 0;  ///< distance between samples; 0: half a raster cell
};

/// Profile along the first feature of the line, brought to the raster's coordinate system where both name
/// one; elevations (band 1, metres) by bilinear interpolation between cell centres, chainage from the line's
/// first point. Throws InputError: unreadable raster or line, geometry that is not a line, raster in degrees,
/// line leaving the raster or crossing a cell without data, and whatever make_profile refuses.
Profile read_profile_dem(const DemLine& dem, const ProfileOptions& options);

}  // namespace runout
