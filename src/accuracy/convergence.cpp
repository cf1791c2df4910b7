#include "accuracy/convergence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace runout {
namespace {

// Of 95 %, for a scatter that is normal.
constexpr double coverage_factor = 2.0;
constexpr std::size_t fewest_rungs = 3;
// Spacings that an error bar is looked for at, beyond the finest rung too.
constexpr int spacings_per_octave = 16, finer_octaves = 4;
// Coarser rungs hardly resolve the front and follow no power law: a fit through them would extrapolate their
// error.
constexpr std::size_t most_rungs_in_fit = 4;
// Scatter falls with the spacing, so it is taken from neighbouring rungs alone.
constexpr std::size_t neighbouring_rungs = 3;

/// Pooled over the rungs, each with its degrees of freedom.
double pooled_scatter(std::span<const RungValue> rungs) {
    double squares = 0;
    int freedom = 0;
    for (const RungValue& rung : rungs) {
        squares += (rung.lattices - 1) * rung.scatter * rung.scatter;
        freedom += rung.lattices - 1;
    }
    return freedom > 0 ? std::sqrt(squares / freedom) : 0.0;
}

/// Those whose spacing is nearest by ratio.
std::span<const RungValue> rungs_near(std::span<const RungValue> rungs, double spacing) {
    const std::size_t count = std::min(rungs.size(), neighbouring_rungs);
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < rungs.size(); ++k)
        if (std::abs(std::log(rungs[k].spacing / spacing)) <
            std::abs(std::log(rungs[nearest].spacing / spacing)))
            nearest = k;
    const std::size_t first = std::min(nearest - std::min(nearest, count / 2), rungs.size() - count);
    return rungs.subspan(first, count);
}

/// The greatest of the rungs near it: a few lattices tell a scatter to within a third or so, that of a
/// spacing between two rungs is not known, and a spacing is chosen because its error bar is short.
double scatter_to_expect(std::span<const RungValue> rungs, double spacing) {
    return std::ranges::max(rungs_near(rungs, spacing), {}, &RungValue::scatter).scatter;
}

/// What two means over that many lattices differ by through chance, 95 %.
double noise_of_difference(double scatter, int lattices) {
    return coverage_factor * scatter * std::sqrt(2.0 / std::max(1, lattices));
}

int fewest_lattices(std::span<const RungValue> rungs) {
    return std::ranges::min(rungs, {}, &RungValue::lattices).lattices;
}

/// The finest rungs whose means lie no further apart than chance lets them: no trend is left to extrapolate.
/// Empty when the finest three do not.
std::span<const RungValue> plateau(std::span<const RungValue> rungs, double scatter) {
    std::span<const RungValue> found;
    for (std::size_t count = fewest_rungs; count <= rungs.size(); ++count) {
        const auto tail = rungs.last(count);
        const auto [low, high] = std::ranges::minmax(tail, {}, &RungValue::mean);
        if (high.mean - low.mean > noise_of_difference(scatter, fewest_lattices(tail))) break;
        found = tail;
    }
    return found;
}

/// The mean at a spacing: straight between the rungs, by the fit beyond the finest.
double value_at(const Convergence& convergence, double spacing) {
    const std::vector<RungValue>& rungs = convergence.rungs;
    if (spacing <= rungs.back().spacing) return convergence.fit->at(spacing);
    for (std::size_t k = 1; k < rungs.size(); ++k) {
        const RungValue &coarse = rungs[k - 1], &fine = rungs[k];
        if (spacing < fine.spacing) continue;
        const double share = std::min(1.0, (spacing - fine.spacing) / (coarse.spacing - fine.spacing));
        return fine.mean + share * (coarse.mean - fine.mean);
    }
    return rungs.front().mean;
}

/// What is left of the spacing where the finest rungs agree: how far they lie apart, and the mean at this
/// spacing from theirs.
double error_beside_plateau(const Convergence& convergence, std::span<const RungValue> flat, double spacing) {
    const auto [low, high] = std::ranges::minmax(flat, {}, &RungValue::mean);
    const double range = high.mean - low.mean;
    if (spacing <= flat.front().spacing) return range;
    double mean = 0;
    for (const RungValue& rung : flat) mean += rung.mean / static_cast<double>(flat.size());
    return range + std::abs(value_at(convergence, spacing) - mean);
}

/// The finest rung and the nearest that is about twice as coarse: to first order the one is as far from the
/// limit as the other from it. Where the means follow no order that can be trusted, this, with the safety
/// factor of the grid convergence index, is the error of the finest rung.
double error_over_an_octave(const Convergence& convergence, double spacing) {
    const RungValue& finest = convergence.rungs.back();
    const RungValue* coarse = &convergence.rungs.front();
    for (const RungValue& rung : convergence.rungs)
        if (std::abs(std::log(rung.spacing / finest.spacing / 2)) <
            std::abs(std::log(coarse->spacing / finest.spacing / 2)))
            coarse = &rung;
    const double to_the_limit =
        gci_safety_factor * std::abs(coarse->mean - finest.mean) / (coarse->spacing / finest.spacing - 1);
    if (spacing <= finest.spacing) return to_the_limit * spacing / finest.spacing;
    return to_the_limit + std::abs(value_at(convergence, spacing) - finest.mean);
}

