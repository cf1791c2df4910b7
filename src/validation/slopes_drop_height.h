#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "validation/case_runs.h"

namespace runout::slopes {

inline constexpr double box_area = 0.00432;  // of the experiments, m2

/// Slope and H_d/sqrt(S) of an experiment of Bryant et al.
struct Place {
    double slope_deg, height;
};
inline const Place places[] = {{45, 0.233 / std::sqrt(box_area)}, {70, 0.385 / std::sqrt(box_area)}};
inline constexpr int multiples[] = {1, 2, 4};

/// Where the shape is varied: heights of the series.
inline constexpr Place shape_places[] = {{45, 3.5}, {70, 5.86}};
inline constexpr double shapes[] = {1.0, 3.0};

std::vector<double> slopes_of(bool quick);
std::vector<double> heights(double slope_deg, bool quick);

// Names of the ensembles.
std::string height_id(double slope_deg, double height);
std::string area_id(const Place& place, int multiple);
std::string shape_id(const Place& place, double shape);

/// Run-out over drop height on one slope.
struct Series {
    double slope_deg;
    std::vector<double> height;
    std::vector<Estimate> run_out;     ///< 99.5 % mass point
    std::vector<Estimate> contiguous;  ///< by top

    [[nodiscard]] std::vector<Vec2> points(const std::vector<Estimate>& values) const {
        std::vector<Vec2> all;
        for (std::size_t k = 0; k < height.size(); ++k) all.emplace_back(height[k], values[k].mean);
        return all;
    }
};

/// (d) the curve through each series, and its figure.
void add_chart(CaseReport& report, const std::vector<Series>& all);
/// Deposits of (a), (b) and (c).
void add_profiles(CaseReport& report, const CaseRuns& runs);

}  // namespace runout::slopes
