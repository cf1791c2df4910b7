#pragma once

#include <vector>

#include "core/geometry.h"

namespace runout {

/// L_inf / L_0 of Lube et al. 2005 for columns of aspect a = H_0/L_0, plane strain: 1 + 1.2 a below 1.8 and
/// 1 + 1.9 a^(2/3) above 2.8. Between the two ranges, which do not meet, the straight line from one to the
/// other.
double lube_front(double aspect);

/// (L_inf - L_0) / L_0 fitted to the digitised points of Lajeunesse et al. 2005, glass beads: 1.79 a below 3,
/// 2.68 a^(2/3) above (+-12 %).
double lajeunesse_run_out(double aspect);

/// Value of scattered points at an aspect: the straight line of log value over log a through the points whose
/// aspect is within a factor of 1.6. NaN where fewer than three points are near.
double local_value(const std::vector<Vec2>& points, double aspect);

/// y = intercept + slope x by least squares, with the half-widths of the 95 % confidence intervals (Student
/// t).
struct LineFit {
    double intercept = 0, slope = 0;
    double intercept_half = 0, slope_half = 0;
    double r_squared = 0;
};
/// Needs three points or more.
LineFit fit_line(const std::vector<Vec2>& points);

}  // namespace runout