double error_of_spacing(const Convergence& convergence, std::span<const RungValue> flat, double spacing) {
    if (!flat.empty()) return error_beside_plateau(convergence, flat, spacing);
    if (!convergence.fit->believed) return error_over_an_octave(convergence, spacing);
    return refinement_uncertainty(*convergence.fit, spacing, value_at(convergence, spacing));
}

/// The mean differences between rungs, the finest last.
struct Steps {
    double last = 0, before = 0;
    double noise = 0;  ///< of a difference between two means, 95 %
};

Steps last_steps(std::span<const RungValue> rungs, double scatter) {
    const auto last = rungs.last(fewest_rungs);
    return {last[2].mean - last[1].mean, last[1].mean - last[0].mean,
            noise_of_difference(scatter, fewest_lattices(last))};
}

Verdict verdict_of(std::span<const RungValue> rungs, const Convergence& so_far, double target) {
    if (so_far.uncertainty <= target) return Verdict::converged;
    const Steps step = last_steps(rungs, so_far.scatter);
    const double last = std::abs(step.last), before = std::abs(step.before);
    if (!plateau(rungs, so_far.scatter).empty()) return Verdict::floor_reached;
    if (std::min(last, before) > step.noise && step.last * step.before < 0) return Verdict::oscillating;
    if (last > step.noise && last >= before) return Verdict::not_converging;
    return Verdict::refining;
}

}  // namespace

std::string_view to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::converged:
            return "converged";
        case Verdict::floor_reached:
            return "floor reached";
        case Verdict::oscillating:
            return "oscillating";
        case Verdict::not_converging:
            return "not converging";
        case Verdict::refining:
            return "refining";
        case Verdict::too_few_rungs:
            return "too few rungs";
    }
    return "unknown";
}

std::string_view meaning(Verdict verdict) {
    switch (verdict) {
        case Verdict::converged:
            return "one run with the finest spacing is within the target";
        case Verdict::floor_reached:
            return "the finest three rungs differ by no more than chance: only the scatter is left";
        case Verdict::oscillating:
            return "the last refinements went to and fro by more than the scatter: no trend to extrapolate";
        case Verdict::not_converging:
            return "the last refinement changed as much as the one before: no limit is in sight";
        case Verdict::refining:
            return "changes shrink with the spacing, but the target was not met when the ladder ended";
        case Verdict::too_few_rungs:
            return "fewer than three rungs have results: nothing can be said";
    }
    return "";
}

double error_bar(const Convergence& convergence, double spacing) {
    if (!convergence.fit) return std::numeric_limits<double>::quiet_NaN();
    const auto flat = plateau(convergence.rungs, convergence.scatter);
    const double finest = convergence.rungs.back().spacing;
    const int last = static_cast<int>(std::ceil(spacings_per_octave * std::log2(spacing / finest) - 1e-6));
    // A coarse rung that happens to hit, or a fit that crosses its limit, is chance: no finer spacing may be
    // worse.
    double worst = 0;
    for (int k = std::min(last, 0) - finer_octaves * spacings_per_octave; k <= last; ++k) {
        const double finer = finest * std::pow(2.0, static_cast<double>(k) / spacings_per_octave);
        const double of_spacing = error_of_spacing(convergence, flat, finer);
        const double of_lattice = coverage_factor * scatter_to_expect(convergence.rungs, finer);
        worst = std::max(worst, std::hypot(of_spacing, of_lattice));
    }
    return worst;
}

double spacing_error(const Convergence& convergence, double spacing) {
    if (!convergence.fit) return std::numeric_limits<double>::quiet_NaN();
    return error_of_spacing(convergence, plateau(convergence.rungs, convergence.scatter), spacing);
}

Convergence judge_convergence(std::span<const RungValue> rungs, double target) {
    Convergence result;
    result.uncertainty = std::numeric_limits<double>::quiet_NaN();
    if (!rungs.empty()) {
        result.scatter = pooled_scatter(rungs_near(rungs, rungs.back().spacing));
        result.finest_value = rungs.back().mean;
        result.finest_spacing = rungs.back().spacing;
    }
    if (rungs.size() < fewest_rungs) return result;
    result.rungs.assign(rungs.begin(), rungs.end());
    std::vector<GridValue> values;
    for (const RungValue& rung : rungs.last(std::min(rungs.size(), most_rungs_in_fit)))
        values.push_back({rung.spacing, rung.mean});
    const std::size_t last = values.size() - 1;
    result.finest_three = richardson({values[last], values[last - 1], values[last - 2]});
    result.fit = fit_refinement(values);
    result.uncertainty = error_bar(result, result.finest_spacing);
    result.verdict = verdict_of(rungs, result, target);
    return result;
}

}  // namespace runout
