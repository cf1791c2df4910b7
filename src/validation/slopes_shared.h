#pragma once

#include <string>
#include <vector>

#include "validation/case_runs.h"

namespace runout::slopes {

/// A number without scatter or error bar.
Estimate exact(double value);

/// Measure over the ensemble, divided by `unit`.
Estimate measured(const CaseRuns& runs, const std::string& id, double Measures::*value, double unit = 1.0);
/// L_inf / sqrt(S) by the 99.5 % mass point, which is what "run-out" means in these cases unless it says
/// otherwise: no threshold of thickness and no single grain decides it.
Estimate run_out(const CaseRuns& runs, const std::string& id);

/// The contiguous front by top instead, over sqrt(S_inf).
Estimate contiguous_run_out(const CaseRuns& runs, const std::string& id);

/// Of the run itself: the 99.5 % mass point.
double front_of(const CaseRuns& runs, const std::string& run);

/// Surface of a deposit by top, from the toe, in sqrt(S).
std::vector<Vec2> normalised_surface(const CaseRuns& runs, const std::string& run, double toe_chainage);
/// The same with its bed, down to the bed at the distal end: one curve to draw.
Curve surface_curve(const CaseRuns& runs, const std::string& run, double toe_chainage,
                    const std::string& label, Curve::Style style = Curve::Style::line);
/// Slope and bed to draw under surfaces, from `height` above the toe to `length` before it.
Curve ground_curve(double slope_deg, double height, double length);

/// Chainage of the toe in profiles/chute-NN.csv.
double chute_toe(double slope_deg);
/// "../../profiles/chute-70.csv", as a case folder sees it.
std::string chute_file(double slope_deg);

/// A number as it stands in a setting.
std::string text_of(double value);

}  // namespace runout::slopes
