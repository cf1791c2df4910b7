#pragma once

#include <span>

#include "accuracy/richardson.h"

namespace runout {

/// Least-squares form of the convergence of a number on refinement, for data that scatter:
/// f(h) = value + first h^first_order + second h^2 (Eca and Hoekstra 2014, J. Comput. Phys. 262, 104-130).
struct RefinementFit {
    double value = 0;  ///< extrapolated to spacing zero
    double first = 0, first_order = 1;
    double second = 0;
    double deviation = 0;       ///< standard deviation of the data from the fit
    double safety_factor = 3;   ///< of the discretisation error: 1.25 where an order was observed, else 3
    double range_per_step = 0;  ///< (greatest - least) / (number of data - 1), to judge `deviation` by
    bool believed = false;      ///< the observed order is one that a method of first or second order shows
    double observed_order = 0;  ///< p of f0 + c h^p by least squares; NaN when there is none

    /// The fitted number at a spacing.
    [[nodiscard]] double at(double spacing) const;
    /// What refinement would still change at this spacing: at(spacing) - value.
    [[nodiscard]] double discretisation_error(double spacing) const { return at(spacing) - value; }
};

/// Fits `values` (three or more, in any order, spacings that differ), weighted by 1/h so that the finest
/// count most. An order is sought between 0.05 and 8; within 0.5 to 2.1 it is taken as observed. Beyond 2.1
/// first and second order are tried in its place, below 0.5 their sum too, and the one with the least
/// deviation is kept.
RefinementFit fit_refinement(std::span<const GridValue> values);

/// Uncertainty with which the value extrapolated from `fit` lies within value(h) +- the uncertainty, 95 %
/// (the same paper, section 5.4). `value` as computed at `spacing`, which may lie off the fit.
double refinement_uncertainty(const RefinementFit& fit, double spacing, double value);

}  // namespace runout
