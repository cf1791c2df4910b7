#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "core/section_point.h"
#include "gis/elevation_raster.h"
#include "gis/map_line.h"
#include "gis/section_line.h"
#include "profile/section_points.h"

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

    double slope_angle = 0;  ///< mean inclination of the cut from toe to crest, rad; pi/2 for a vertical
                             ///< face, 0 where there is no face

    double toe_chainage_m = 0;
    double toe_elevation_m = 0;
    bool descends_with_chainage = true;  ///< false: the section was mirrored to run out towards +x

    std::string origin;      ///< file (and line feature) it came from
    std::string read_as;     ///< as SectionPoints has it
    bool toe_given = false;  ///< by the user; else found
    bool crest_given = false;
    std::vector<std::string> doubts;  ///< what to know of how toe and crest were chosen, a sentence each
    std::optional<MapLine> map_line;  ///< where the section lies; none where nothing says so

    /// A point of the section's file in the local frame: the way in.
    [[nodiscard]] Vec2 to_local(const SectionPoint& section) const;
    /// A local point as (chainage, elevation) of the file, two numbers to print, draw or store: the way out.
    [[nodiscard]] Vec2 to_section(const Vec2& local) const;
    /// The chainage of a local x.
    [[nodiscard]] Chainage chainage_at(double x) const;
};

/// What the user may say about a section beyond its points. Not known: found on the profile.
///
/// How toe and crest are found: find_faces() and placed_ends(). A section without a face (a flat bed) has
/// toe and crest at its uphill end. A given chainage replaces the search, which then stays uphill of a given
/// toe and downhill of a given crest; it means the nearest point of the section within 5 cm or 0.2 % of the
/// relief, whichever is more (but 1 % of the relief at most), or else a point is put in. On a vertical face
/// the toe is its lower point and the crest its upper one.
struct ProfileOptions {
    Chainage toe_chainage;
    Chainage crest_chainage;
};

/// Profile from points whose chainage never decreases. The section descends from a given crest to a given
/// toe, or else the way its heavier face does; without a face from its higher end to its lower one; a flat
/// one runs out with the chainage. Of three or more points of one vertical face the inner ones are dropped.
/// Throws InputError: fewer than two points, a coordinate that is not finite or beyond 1e8 m, overhang,
/// repeated point (within 1e-7 m), a step up and down at one chainage, no descent, toe or crest not on the
/// section.
Profile make_profile(const SectionPoints& section, const ProfileOptions& options);

/// A section that a map gives: a line across a raster, or a line with elevations of its own.
struct MapSection {
    std::string raster{};     ///< any GDAL raster; empty: the line is three-dimensional
    LineQuery line{};         ///< which line; it must be one
    double sampling_m = 0;    ///< distance between samples of the raster; 0: half a cell
    double smoothing_m = 0;   ///< width of the window of smooth_elevations; 0: none
    RasterOptions options{};  ///< of the raster; the unit of elevation holds for a line too
    bool zero_is_ground =
        false;  ///< a lone elevation of 0 on a three-dimensional line is right, and not a filler
};

/// Profile along the line, chainage in metres from its first point. A raster is sampled evenly from end to
/// end; a three-dimensional line gives its vertices. Attributes stand for options that are not given
/// (profile/line_attributes.h). What smoothing changed is told in `origin`. Throws InputError: whatever
/// read_section_line, ElevationRaster, line_elevations, with_attributes and make_profile refuse.
Profile read_map_section(const MapSection& section, const ProfileOptions& options);

/// One of the features that a query asks for.
struct SectionFeature {
    LineFeature feature;  ///< may be refused
    std::string label;    ///< attribute name, label, section, slope_no, slope or id; else the feature id
    bool named = false;   ///< by an attribute
};

/// Throws InputError as list_section_lines.
std::vector<SectionFeature> section_features(const LineQuery& query);

/// What smoothing did to a section.
struct Smoothing {
    double greatest_change_m = 0;
    double greatest_change_chainage_m = 0;
    double rms_change_m = 0;
    double steepest_before = 0;  ///< inclination of the steepest segment, rad
    double steepest_after = 0;
};

/// Replaces each elevation by that of a straight line fitted around it: least squares, weights (1 - |u|^3)^3
/// over a window of this width (local regression, Cleveland 1979). A plane stays as it is, at the ends too;
/// edges are rounded. Points (chainage, elevation) of rising chainage.
Smoothing smooth_elevations(std::vector<Vec2>& points, double window_m);

}  // namespace runout
