#pragma once

#include <vector>

namespace runout {

/// Run-out of one of the scenarios that are thought possible.
struct ReachSample {
    double run_out_m = 0;
    double weight = 1;
};

/// A share of the scenarios with its standard error.
struct Probability {
    double value = 0;
    double standard_error = 0;  ///< sqrt(p (1 - p) / n) with n = (sum w)^2 / sum w^2 for unequal weights
};

/// Distance that a share of the scenarios reaches or passes. NaN where the scenarios are too few to tell: of
/// n of them, nothing can be said of probabilities below 1/n.
struct ReachDistance {
    double probability = 0;
    double distance_m = 0;
    double low_m = 0;  ///< 95 % confidence: the distances of p + 1.96 and p - 1.96 standard errors
    double high_m = 0;
};

/// (sum w)^2 / sum w^2: how many scenarios of equal weight would tell as much.
double effective_count(const std::vector<ReachSample>& samples);

/// Probability of a run-out of at least `distance_m`.
Probability probability_of_reaching(const std::vector<ReachSample>& samples, double distance_m);

ReachDistance distance_reached(const std::vector<ReachSample>& samples, double probability);

}  // namespace runout
