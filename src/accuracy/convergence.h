#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "accuracy/refinement_fit.h"
#include "accuracy/richardson.h"

namespace runout {

/// One quantity at one spacing, over the lattices that were run.
struct RungValue {
    double spacing = 0;  ///< dl, m
    double mean = 0;
    double scatter = 0;  ///< standard deviation of one lattice; 0 when there is only one
    int lattices = 0;
};

/// What a ladder of spacings says of a quantity.
enum class Verdict {
    converged,       ///< one run on the finest rung is within the target
    floor_reached,   ///< the finest three rungs differ by no more than chance: a finer run buys little
    oscillating,     ///< the last refinements went to and fro by more than the scatter
    not_converging,  ///< the last refinements changed as much as those before, or more
    refining,        ///< changes shrink, but the target was not met yet
    too_few_rungs,   ///< fewer than three rungs have results
};
std::string_view to_string(Verdict verdict);
/// A sentence for people.
std::string_view meaning(Verdict verdict);

/// Convergence of one quantity. Lengths and angles in the unit of the quantity.
struct Convergence {
    Verdict verdict = Verdict::too_few_rungs;
    std::optional<Richardson> finest_three;  ///< nothing when they do not move one way
    std::optional<RefinementFit> fit;        ///< over the finest four rungs, or all three
    std::vector<RungValue> rungs;            ///< from the coarsest to the finest
    double scatter = 0;       ///< standard deviation of one lattice, over the finest three rungs
    double finest_value = 0;  ///< mean over the lattices of the finest rung
    double finest_spacing = 0;
    double uncertainty = 0;  ///< of one run on the finest rung, 95 %; NaN with too few rungs
};

/// Judges `rungs`, from the coarsest to the finest; `target`: error that is allowed, in the unit of the
/// quantity.
Convergence judge_convergence(std::span<const RungValue> rungs, double target);

/// Uncertainty (95 %) of one run with this spacing, of one lattice, from the ladder: the error of the spacing
/// and twice the greatest scatter of the lattices near it, as root of squares; no smaller than at any finer
/// spacing. The error of the spacing: where the finest three rungs or more differ by no more than chance,
/// their range and the distance from their mean; else by the least-squares fit where that finds an order
/// between 0.5 and 2.1 (Eca and Hoekstra 2014); else of first order from the finest rung and the one twice as
/// coarse. NaN with too few rungs.
double error_bar(const Convergence& convergence, double spacing);

/// The part of it that is the error of the spacing, at this spacing alone.
double spacing_error(const Convergence& convergence, double spacing);

}  // namespace runout
