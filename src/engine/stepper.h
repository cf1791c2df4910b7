#pragma once

#include <optional>
#include <vector>

#include "engine/effects/bed_guard.h"
#include "engine/effects/effect_set.h"
#include "engine/effects/release.h"
#include "engine/friction/friction.h"
#include "engine/pairs/packing.h"
#include "engine/pressure/pressure_solver.h"
#include "engine/problem.h"
#include "engine/state_view.h"
#include "engine/watch/ending.h"
#include "engine/watch/equilibrium.h"
#include "engine/watch/phase_clock.h"
#include "engine/watch/sleep_watch.h"
#include "engine/watch/work_ledger.h"

namespace runout {

/// Work within one step, summed over particles, J/kg: taken by friction, given by pressure, and lost by the
/// integration in time. And the sum of the mean velocities, m/s.
struct StepWork {
    double friction = 0, pressure = 0, integration = 0;
    double momentum_x = 0, momentum_y = 0;
    StepWork& operator+=(const StepWork& other) {
        friction += other.friction;
        pressure += other.pressure;
        integration += other.integration;
        momentum_x += other.momentum_x;
        momentum_y += other.momentum_y;
        return *this;
    }
};

/// Memory that one part of a step uses; its values are not needed afterwards.
struct StepScratch {
    std::vector<double> greatest;            ///< per chunk
    std::vector<StepWork> work;              ///< per chunk
    std::vector<SoilSurvey> survey;          ///< per chunk
    std::vector<FloatPair> flight_velocity;  ///< per node, m/s
    std::vector<double> flight_divergence;   ///< per node, 1/s
};

/// Measures that the problem has by itself.
struct ProblemScales {
    double length = 0;  ///< sqrt(S), m
    double time = 0;    ///< of free fall through it, s
    double floor = 0;   ///< lowest bed elevation, m
    double height = 0;  ///< of the highest soil at its release, above the floor, m
};

/// The state of a run, and its step.
class Stepper {
  public:
    Stepper(const Problem& problem, const Packing& packing);

    /// One time step, in the paper's order:
    ///   neighbours -> time step -> friction (predictor) -> pressure (projection) -> correct -> move
    /// The first calls find the state of stress at release instead; time stands still meanwhile.
    void step();
    /// Ends the run as at rest.
    void end_at_rest() { ending_.end_at_rest(particles_.soil, starts_); }

    [[nodiscard]] StateView state() const;
    [[nodiscard]] EnergyBudget energy() const;
    [[nodiscard]] int threads() const { return threads_; }
    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] const ProblemScales& scales() const { return scales_; }
    [[nodiscard]] const Discretisation& discretisation() const { return discretisation_; }
    [[nodiscard]] const ParticleSystem& particles() const { return particles_; }
    [[nodiscard]] const EffectSet& effects() const { return effects_; }
    [[nodiscard]] const Release& release() const { return release_; }
    [[nodiscard]] const InvariantWatch& invariants() const { return invariants_; }
    [[nodiscard]] const Ending& ending() const { return ending_; }
    [[nodiscard]] const Equilibrium& equilibrium() const { return equilibrium_; }
    [[nodiscard]] const WorkCounts& work() const { return ledger_.counts; }
    [[nodiscard]] const PhaseClock& clock() const { return clock_; }

  private:
    // Before the step.
    void balance();
    void let_go_what_is_due();
    void let_go_mass(const Mass& mass);
    void add_soil(const std::vector<Vec2>& points);
    void make_room();
    [[nodiscard]] Polyline met_ground(const Polyline& ground) const;

    // The step.
    void find_neighbours();
    void let_sleep(int sleeping);
    [[nodiscard]] double choose_time_step();
    [[nodiscard]] bool in_free_flight();
    PressureSolve fly(double dt);
    PressureSolve predict_and_project(double dt);
    void correct(double dt);
    void move(double dt);
    void count(double dt, const PressureSolve& solve);
    void judge(StepFacts& facts, double dt);

    int threads_;
    SolverSettings settings_;
    Discretisation discretisation_;
    EffectSet effects_;
    BedLine ground_;  ///< the bed without barrier and erodible layer
    ProblemScales scales_;
    ParticleSystem particles_;
    std::vector<Vec2> starts_;  ///< positions at release by id, m
    NeighbourSearch search_;
    Friction friction_;
    PressureSolver pressure_;
    BedGuard guard_;
    Release release_;
    Equilibrium equilibrium_;
    InvariantWatch invariants_;
    Ending ending_;
    std::optional<SleepWatch> sleep_;
    NodeVectors predicted_;          ///< velocity v*, m/s
    NodeVectors pressure_gradient_;  ///< per soil particle, Pa/m
    StepScratch scratch_;
    WorkLedger ledger_;
    double time_ = 0;
    double highest_pressure_ = 0;
    int unconverged_in_a_row_ = 0;
    PhaseClock clock_;
};

}  // namespace runout
