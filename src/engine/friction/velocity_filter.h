#pragma once

#include <vector>

#include "engine/pairs/operators.h"
#include "engine/pairs/particle_system.h"

namespace runout {

/// Takes out of the motion what alternates from particle to particle. Gradients over a lattice do not see
/// such motion (hourglass modes), so friction does not resist it. Where soil shears for long or holds by
/// cohesion, rows of particles then move in pairs and the stress turns striped. With G the velocity gradient:
///   v_i += fraction sum_j w_ij (v_j - v_i - (G_i + G_j)/2 . (x_j - x_i)),   w_ij = k_ij / lattice sum of k.
/// This is 0 for any velocity that is quadratic in place, so that motion which the gradients see is left
/// alone; it conserves momentum. After the hourglass control of Ganzenmueller 2015.
class VelocityFilter {
  public:
    /// `fraction`: how much of the difference to the neighbours is taken out in a step, 0 to 1.
    VelocityFilter(const Discretisation& discretisation, double fraction)
        : discretisation_(discretisation), fraction_(fraction) {}

    /// Returns the kinetic energy taken out, per mass of one particle, J/kg.
    double apply(ParticleSystem& particles);

  private:
    void find_gradients(const ParticleSystem& particles);
    void find_change(const PairBlock& block, const Neighbours& n, const Soil& soil);

    Discretisation discretisation_;
    double fraction_;
    std::vector<FloatPair> velocity_;
    std::vector<VelocityGradient> gradient_;  ///< per soil particle
    std::vector<Vec2> change_;                ///< per soil particle, m/s
};

}  // namespace runout
