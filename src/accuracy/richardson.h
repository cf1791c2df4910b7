#pragma once

#include <array>
#include <optional>

namespace runout {

/// A number computed with one particle spacing.
struct GridValue {
    double spacing = 0;  ///< in any unit, the same for all that are compared
    double value = 0;
};

/// What three spacings tell when the number moves one way on refinement.
struct Richardson {
    double order = 0;         ///< observed p of f(h) = f0 + c h^p
    double extrapolated = 0;  ///< f0
    double gci = 0;           ///< grid convergence index of the finest value, a share of that value
};

/// Safety factor of the index for three grids (Roache 1994).
constexpr double gci_safety_factor = 1.25;

/// Observed order by the equation of Celik et al. (2008, J. Fluids Eng. 130, 078001), which allows ratios of
/// spacing that differ, solved by bisection since their iteration need not converge; and the grid convergence
/// index of Roache (1994, J. Fluids Eng. 116, 405-413). `values` from the finest to the coarsest. Nothing
/// when the differences have opposite signs, one is zero, or they do not shrink: such numbers have no order.
std::optional<Richardson> richardson(const std::array<GridValue, 3>& values);

}  // namespace runout
