#pragma once

#include <vector>

#include "engine/pairs/operators.h"
#include "engine/pairs/particle_system.h"

namespace runout {

/// Takes out of the motion what alternates from particle to particle. Gradients over a lattice do not see it
/// (hourglass modes), so friction does not resist it; where soil shears long or holds by cohesion, rows lock
/// in pairs and the stress turns striped. What the gradients explain is left alone: the exchange
///   v_i += share sum_j w_ij (v_j - v_i - (G_i + G_j)/2 . (x_j - x_i)),   w_ij = k_ij / lattice sum of k,
/// after the hourglass control of Ganzenmueller 2015, is 0 for any velocity quadratic in place and keeps
/// momentum.
class VelocityFilter {
  public:
    /// `share`: of the difference to the neighbours that a step takes.
    VelocityFilter(const Discretisation& discretisation, double share)
        : discretisation_(discretisation), share_(share) {}

    /// Returns the kinetic energy taken out, per mass of one particle, J/kg.
    double apply(ParticleSystem& particles);

  private:
    void find_gradients(const ParticleSystem& particles);
    void find_change(const PairBlock& block, const Neighbours& n, const Soil& soil);

    Discretisation discretisation_;
    double share_;
    std::vector<FloatPair> velocity_;
    std::vector<VelocityGradient> gradient_;  ///< per soil particle
    std::vector<Vec2> change_;                ///< per soil particle, m/s
};

}  // namespace runout
