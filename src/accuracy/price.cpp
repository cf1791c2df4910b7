#include "accuracy/price.h"

#include <limits>

namespace runout {
namespace {

std::vector<CostSample> costs_of(const Ladder& ladder) {
    std::vector<CostSample> samples;
    for (const RungSummary& rung : ladder.rungs)
        if (rung.results > 0) samples.push_back(rung.cost);
    return samples;
}

/// Resolutions on offer, rising: those of the rungs, whose scatter is known, and beyond them to
/// `farthest_beyond_ladder` times the finest. Between two rungs the rows of a source are others, and what
/// that changes was never tried.
std::vector<double> offers(std::span<const CostSample> rungs, double finest) {
    std::vector<double> resolutions;
    for (const CostSample& rung : rungs) resolutions.push_back(rung.resolution);
    for (int index = 0; rung_resolution(index) <= farthest_beyond_ladder * finest; ++index)
        if (rung_resolution(index) > resolutions.back()) resolutions.push_back(rung_resolution(index));
    return resolutions;
}

}  // namespace

std::optional<Price> price_of(const Ladder& ladder, const AccuracyTarget& target, double longest_run_s) {
    const Convergence& run_out = ladder.convergence[0];
    const std::vector<CostSample> samples = costs_of(ladder);
    if (!run_out.fit || samples.empty()) return std::nullopt;
    const Reference reference = reference_of(ladder);
    const double root_area = ladder.rungs.front().spacing_m * ladder.rungs.front().resolution;
    const double allowed = target.metres_of(reference.run_out_m, root_area);
    const CostModel model = fit_cost_model(samples);
    Price best;
    best.error_m = std::numeric_limits<double>::infinity();
    for (const double resolution : offers(samples, reference.resolution)) {
        const double error = error_bar(run_out, root_area / resolution);
        if (!(error < best.error_m)) continue;
        const bool too_long = expected_cost(samples, model, resolution).cpu_s > longest_run_s;
        if (too_long && best.resolution > 0) break;
        best.resolution = resolution;
        best.error_m = error;
        best.met = error <= allowed;
        if (best.met) break;
    }
    best.target_m = allowed;
    best.target_share = allowed / reference.scale_m;
    best.reach_angle_error_deg = error_bar(ladder.convergence[1], root_area / best.resolution);
    best.beyond_ladder = best.resolution > reference.resolution;
    best.cost = expected_cost(samples, model, best.resolution);
    return best;
}

std::vector<Price> price_list(const Ladder& ladder) {
    std::vector<Price> prices;
    for (const double share : {0.1, 0.05, 0.02, 0.01})
        if (const auto price = price_of(ladder, {share, 0})) prices.push_back(*price);
    return prices;
}

}  // namespace runout
