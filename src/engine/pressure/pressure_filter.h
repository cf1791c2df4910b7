#pragma once

#include <vector>

#include "engine/pairs/neighbours.h"
#include "engine/particles/soil.h"

namespace runout {

/// Takes out of the pressure what alternates from particle to particle. The gradient of pressure does not see
/// such noise, so nothing else would remove it. As VelocityFilter for the motion, with G the gradient:
///   p_i += fraction sum_j w_ij (p_j - p_i - (G_i + G_j)/2 . (x_j - x_i)),   w_ij = k_ij / lattice sum of k.
/// This is 0 for any pressure that is quadratic in place, so that it neither carries nor sheds weight.
class PressureFilter {
  public:
    explicit PressureFilter(const Discretisation& discretisation)
        : lattice_stiffness_(discretisation.lattice_stiffness) {}

    /// `pressure`: per node, Pa; that of the soil is changed.
    void apply(const Neighbours& n, const Soil& soil, std::vector<double>& pressure);

  private:
    void find_gradients(const Neighbours& n, const std::vector<double>& pressure);

    double lattice_stiffness_;
    std::vector<Vec2> gradient_;  ///< per soil particle, Pa/m
    std::vector<double> change_;  ///< per soil particle
};

}  // namespace runout
