#pragma once

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
    WorkCounts counts;

    /// Taken from the motion in all, but for what shaking gave.
    [[nodiscard]] double taken() const { return friction - pressure + guard + side_walls + numerical; }
};

}  // namespace runout
