#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace runout {

/// One random scene in numbers, every one of them in the range of its axis. Choices are numbers too, so that
/// they are spread as evenly as the rest.
struct StressPoint {
    double source_kind = 0;          ///< SourceKind
    double hillside_shape = 0;       ///< HillsideShape
    double slope_angle_deg = 0;      ///< of the face
    double friction_angle_deg = 0;   ///< phi
    double base_friction_share = 0;  ///< delta / phi; 1 and more: no friction of the base
    double drop_height_ratio = 0;    ///< H_d / sqrt(S)
    double aspect_ratio = 0;         ///< L0/H0 of boxes, H0/L0 of columns
    double base_angle_share = 0;     ///< alpha_sr / slope angle
    double scarp_angle_share = 0;    ///< of the way from the slope angle to 90 deg
    double run_out_slope_share = 0;  ///< inclination of the run-out bed / angle of repose on it
    double detail_ratio = 0;         ///< size of wall, arc, berm, notch or step / sqrt(S)
    double size_m = 0;               ///< sqrt(S)
    double gravity_m_s2 = 0;
    double resolution = 0;  ///< sqrt(S) / dl
    double reversed = 0;    ///< from 1: the section descends against its chainage
    double offset_m = 0;    ///< chainage of the crest
};

/// One axis of the space of scenes.
struct StressAxis {
    std::string_view name;
    double StressPoint::*value;
    double low;
    double high;
    bool logarithmic;
    std::string_view meaning;
    /// Highest that may be asked for, beyond the range of the suite.
    double most = high;
};

/// All axes with the ranges of the suite.
std::vector<StressAxis> stress_axes();

/// `count` scenes spread over the axes by a Latin hypercube; the same for the same seed.
std::vector<StressPoint> stress_points(std::span<const StressAxis> axes, int count, std::uint64_t seed);

}  // namespace runout
