#pragma once

#include <vector>

#include "engine/neighbours.h"
#include "engine/soil.h"
#include "engine/wall.h"
#include "scene/scene.h"

namespace runout {

/// Strength of soil at the bed over its mean stress: sin(phi), or tan(delta) where that is less.
double interface_strength(const Material& material, const Effects& effects);

/// Deviatoric stress of Coulomb soil and the velocity it allows.
///
/// `projected`: the yield condition |s| <= p sin(phi) is a constraint, met by an accelerated projected
/// (Uzawa) iteration on s in the spirit of Ionescu et al. 2015 and Bermudez & Moreno: at rest s balances the
/// weight and nothing moves; at yield s tends to eq. 8. `explicit_`: eq. 8 from the current strain rate, the
/// paper as printed.
///
/// On a base of friction angle delta the traction in sliding is p tan(delta). The soil within the kernel's
/// reach of the bed carries that traction to the bed, so all of it gets this strength where it is less than
/// its own.
class Friction {
  public:
    Friction(const Discretisation& discretisation, const Material& material, const Effects& effects,
             const RunSettings& run, int threads);

    /// Predictor, eq. 3. On return soil and wall hold the new stress, and `vx`, `vy` (per node) the
    /// velocity v* under gravity and friction, without pressure. The pressure is the one the last solve left.
    /// `iterations` of the projected scheme; 0: as set for the run.
    void predict(const Neighbours& n, Soil& soil, Wall& wall, double dt, std::vector<double>& vx,
                 std::vector<double>& vy, int iterations = 0);

  private:
    void load(const Neighbours& n, const Soil& soil, const Wall& wall);
    void weaken_interface(const Neighbours& n);
    void save(const Neighbours& n, Soil& soil, Wall& wall) const;
    void apply_pressure(const Neighbours& n, const Soil& soil, double dt);
    void rotate(const Neighbours& n, double dt);
    void trial_velocity(const Neighbours& n, double dt);
    void project(const Neighbours& n, double dt, double momentum);
    void yield_from_strain_rate(const Neighbours& n);
    void final_velocity(const Neighbours& n, const Soil& soil, double dt, std::vector<double>& vx,
                        std::vector<double>& vy);

    Discretisation discretisation_;
    double sin_phi_;
    double interface_strength_;
    double gravity_;
    FrictionScheme scheme_;
    int iterations_;
    int threads_;

    // Node arrays, see Neighbours. What is iterated on is in single precision, see PairKernels.
    std::vector<double> pressure_, pressure_x_, pressure_y_;  ///< p and its gradient
    std::vector<float> strength_;                             ///< p sin(phi), Pa
    std::vector<FloatPair> stress_;                           ///< sxx and sxy of this iterate, Pa
    std::vector<FloatPair> ahead_;                            ///< extrapolated
    std::vector<FloatPair> base_velocity_;                    ///< under gravity and pressure, m/s
    std::vector<FloatPair> velocity_;                         ///< trial velocity v~
    std::vector<FloatPair> force_;                            ///< div s, Pa/m
};

}  // namespace runout
