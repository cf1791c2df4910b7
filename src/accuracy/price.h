#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "accuracy/ladder.h"

namespace runout {

/// What an accuracy costs on a scene.
struct Price {
    double target_m = 0;      ///< error allowed for the run-out
    double target_share = 0;  ///< the same as a share of the run-out (of sqrt(S) where that is more)
    bool met = false;         ///< false: the rest is the best that can be had
    double resolution = 0;    ///< the coarsest rung that meets it
    double error_m = 0;       ///< uncertainty (95 %) of one run with it
    double reach_angle_error_deg = 0;
    CostSample cost;             ///< expected of one run
    bool beyond_ladder = false;  ///< finer than the finest rung: extrapolated
};

/// Finest resolution that is offered, as a multiple of the finest rung: what lies further is not known.
constexpr double farthest_beyond_ladder = 2.0;

/// The cheapest rung that meets `target` by the error bars of the ladder, or a spacing beyond them. Nothing
/// when the ladder has no error bars (too few rungs). No run longer than `longest_run_s` of CPU time is
/// offered but the cheapest.
std::optional<Price> price_of(const Ladder& ladder, const AccuracyTarget& target,
                              double longest_run_s = std::numeric_limits<double>::infinity());

/// 10, 5, 2 and 1 %.
std::vector<Price> price_list(const Ladder& ladder);

}  // namespace runout
