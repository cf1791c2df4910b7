#pragma once

#include <limits>
#include <string>
#include <vector>

#include "report/compare/travel_relations.h"
#include "report/page/page.h"
#include "report/page/run_data.h"

namespace runout {

/// A run beside what has happened before.
struct Comparison {
    TravelCase slide;
    double travel_length = 0;  ///< L, horizontal, from the head of the source to the distal margin, m
    double angle_deg = 0;      ///< of the run
    double run_out_m = 0;
    double width = std::numeric_limits<double>::quiet_NaN();  ///< m; NaN: not given
    std::vector<TravelEstimate> estimates;
    /// For each estimate, for each of its lines: how far that goes past the toe on this section, m; NaN:
    /// beyond it.
    std::vector<std::vector<double>> run_outs;
};

/// Why a run cannot be compared (it did not settle, or nothing passed the toe); empty when it can.
std::string comparison_refusal(const RunData& run);

/// Of a run that comparison_refusal() lets pass. `width`: of the slide across the section, m; NaN when it is
/// not known. The volume is never guessed.
Comparison compare_run(const RunData& run, double width);

/// Horizontal distance past the toe at which the line from the head at H/L = ratio meets the ground:
/// 0 when it does so on the cut, NaN when the section ends before.
double run_out_at(const SectionGeometry& geometry, double ratio);

/// Mean and standard deviation of log10 of H/L over the Hong Kong pairs, and their range of volumes.
struct PairStatistics {
    int count = 0;
    double mean_angle_deg = 0, least_angle_deg = 0, greatest_angle_deg = 0;
    double least_volume = 0, greatest_volume = 0;
    double scatter = 0;  ///< of log10(H/L)
};
PairStatistics pair_statistics(const std::string& group);

/// For a terminal.
std::string comparison_text(const RunData& run, const Comparison& comparison);

/// For a page: table and chart of travel angle against volume.
PageSection comparison_section(const RunData& run, const Comparison& comparison);

/// A page with nothing but the comparison.
std::string comparison_page(const RunData& run, const Comparison& comparison);

}  // namespace runout
