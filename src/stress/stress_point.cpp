#include "stress/stress_point.h"

#include <cmath>

#include "stress/hillside.h"
#include "stress/stress_scene.h"
#include "study/distribution.h"

namespace runout {

std::vector<StressAxis> stress_axes() {
    using P = StressPoint;
    constexpr double kinds = static_cast<double>(SourceKind::count);
    constexpr double shapes = static_cast<double>(HillsideShape::count);
    return {
        {"source_kind", &P::source_kind, 0, kinds, false,
         "box, A, B, C, sliver, sheet, column, falling block: by the whole part"},
        {"hillside_shape", &P::hillside_shape, 0, shapes, false,
         "plain, retaining wall, concave toe, convex crest, berms, notch, steps: by the whole part"},
        {"slope_angle_deg", &P::slope_angle_deg, 20, 90, false, "inclination of the face"},
        {"friction_angle_deg", &P::friction_angle_deg, 5, 60, false, "internal friction angle"},
        {"base_friction_share", &P::base_friction_share, 0, 3, false,
         "friction angle of the base over internal; 1 and more: none of its own"},
        {"drop_height_ratio", &P::drop_height_ratio, 0.5, 50, true, "drop height over sqrt(S)"},
        {"aspect_ratio", &P::aspect_ratio, 0.3, 50, true,
         "length over thickness; of columns height over width"},
        {"base_angle_share", &P::base_angle_share, 0.1, 0.95, false,
         "dip of the slip surface over slope angle"},
        {"scarp_angle_share", &P::scarp_angle_share, 0.1, 0.95, false,
         "inclination of the back scarp, from that of the face to the vertical"},
        {"run_out_slope_share", &P::run_out_slope_share, -1, 0.7, false,
         "inclination of the run-out bed over the angle of repose on it; negative rises"},
        {"detail_ratio", &P::detail_ratio, 0.05, 2, true,
         "size of wall, arc, berm, notch or step over sqrt(S)"},
        {"size_m", &P::size_m, 0.03, 30, true, "sqrt(S)"},
        {"gravity_m_s2", &P::gravity_m_s2, 1, 9810, true, "gravity"},
        {"resolution", &P::resolution, 5, 12, true, "sqrt(S) over particle spacing", 64},
        {"reversed", &P::reversed, 0, 2, false, "from 1: the section descends against its chainage"},
        {"offset_m", &P::offset_m, -1e6, 1e6, false, "chainage of the upper end"},
    };
}

std::vector<StressPoint> stress_points(std::span<const StressAxis> axes, int count, std::uint64_t seed) {
    const auto dimensions = static_cast<Eigen::Index>(axes.size());
    const Eigen::MatrixXd cube =
        latin_hypercube(count, Eigen::MatrixXd::Identity(dimensions, dimensions), seed);
    std::vector<StressPoint> points(static_cast<std::size_t>(count));
    for (std::size_t k = 0; k < points.size(); ++k) {
        for (std::size_t d = 0; d < axes.size(); ++d) {
            const StressAxis& axis = axes[d];
            const double at = cube(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(d));
            points[k].*axis.value = axis.logarithmic ? axis.low * std::pow(axis.high / axis.low, at)
                                                     : axis.low + at * (axis.high - axis.low);
        }
    }
    return points;
}

}  // namespace runout
