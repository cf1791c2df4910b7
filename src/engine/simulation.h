#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/effects/barrier_load.h"
#include "engine/effects/ground_motion.h"
#include "engine/effects/pore_pressure.h"
#include "engine/friction/friction.h"
#include "engine/friction/velocity_filter.h"
#include "engine/pairs/neighbours.h"
#include "engine/particles/bed_line.h"
#include "engine/particles/packing.h"
#include "engine/particles/soil.h"
#include "engine/particles/wall.h"
#include "engine/pressure/pressure_solver.h"
#include "engine/state_view.h"
#include "engine/status.h"
#include "engine/watch/invariants.h"
#include "engine/watch/phase_clock.h"
#include "engine/watch/rest_watch.h"
#include "engine/watch/sleep_watch.h"
#include "scene/scene.h"

namespace runout {

/// Exact counts of what a run did so far.
struct WorkCounts {
    long steps = 0;
    long pressure_iterations = 0;
    long wall_guard_activations = 0;
    long unconverged_solves = 0;
    double particle_steps = 0;
    double flying_particle_steps = 0;    ///< in free flight, without friction and pressure
    double sleeping_particle_steps = 0;  ///< at rest, without friction and pressure
    double highest_density = 0;          ///< rho / rho_0, over particles of the body and all instants
};

/// Mechanical energy per metre of width, J/m.
struct EnergyBudget {
    double kinetic = 0;
    double potential = 0;      ///< above the toe
    double friction_work = 0;  ///< taken from the motion by friction since release
    double pressure_work = 0;  ///< given to the motion by pressure since release: the error of the projection
    double guard_work = 0;     ///< taken from the motion at the bed line since release
    double shaking_work = 0;   ///< given to the motion by the acceleration of the ground since release
    double side_wall_work = 0;  ///< taken from the motion by side walls since release
};

/// Seconds that an effect's own work took.
struct EffectCost {
    const char* effect;
    double seconds = 0;
};

/// What friction took, pressure gave, and the integration in time lost within one step, per mass of one
/// particle, J/kg; and its momentum.
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

/// Incompressible SPH of Coulomb soil from release to rest. The scene is copied into numbers; nothing of it
/// is kept.
class Simulation {
  public:
    explicit Simulation(const Scene& scene);
    /// From particles that stand elsewhere than the scene's source is filled.
    Simulation(const Scene& scene, const Packing& packing);

    /// One time step, in the paper's order:
    ///   neighbours -> time step -> friction (predictor) -> pressure (projection) -> correct -> move
    /// The first calls find the state of stress at release instead; time stands still meanwhile.
    void step();

    [[nodiscard]] RunStatus status() const { return status_; }
    /// Why the run did not settle, one sentence; empty otherwise.
    [[nodiscard]] const std::string& status_detail() const { return detail_; }
    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] double time_limit() const { return time_limit_; }
    /// Last instant at which the mass was still moving, s.
    [[nodiscard]] double motion_ended() const { return rest_.motion_ended(); }
    /// Share of the time that the mass must rest before the run ends, 0 while it moves.
    [[nodiscard]] double rested() const { return rest_.progress(); }
    /// False while the state of stress at release is still sought.
    [[nodiscard]] bool released() const { return released_; }
    /// All soil of a staged release let go so far is at rest; the next step lets go the next layer.
    [[nodiscard]] bool stage_ended() const { return stage_ended_; }
    [[nodiscard]] StateView state() const;
    [[nodiscard]] EnergyBudget energy() const;
    /// Force of the soil on the bed as the pairs carry it, N per metre of width.
    [[nodiscard]] Vec2 bed_force() const;
    /// What the soil does to the barrier; null where there is none.
    [[nodiscard]] const BarrierForce* barrier_force() const { return barrier_ ? &barrier_->now() : nullptr; }
    /// Effects that do work of their own in a step, with the seconds it took so far.
    [[nodiscard]] const std::vector<EffectCost>& effect_costs() const { return effect_costs_; }
    /// Strain rate |e| per soil particle for the velocities as they are, 1/s. Not free: it is a sum over
    /// pairs.
    [[nodiscard]] std::vector<double> strain_rate() const;
    /// Soil of an erodible layer that has moved, m2.
    [[nodiscard]] double eroded_area() const;
    [[nodiscard]] const WorkCounts& work() const { return work_; }
    [[nodiscard]] const PhaseClock& clock() const { return clock_; }
    [[nodiscard]] const Wall& wall() const { return wall_; }
    /// How near the run came to violating what must always hold.
    [[nodiscard]] const InvariantReadings& invariants() const { return invariants_.readings(); }
    [[nodiscard]] int threads() const { return threads_; }
    /// Time of free fall through sqrt(S), s: the unit of the rest criterion.
    [[nodiscard]] double time_scale() const { return time_scale_; }

