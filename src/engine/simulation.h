#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "engine/effects.h"
#include "engine/effects/barrier_force.h"
#include "engine/pairs/packing.h"
#include "engine/problem.h"
#include "engine/state_view.h"
#include "engine/status.h"
#include "engine/watch/invariant_readings.h"
#include "engine/watch/phase_clock.h"
#include "engine/watch/work_ledger.h"

namespace runout {

class Stepper;

/// Incompressible SPH of Coulomb soil from release to rest, after *Run-out of cut-slope landslides: mesh-free
/// simulations*, whose numbers the equations have. The problem is copied. One thread may use a simulation at
/// a time; it runs threads of its own. src/engine/README.md has the theory and an example.
class Simulation {
  public:
    /// Fills the mass with particles, see pack_mass. Throws InputError if the environment variable
    /// RUNOUT_SIMD names an instruction set that is not there.
    explicit Simulation(const Problem& problem);
    /// From particles that are given: for the mass, they take the place of those that would fill it.
    Simulation(const Problem& problem, const Packing& packing);
    ~Simulation();
    /// Leaves the other one fit only to be assigned to or destroyed.
    Simulation(Simulation&& other) noexcept;
    /// Likewise.
    Simulation& operator=(Simulation&& other) noexcept;

    /// One time step. The first calls find the state of stress at release instead; time stands still
    /// meanwhile, see released(). Never throws for what the physics does: status() says it. Throws
    /// std::runtime_error if the coarse pressure matrix cannot be factorised.
    void step();
    /// Ends the run as at rest, by the judgement of who reads it: `stable` where no particle has moved by two
    /// spacings, else `settled`.
    void end_at_rest();

    /// How the run ended; `running` until it has.
    [[nodiscard]] RunStatus status() const;
    /// Why the run did not settle, one sentence; empty otherwise.
    [[nodiscard]] const std::string& status_detail() const;
    [[nodiscard]] double time() const;        ///< since release, s
    [[nodiscard]] double time_limit() const;  ///< since soil was last let go, s
    /// Last instant at which the mass was still moving, s.
    [[nodiscard]] double motion_ended() const;
    /// How much of the time for which the mass must rest before the run ends has passed: 0 while it moves, 1
    /// at the end.
    [[nodiscard]] double rested() const;
    /// False while the state of stress at release is still sought.
    [[nodiscard]] bool released() const;
    /// All soil of a staged release let go so far is at rest; the next step lets go the next layer.
    [[nodiscard]] bool stage_ended() const;

    /// The particles as they are now; valid until the next step.
    [[nodiscard]] StateView state() const;
    /// Energy now, and work since release, J per metre of width.
    [[nodiscard]] EnergyBudget energy() const;
    /// Force of the soil on the bed as the pairs carry it, N per metre of width.
    [[nodiscard]] Vec2 bed_force() const;
    /// What the soil does to the barrier; null where there is none. Kept up to date by every step.
    [[nodiscard]] const BarrierForce* barrier_force() const;
    /// Strain rate |e| (eq. 9) per soil particle, in the order of state(), for the velocities as they are,
    /// 1/s. Each call sums over all pairs.
    [[nodiscard]] std::vector<double> strain_rate() const;
    /// Soil of an erodible layer that has moved, m2; 0 without one.
    [[nodiscard]] double eroded_area() const;

    /// Counts of what the run did so far.
    [[nodiscard]] const WorkCounts& work() const;
    /// Seconds that each part of the steps took so far.
    [[nodiscard]] const PhaseClock& clock() const;
    /// Effects that do work of their own in a step, with the seconds it took so far.
    [[nodiscard]] const std::vector<EffectCost>& effect_costs() const;
    /// How near the run came to violating what must always hold; docs/stability.md has the limits.
    [[nodiscard]] const InvariantReadings& invariants() const;
    /// Particles of the bed that have a pressure of their own, along the whole bed.
    [[nodiscard]] int boundary_particles() const;
    /// Threads that a step runs on.
    [[nodiscard]] int threads() const;
    /// Time of free fall through sqrt(S), s: the unit of the rest criterion.
    [[nodiscard]] double time_scale() const;

  private:
    std::unique_ptr<Stepper> stepper_;
};

}  // namespace runout
