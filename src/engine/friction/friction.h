#pragma once

#include <array>
#include <vector>

#include "engine/friction/yield_strength.h"
#include "engine/pairs/particle_system.h"
#include "engine/problem.h"
#include "engine/threads/row_passes.h"

namespace runout {

/// What a predictor step is made under.
struct FrictionStep {
    double dt = 0;
    Vec2 body{0, 0};     ///< acceleration by gravity and whatever shakes, m/s2
    int iterations = 0;  ///< of the projected scheme; 0: as set for the run
    const std::vector<double>* pore_pressure = nullptr;  ///< per node, Pa; null: dry
};

/// Deviatoric stress of Coulomb soil and the velocity it allows.
///
/// `projected`: the yield condition |s| <= p sin(phi) is a constraint, met by an accelerated projected
/// (Uzawa) iteration on s in the spirit of Ionescu et al. 2015 and Bermudez & Moreno: at rest s balances the
/// weight and nothing moves; at yield s tends to eq. 8. `explicit_`: eq. 8 from the current strain rate, the
/// paper as printed.
///
/// The stress of cohesive soil grows with the plain velocity gradient, the adjoint of the divergence of
/// stress, in place of the renormalised one of eq. 9. With that one the small motions of soil at rest feed
/// stresses that carry nothing (self-stress), until it yields for no reason; soil without cohesion has no
/// place to keep them, its strength being nothing at the surface.
class Friction {
  public:
    /// `iterations`: of a step that does not say how many.
    Friction(const Discretisation& discretisation, YieldStrength yield, FrictionScheme scheme,
             int iterations);

    /// Predictor, eq. 3. On return soil and wall hold the new stress, and `predicted` the velocity v* under
    /// gravity and friction, without pressure. The pressure is the one the last solve left; `gradient` takes
    /// its gradient at the soil that does not sleep, Pa/m.
    void predict(ParticleSystem& particles, const FrictionStep& step, NodeVectors& predicted,
                 NodeVectors& gradient);

    [[nodiscard]] const YieldStrength& yield() const { return yield_; }
    /// For a bed that has changed.
    void set_yield(YieldStrength yield) { yield_ = std::move(yield); }

  private:
    void make_room(const Neighbours& n);
    void load(const ParticleSystem& particles, int chunk);
    void find_strain_rate(TeamMember& member, const ParticleSystem& particles);
    void find_strength(const Neighbours& n, int chunk, const std::vector<double>* pore_pressure);
    void save(int chunk, ParticleSystem& particles) const;
    void set_momenta(int iterations);
    template <class Start, class Finish>
    void iterate(TeamMember& member, const Neighbours& n, double dt, const Start& start,
                 const Finish& finish);
    void start_rows(const PairRows& rows, int last, const ParticleSystem& particles, const FrictionStep& step,
                    NodeVectors& gradient);
    void trial_velocity(const PairRows& rows, int last, double dt);
    [[nodiscard]] const std::array<std::vector<float>, 4>& correction(const Neighbours& n) const;
    void project(const PairRows& rows, const Neighbours& n, double step, double momentum);
    void project_boundary(const Neighbours& n, int a, double step, float momentum);
    void yield_from_strain_rate(const Neighbours& n, int chunk);
    void final_velocity(const PairRows& rows, int last, const Soil& soil, const FrictionStep& step,
                        NodeVectors& predicted);

    Discretisation discretisation_;
    YieldStrength yield_;
    FrictionScheme scheme_;
    int iterations_;
    TeamSignals signals_;
    std::vector<double> momenta_;  ///< of each iteration

    // Node arrays, see Neighbours. What is iterated on is in single precision, see PairKernels.
    std::vector<double> pressure_;
    std::vector<double> strain_rate_;                  ///< |e|, 1/s; only where strength depends on it
    std::vector<float> strength_;                      ///< yield stress, Pa
    std::vector<FloatPair> stress_;                    ///< sxx and sxy of this iterate, Pa
    std::vector<FloatPair> ahead_;                     ///< extrapolated
    std::vector<FloatPair> base_velocity_;             ///< under gravity and pressure, m/s
    std::vector<FloatPair> velocity_;                  ///< trial velocity v~
    std::array<std::vector<float>, 4> no_correction_;  ///< only for cohesive soil
    std::vector<FloatPair> force_;                     ///< div s, Pa/m
};

}  // namespace runout