  private:
    void set_up_effects();
    double& cost_of(const char* effect);
    [[nodiscard]] Vec2 body_acceleration() const;
    void damp(double dt);
    void brake(double dt);
    [[nodiscard]] double rate_of_rise() const;
    void even_out(double dt);
    void measure_barrier(double dt);
    void note_moved_layer();
    void release_mass();
    void add_soil(const std::vector<Vec2>& points);
    void make_room();
    void balance();
    [[nodiscard]] double choose_time_step();
    [[nodiscard]] FrictionStep friction_step(double dt, int iterations = 0);
    void find_pressure_gradient();
    [[nodiscard]] bool in_free_flight();
    PressureSolve fly(double dt);
    void let_sleep(int resting);
    void watch_sleep();
    PressureSolve resist(double dt);
    void correct(double dt);
    void move(double dt);
    [[nodiscard]] BedLine::Nearest nearest_bed(int i) const;
    [[nodiscard]] double clearance(int i) const;
    void find_bed_gap();
    StepFacts guard_wall(double dt);
    void put_back(int i, double dt, StepFacts& facts);
    Vec2 push_back(int i, double distance, const Vec2& normal, double dt);
    void judge(StepFacts& facts);
    void end_at_rest();
    void release_layer();
    [[nodiscard]] double greatest_displacement() const;
    void end(RunStatus status, std::string detail = {});

    [[nodiscard]] bool in_body(int i) const { return neighbours_.density[i] >= body_density; }

    int threads_;
    RunSettings run_;
    Material material_;
    Effects effects_;
    StagedRelease release_;
    BedLine ground_;  ///< the bed without barrier and erodible layer
    BedLine bed_;
    Discretisation discretisation_;
    double length_scale_;  ///< sqrt(S), m
    double time_scale_;
    double floor_;   ///< lowest bed elevation, m
    double height_;  ///< of the source above the lowest bed, m
    double time_limit_;

    InvariantWatch invariants_;
    RestWatch rest_;
    std::optional<SleepWatch> sleep_;
    Soil soil_;
    Wall wall_;
    NeighbourSearch search_;
    Neighbours neighbours_;
    Friction friction_;
    std::optional<PoreWater> pore_water_;
    std::vector<double> pore_pressure_;  ///< per node, Pa
    std::optional<GroundMotion> ground_motion_;
    std::optional<BarrierLoad> barrier_;
    std::optional<VelocityFilter> filter_;
    int first_layer_id_ = 0;  ///< of the soil of an erodible layer, which is packed after the source
    int end_layer_id_ = 0;
    std::vector<char> layer_moved_;    ///< by id since first_layer_id_
    std::vector<char> resting_layer_;  ///< per soil particle
    std::vector<EffectCost> effect_costs_;
    PressureSolver pressure_;
    std::vector<FloatPair> flight_velocity_;
    std::vector<double> predicted_vx_, predicted_vy_;
    std::vector<double> force_x_, force_y_;
    std::vector<double> bed_gap_;  ///< to how near the bed line a particle may come, per particle, m
    std::vector<char> meets_bed_;  ///< per chunk: some of it is nearer
    std::vector<double> partial_;
    std::vector<StepWork> partial_work_;
    std::vector<SoilSurvey> partial_survey_;
    std::vector<Vec2> start_;  ///< positions at release, by id

    bool released_ = false;
    int balance_rounds_ = 0;
    std::vector<double> release_ax_, release_ay_;  ///< acceleration at release as known so far, m/s2

    int layers_released_ = 0;
    std::size_t masses_released_ = 0;
    bool stage_ended_ = false;
    double stage_start_ = 0;   ///< s
    double release_head_ = 0;  ///< x of the uphill end of the source, m

    double time_ = 0;
    double highest_pressure_ = 0;
    double friction_work_ = 0;
    double pressure_work_ = 0;
    double guard_work_ = 0;
    double shaking_work_ = 0;
    double side_wall_work_ = 0;
    double numerical_work_ = 0;  ///< lost because gravity acts on the mean velocity and moves with the new
                                 ///< one, and where particles are shifted
    int unconverged_in_a_row_ = 0;
    WorkCounts work_;
    RunStatus status_ = RunStatus::running;
    std::string detail_;
    PhaseClock clock_;
};

}  // namespace runout
