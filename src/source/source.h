#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "core/input_error.h"
#include "core/section_point.h"
#include "core/units.h"
#include "profile/profile.h"

namespace runout {

/// Shapes of the moving mass, as in the paper's Figs 9 and 13. What is to be known of each is a row of
/// source_types().
enum class SourceType { rectangle, a, b, c, polygon, slip_surface };

/// Which point of the source the drop height is measured to: `head`, or `base`, where it daylights
/// (exit_point).
enum class DropDatum { head, base };

/// What the user says about the source. NaN = not given. SI and radians.
struct SourceSpec {
    static constexpr double unset = std::numeric_limits<double>::quiet_NaN();
    SourceType type = SourceType::b;
    double base_angle = unset;   ///< alpha_sr, dip of the basal slip surface (A, B, C)
    double scarp_angle = unset;  ///< alpha_back, inclination of the back scarp (B, C)
    double area = unset;         ///< m2
    double height = unset;       ///< B: P to apex; C: P to crest; m, vertical
    double length = unset;       ///< rectangle, A: L0 along the base, m
    double thickness = unset;    ///< rectangle, A: H0 normal to the base, m
    double aspect = unset;       ///< rectangle, A: L0/H0
    double drop_height = unset;  ///< H_d above the toe, m, to the point named by `datum`
    DropDatum datum = DropDatum::head;
    double discontinuity_angle = radians(55.0);  ///< theta_id
    std::vector<SectionPoint> points;            ///< polygon corners, or slip line from end to end

    /// Where each key stands ("source.height_m" -> file, line, value as written), for error messages. A key
    /// that is not listed is named without file and line, its value printed in the units of the case file.
    std::map<std::string, InputPlace> places;
};

/// The moving mass and the bed it leaves, local frame of the profile.
struct Source {
    SourceType type = SourceType::b;
    Polygon outline;
    Polyline bed;     ///< ground left when the source has gone: uphill end to distal end, x never decreases
    double area = 0;  ///< S_0, exact polygon area rounded once, m2
    double front_area =
        0;  ///< S_front, part above the line through `exit_point` at the discontinuity angle, m2
    double discontinuity_angle = 0;
    Vec2 exit_point{0, 0};   ///< P, where the slip surface or base daylights on the face
    Vec2 head{0, 0};         ///< upper end of the source on the ground: datum of reach angle and of H_d
    double drop_height = 0;  ///< H_d above the toe to the datum, m
    DropDatum datum = DropDatum::head;
};

/// Derives outline, areas and remaining bed with CGAL's exact kernel. What each type needs, where it is
/// placed when no drop height is given, and what is refused: docs/source-shapes.md. Throws InputError when
/// the data are missing, exclude each other or are not used by the type, or when the shape leaves the
/// hillside.
Source derive_source(const Profile& profile, const SourceSpec& spec);

/// As case files have it; throws InputError for a value that is no type.
std::string to_string(SourceType type);
std::string to_string(DropDatum datum);

}  // namespace runout
