#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "engine/effects/barrier_force.h"
#include "engine/effects/effects.h"
#include "engine/particles/packing.h"
#include "engine/problem.h"
#include "engine/state_view.h"
#include "engine/status.h"
#include "engine/watch/invariant_readings.h"
#include "engine/watch/phase_clock.h"
#include "engine/watch/work_ledger.h"

namespace runout {

class Stepper;

/// Incompressible SPH of Coulomb soil from release to rest. The problem is copied into numbers; nothing of it
/// is kept. One thread may use it at a time; it runs threads of its own.
class Simulation {
  public:
    explicit Simulation(const Problem& problem);
    /// From particles that stand elsewhere than the mass is filled.
    Simulation(const Problem& problem, const Packing& packing);
    ~Simulation();
    Simulation(Simulation&& other) noexcept;
    Simulation& operator=(Simulation&& other) noexcept;

    /// One time step. The first calls find the state of stress at release instead; time stands still
    /// meanwhile. Never throws for what the physics does: status() says it.
    void step();

    [[nodiscard]] RunStatus status() const;
    /// Why the run did not settle, one sentence; empty otherwise.
    [[nodiscard]] const std::string& status_detail() const;
    [[nodiscard]] double time() const;        ///< since release, s
    [[nodiscard]] double time_limit() const;  ///< s
    /// Last instant at which the mass was still moving, s.
    [[nodiscard]] double motion_ended() const;
    /// Share of the time that the mass must rest before the run ends, 0 while it moves.
    [[nodiscard]] double rested() const;
    /// False while the state of stress at release is still sought.
    [[nodiscard]] bool released() const;
    /// All soil of a staged release let go so far is at rest; the next step lets go the next layer.
    [[nodiscard]] bool stage_ended() const;

    [[nodiscard]] StateView state() const;
    [[nodiscard]] EnergyBudget energy() const;
    /// Force of the soil on the bed as the pairs carry it, N per metre of width.
    [[nodiscard]] Vec2 bed_force() const;
    /// What the soil does to the barrier; null where there is none.
    [[nodiscard]] const BarrierForce* barrier_force() const;
    /// Strain rate |e| per soil particle for the velocities as they are, 1/s. Not free: it is a sum over
    /// pairs.
    [[nodiscard]] std::vector<double> strain_rate() const;
    /// Soil of an erodible layer that has moved, m2.
    [[nodiscard]] double eroded_area() const;

    [[nodiscard]] const WorkCounts& work() const;
    [[nodiscard]] const PhaseClock& clock() const;
    /// Effects that do work of their own in a step, with the seconds it took so far.
    [[nodiscard]] const std::vector<EffectCost>& effect_costs() const;
    /// How near the run came to violating what must always hold.
    [[nodiscard]] const InvariantReadings& invariants() const;
    [[nodiscard]] int boundary_particles() const;
    [[nodiscard]] int threads() const;
    /// Time of free fall through sqrt(S), s: the unit of the rest criterion.
    [[nodiscard]] double time_scale() const;

  private:
    std::unique_ptr<Stepper> stepper_;
};

}  // namespace runout
