#include "report/text/reach_probability.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace runout {
namespace {

constexpr double two_sided_95 = 1.959963984540054;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double rounding = 1e-9;  // of a sum of weights, which are far fewer than 10^6

double sum_of_weights(const std::vector<ReachSample>& samples) {
    double sum = 0;
    for (const ReachSample& sample : samples) sum += sample.weight;
    return sum;
}

double standard_error(double p, double count) {
    return std::sqrt(std::max(0.0, p * (1 - p)) / count);
}

/// Greatest run-out that at least this share of the weight reaches.
double quantile(std::vector<ReachSample> samples, double probability) {
    const double enough = probability * sum_of_weights(samples);
    if (!(probability > 0) || probability * effective_count(samples) < 1 - rounding) return unknown;
    std::ranges::sort(samples, std::ranges::greater{}, &ReachSample::run_out_m);
    double reached = 0;
    for (const ReachSample& sample : samples) {
        reached += sample.weight;
        if (reached >= enough * (1 - rounding)) return sample.run_out_m;
    }
    return 0;  // more than all: every scenario reaches the toe
}

}  // namespace

double effective_count(const std::vector<ReachSample>& samples) {
    double squares = 0;
    for (const ReachSample& sample : samples) squares += sample.weight * sample.weight;
    const double sum = sum_of_weights(samples);
    return squares > 0 ? sum * sum / squares : 0;
}

Probability probability_of_reaching(const std::vector<ReachSample>& samples, double distance_m) {
    double reached = 0;
    for (const ReachSample& sample : samples)
        if (sample.run_out_m >= distance_m) reached += sample.weight;
    const double p = reached / sum_of_weights(samples);
    return {p, standard_error(p, effective_count(samples))};
}

ReachDistance distance_reached(const std::vector<ReachSample>& samples, double probability) {
    const double margin = two_sided_95 * standard_error(probability, effective_count(samples));
    return {probability, quantile(samples, probability),
            quantile(samples, std::min(1.0, probability + margin)), quantile(samples, probability - margin)};
}

}  // namespace runout
