#pragma once

namespace runout {

/// Exact counts of what a run did so far.
struct WorkCounts {
    long steps = 0;                      ///< since release
    long pressure_iterations = 0;        ///< of all steps
    long bed_guard_activations = 0;      ///< particles under pressure that were driven into the bed
    long unconverged_solves = 0;         ///< steps whose pressure equation missed its tolerance
    double particle_steps = 0;           ///< particles, summed over the steps
    double flying_particle_steps = 0;    ///< in free flight, without friction and pressure
    double sleeping_particle_steps = 0;  ///< at rest, without friction and pressure
    double highest_density = 0;          ///< rho / rho_0, over particles of the body and all instants
};

/// Mechanical energy per metre of width, J/m.
struct EnergyBudget {
    double kinetic = 0;        ///< of the particles' velocities
    double potential = 0;      ///< above the origin of the frame
    double friction_work = 0;  ///< taken from the motion by friction since release
    double pressure_work = 0;  ///< given to the motion by pressure since release: the error of the projection
    double guard_work = 0;     ///< taken from the motion at the bed line since release
    double shaking_work = 0;   ///< given to the motion by the acceleration of the ground since release
    double side_wall_work = 0;  ///< taken from the motion by side walls since release
};

/// What was done since release: work on the soil, J per metre of width, and the counts.
struct WorkLedger {
    double friction = 0;    ///< taken from the motion
    double pressure = 0;    ///< given to it
    double guard = 0;       ///< taken from it at the bed line
    double shaking = 0;     ///< given to it
    double side_walls = 0;  ///< taken from it
    double numerical = 0;  ///< lost because gravity acts on the mean velocity and moves with the new one, and
                           ///< where particles are shifted
    WorkCounts counts;     ///< of steps and what they took

    /// Taken from the motion in all, not counting what shaking gave, J/m.
    [[nodiscard]] double taken() const { return friction - pressure + guard + side_walls + numerical; }
};

}  // namespace runout
