#pragma once

#include <array>
#include <vector>

#include "engine/friction/yield_strength.h"
#include "engine/pairs/particle_system.h"
#include "engine/pairs/row_passes.h"
#include "engine/problem.h"

namespace runout {

/// What a predictor step needs besides the particles.
struct FrictionStep {
    double dt = 0;       ///< s
    Vec2 body{0, 0};     ///< gravity, less the acceleration of the ground, m/s2
    int iterations = 0;  ///< of the projected scheme; 0: as set for the run
    const std::vector<double>* pore_pressure = nullptr;  ///< per node, Pa; null: dry
};

/// Deviatoric stress of Coulomb soil and the velocity it allows.
///
/// - `projected`: the yield condition |s| <= p sin(phi) is a constraint. It is met by an accelerated
///   projected (Uzawa) iteration on s, in the spirit of Ionescu et al. 2015 and Bermudez & Moreno. At rest s
///   balances the weight and nothing moves; at yield s tends to eq. 8.
/// - `explicit_`: eq. 8 from the current strain rate, the paper as printed.
///
/// The stress of cohesive soil grows with the plain velocity gradient, which is the adjoint of the divergence
/// of stress, and not with the renormalised one of eq. 9. With the latter, the small motions of soil at rest
/// build up stress that carries nothing (self-stress), until the soil yields for no reason. Soil without
/// cohesion cannot keep such stress, since its strength is 0 at the surface.
class Friction {
  public:
    /// `iterations`: of a step that does not say how many.
    Friction(const Discretisation& discretisation, YieldStrength yield, FrictionScheme scheme,
             int iterations);

    /// Predictor, eq. 3. On return soil and wall hold the new stress, and `predicted` the velocity v* under
    /// gravity and friction, without pressure. Friction sees the pressure that soil and wall carry from the
    /// last step; on return `gradient` is that of this pressure, at the soil that does not sleep, Pa/m.
    void predict(ParticleSystem& particles, const FrictionStep& step, NodeVectors& predicted,
                 NodeVectors& gradient);

    [[nodiscard]] const YieldStrength& yield() const { return yield_; }
    /// Call it when the bed has changed.
    void set_yield(YieldStrength yield) { yield_ = std::move(yield); }

  private:
    void make_room(const Neighbours& n);
    void load(const ParticleSystem& particles, int chunk);
    void find_strain_rate(TeamMember& member, const ParticleSystem& particles);
    void find_strength(const Neighbours& n, int chunk, const std::vector<double>* pore_pressure);
    void save(int chunk, ParticleSystem& particles) const;
    void set_momenta(int iterations);
    template <class Start, class Finish>
    void iterate(TeamMember& member, const ParticleSystem& particles, double dt, const Start& start,
                 const Finish& finish);
    void start_rows(const PairRows& rows, int last, const ParticleSystem& particles, const FrictionStep& step,
                    NodeVectors& gradient);
    void find_gradients(const PairRows& rows, const ParticleSystem& particles,
                        VelocityGradients& gradients) const;
    void find_force(const PairRows& rows, const ParticleSystem& particles,
                    const std::vector<FloatPair>& stress);
    template <class Function>
    void for_each_gradient(const ParticleSystem& particles, int chunk, const Function& f) const;
    void trial_velocity(const PairRows& rows, int last, const ParticleSystem& particles, double dt);
    [[nodiscard]] const std::array<std::vector<float>, 4>& correction(const Neighbours& n) const;
    void project(const PairRows& rows, const ParticleSystem& particles, double step, double momentum);
    void project_boundary(const Neighbours& n, int a, double step, float momentum);
    void yield_from_strain_rate(const ParticleSystem& particles, int chunk);
    void final_velocity(const PairRows& rows, int last, const ParticleSystem& particles,
                        const FrictionStep& step, NodeVectors& predicted);

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
    std::vector<FloatPair> stress_;                    ///< sxx and sxy of this iteration, Pa
    std::vector<FloatPair> ahead_;                     ///< stress_, extrapolated by the momentum
    std::vector<FloatPair> base_velocity_;             ///< under gravity and pressure, m/s
    std::vector<FloatPair> velocity_;                  ///< trial velocity v~
    std::array<std::vector<float>, 4> no_correction_;  ///< only for cohesive soil
    std::vector<FloatPair> force_;                     ///< div s, Pa/m
};

}  // namespace runout
