#pragma once

#include <string>

#include "estimate/chart_points.h"

namespace runout {

/// How runs that a chart has not seen compare with what it says of them. Run-outs are L/sqrt(S).
struct HeldOutCheck {
    std::size_t estimated = 0;
    std::size_t refused = 0;  ///< outside of the other runs
    std::size_t within_68 = 0;
    std::size_t within_95 = 0;
    double error_rms = 0;           ///< of the estimates
    double left_out_error_rms = 0;  ///< that the charts say of themselves
};

/// Holds out every fifth run, in five turns, and estimates it from the others. Throws InputError:
/// too few runs.
HeldOutCheck check_held_out(const ChartPoints& points, const std::string& origin);

}  // namespace runout
