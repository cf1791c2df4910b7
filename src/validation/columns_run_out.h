#pragma once

#include <string>
#include <vector>

#include "validation/case_runs.h"

namespace runout::run_out_columns {

inline constexpr double root_area = 0.2;  ///< sqrt(S) of every column, m
inline constexpr double kumar_friction_angle = 22.2;
inline constexpr double beads_friction_angle =
    23.8;  ///< from the repose of Lajeunesse's beads, asin(tan 22 deg)

std::vector<double> aspects(bool quick);
std::vector<double> friction_angles(bool quick);
/// Aspects whose initial failure plane is measured.
std::vector<double> plane_aspects(bool quick);
/// "sqrt(S)/dl = 40".
std::string resolution_of(bool quick);

/// Name of the ensemble.
std::string name_of(double friction_angle, double aspect);
double length_of(double aspect);

/// What is read off the runs of one material, one estimate an aspect.
struct Spread {
    double friction_angle = 0;
    std::vector<double> aspects;
    std::vector<Estimate> front;       ///< L_inf / L_0, of the 99.5 % mass point
    std::vector<Estimate> contiguous;  ///< L_inf / L_0, of the contiguous deposit
    std::vector<Estimate> height;      ///< H_inf / L_0
};
Spread spread_of(const CaseRuns& runs, double friction_angle, const std::vector<double>& aspects);

/// Points (1/sqrt(a), L_inf/sqrt(S)) from the aspect where L_inf/sqrt(S) is least: eq. 10 is meant for
/// columns that move as a whole, and flatter ones are long because they were.
std::vector<Vec2> eq10_points(const Spread& spread);

/// What the table does not say; `measured` are the run-outs of Lajeunesse et al.
void add_remarks(CaseReport& report, const std::vector<Spread>& spreads, const std::vector<Vec2>& measured);
void add_figures(CaseReport& report, const CaseRuns& runs, const std::vector<Spread>& spreads,
                 const std::string& folder);

}  // namespace runout::run_out_columns
