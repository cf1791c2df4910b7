#pragma once

#include "engine/effects/effects.h"
#include "engine/particles/mass.h"

namespace runout {

/// Coulomb soil at critical state.
struct Material {
    double density = 2000;      ///< bulk, kg/m3
    double friction_angle = 0;  ///< phi_crit, rad
};

/// How the deviatoric stress follows from the strain rate.
enum class FrictionScheme {
    projected,  ///< yield condition as a constraint, solved by projected iteration: stops
    explicit_,  ///< eq. 8 from the current strain rate, the paper as printed: creeps
};

/// How the problem is to be solved.
struct SolverSettings {
    double particle_spacing = 0;   ///< dl, m
    double gravity = 9.81;         ///< m/s2
    double courant = 0.2;          ///< C_max of eq. 6
    double smoothing_ratio = 1.3;  ///< h/dl
    FrictionScheme friction = FrictionScheme::projected;
    int friction_iterations = 6;       ///< a step
    double pressure_tolerance = 1e-2;  ///< relative residual of the pressure equation
    double time_limit = 0;             ///< s of simulated time; 0: 60 sqrt(H/g) or more
    bool sleeping = true;              ///< nothing is solved for soil at rest; projected friction only
    int lattice_seed = 0;              ///< 0: regular lattice; else particles start off it at random
    int threads = 0;                   ///< 0: all cores
};

/// All that the engine is told: what stands, what moves, of what, and how to solve it. In a plane frame of
/// its own, y upwards, gravity along -y; SI and radians.
struct Problem {
    Mass mass{};  ///< let go at t = 0
    Material material{};
    Effects effects{};
    SolverSettings settings{};
};

}  // namespace runout
