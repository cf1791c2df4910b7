#pragma once

#include <optional>
#include <vector>

#include "engine/pairs/particle_system.h"
#include "engine/pairs/row_passes.h"
#include "engine/pressure/coarse_level.h"
#include "engine/pressure/pressure_filter.h"

namespace runout {

/// How a pressure solve is to be done.
struct PressureStep {
    double dt = 0;  ///< s
    /// Share of the old pressure that the projection starts from (incremental projection). With too little a
    /// heap at rest creeps: the Laplacian of eq. 5 is not the divergence of the gradient, so that a
    /// projection from nothing leaves part of the weight uncarried. With all of it, noise that the gradient
    /// does not see is kept for ever. With nine tenths, grains that fall on a thin layer are shot up
    /// (docs/history/stability.md).
    double memory = 0.85;
    bool correct_density = true;  ///< work off density above rho_0
    /// Fraction of the new pressure in what soil and wall carry into the next step; the rest is what they
    /// carried before. Strength and memory answer a pressure one step late, and against it. Without this mean
    /// the pressure of moving soil alternates from step to step, the more the finer the soil is
    /// (src/engine/README.md).
    double renewal = 0.5;
};

/// Sums over some nodes, of a residual r.
struct ResidualNorms {
    double squared = 0;  ///< r . r
    double scaled = 0;   ///< r . D^-1 r
    double whole = 0;    ///< b . b of the right-hand side b, where it was known
    ResidualNorms& operator+=(const ResidualNorms& other) {
        squared += other.squared;
        scaled += other.scaled;
        whole += other.whole;
        return *this;
    }
};

/// What one pressure solve took.
struct PressureSolve {
    int iterations = 0;
    double residual = 0;  ///< relative to the right-hand side
    bool converged = false;
    double highest = 0;  ///< Pa
};

/// Pressure that makes v* divergence-free, eq. 5 in symmetric form on soil and boundary particles:
///   sum_j k_ij (q_i - q_j) = -(div(v* - dt grad(m p^n)/rho) - max(0, rho/rho_0 - 1)/T) / dt,  p = m p^n + q
/// - Dummies are eliminated (P^T A P), so that the matrix is symmetric positive definite.
/// - At the free surface the missing neighbours are ghosts at p = 0: the diagonal is filled up to the
///   lattice's sum of k (semi-Dirichlet). This keeps layers of one to three particles incompressible; the
///   paper's imposed pressure does not.
/// - A boundary particle that soil does not yet surround takes the mean of its neighbours. The density around
///   it rises as soil arrives or thickens. That is no compression, and resisting it drags the front.
/// - Negative pressure is cut off: dry soil bears no tension.
/// It is solved by conjugate gradients with an additive preconditioner of two levels.
class PressureSolver {
  public:
    /// `length`: scale of the mass, m, for the time in which excess density is worked off.
    PressureSolver(const Discretisation& discretisation, double gravity, double length, double tolerance);

    /// For cohesive soil, which bears a mean `tension`, Pa. Its surface is free of traction but not of
    /// pressure (without cohesion p = 0 is no traction, since |s| <= p sin(phi)). The projection therefore
    /// starts from the whole old pressure, freed of noise. Starting from a fraction of it would shed weight
    /// at the surface, which the deviatoric stress would have to carry.
    void bear_tension(double tension) {
        tension_ = tension;
        filter_.emplace(discretisation_);
    }

    /// The wall has changed.
    void forget_wall() { coarse_.forget_wall(); }

    /// `predicted`: velocity v* under gravity and friction. On return soil and wall hold the pressure that
    /// the next step starts from, and `gradient` that of node_pressure() at the soil that does not sleep,
    /// Pa/m.
    PressureSolve solve(ParticleSystem& particles, const NodeVectors& predicted, const PressureStep& step,
                        NodeVectors& gradient);

    /// Pressure per node of this step, Pa: that of the corrector, which makes the velocity free of
    /// divergence.
    [[nodiscard]] const std::vector<double>& node_pressure() const { return pressure_; }

  private:
    struct Iteration;

    void set_up(const ParticleSystem& particles);
    void set_up_boundary(const ParticleSystem& particles, int a);
    void set_up_coarse_level(const ParticleSystem& particles);
    void make_room(const Neighbours& n);
    void find_right_hand_side(TeamMember& member, const ParticleSystem& particles,
                              const NodeVectors& predicted, const PressureStep& step, NodeVectors& gradient);
    [[nodiscard]] double boundary_divergence(const Neighbours& n, int a) const;
    double multiply(const ParticleSystem& particles, int chunk, const std::vector<double>& x,
                    std::vector<double>& out) const;
    double multiply_boundary_row(const ParticleSystem& particles, int a, const std::vector<double>& x,
                                 std::vector<double>& out) const;
    void renew_direction(const Neighbours& n, int chunk, double beta, const double* coarse);
    template <class Function>
    void renew_residual(const Neighbours& n, int chunk, const Function& renew);
    void precondition(Iteration& now);
    void iterate(TeamMember& member, const ParticleSystem& particles, Iteration& now);
    double carry_pressure(int chunk, double renewal, ParticleSystem& particles);
    void find_gradient(const Neighbours& n, NodeVectors& gradient) const;

    Discretisation discretisation_;
    double gravity_;
    double relaxation_time_;  ///< s, least time in which excess density is worked off
    double tolerance_;
    double negligible_;  ///< residual that counts as none: pressure where nothing presses decays until it
                         ///< underflows
    double tension_ = 0;
    std::optional<PressureFilter> filter_;  ///< of cohesive soil
    TeamSignals signals_;

    CoarseLevel coarse_;
    int steps_since_build_ = 0;
    int iterations_after_build_ = 0;
    int last_iterations_ = 0;

    // Node arrays.
    std::vector<FloatPair> trial_velocity_;  ///< v* under m p^n, m/s
    std::vector<double> pressure_, right_hand_side_, diagonal_, residual_, direction_, product_;
    std::vector<char> free_;

    // Per chunk.
    std::vector<double> partial_;
    std::vector<ResidualNorms> partial_norms_;
};

}  // namespace runout
