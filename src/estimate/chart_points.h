#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "store/chart_rows.h"

namespace runout {

/// What the run-out chart of the paper depends on: L/sqrt(S) = f(slope angle, H_d/sqrt(S), S_front/S, phi). S
/// is the area of the source, H_d the height of its head above the toe.
enum class ChartVariable { slope_angle, drop_height, front_area, friction_angle };
inline constexpr std::size_t chart_variables = 4;

struct ChartVariableText {
    const char* name;         ///< "slope angle"
    const char* key;          ///< as in the database and in JSON
    const char* unit;         ///< " deg", or nothing
    double least_difference;  ///< two values that are nearer than this are one
};
const ChartVariableText& text_of(ChartVariable variable);

/// A value of each variable in the order of ChartVariable, angles in degrees.
using ChartPlace = std::array<double, chart_variables>;

/// What is asked of a chart.
struct ChartQuestion {
    static constexpr double not_given = std::numeric_limits<double>::quiet_NaN();
    ChartPlace place{not_given, not_given, not_given, not_given};
    std::string effects;                         ///< of the case, as in ChartRow
    double discontinuity_angle_deg = not_given;  ///< that S_front is meant for; not given: that of the runs
};

/// The question that a scene asks.
ChartQuestion chart_question(const Scene& scene);

struct ChartPoint {
    long run_id = 0;
    ChartPlace place{};
    double run_out = 0;     ///< L/sqrt(S)
    double resolution = 0;  ///< sqrt(S)/dl
};

/// Runs that speak to a question, and how many do not, and why.
struct ChartPoints {
    std::vector<ChartPoint> points;
    std::size_t standing = 0;  ///< sources that stand have no run-out
    std::size_t without_result = 0;
    std::size_t former_fronts = 0;  ///< run-out by the definition of before database 10
    std::size_t other_effects = 0;  ///< effects on that the question has not, or the reverse
    std::size_t other_planes = 0;   ///< S_front of another discontinuity angle
    std::size_t coarser = 0;        ///< than another run of the same source and friction angle
};

/// The settled runs with the effects of the question; of several of one source and friction angle the finest,
/// and of equally fine ones the latest.
ChartPoints chart_points(const std::vector<ChartRow>& rows, const ChartQuestion& question);

}  // namespace runout
