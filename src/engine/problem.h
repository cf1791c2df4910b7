#pragma once

#include "engine/effects.h"
#include "engine/mass.h"

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

/// How the problem is to be solved. The defaults are those of the program; docs/stability.md says how far
/// each may be turned.
struct SolverSettings {
    double particle_spacing = 0;   ///< wanted dl, m; positive
    double gravity = 9.81;         ///< m/s2
    double courant = 0.2;          ///< C_max of eq. 6
    double smoothing_ratio = 1.3;  ///< h/dl
    /// Which of the two schemes.
    FrictionScheme friction = FrictionScheme::projected;
    int friction_iterations = 6;       ///< a step, of the projected scheme
    double pressure_tolerance = 1e-2;  ///< relative residual of the pressure equation
    /// s since soil was last let go. 0: 60 sqrt(H/g), or more where friction is low.
    double time_limit = 0;
    bool sleeping = true;  ///< nothing is solved for soil that sleeps; projected friction only
    int lattice_seed = 0;  ///< 0: regular lattice; else particles start off it at random, see pack_mass
    int threads = 0;       ///< at most so many, fewer for few particles; 0: all cores
};

/// All that the engine is told: what moves and the ground it leaves, of what material, with which effects,
/// and how to solve it. In a plane frame of its own: x towards the run-out, y upwards, gravity along -y; SI
/// and radians. The engine does not check it for sense.
struct Problem {
    Mass mass{};                ///< let go at t = 0
    Material material{};        ///< of all soil
    Effects effects{};          ///< none unless set
    SolverSettings settings{};  ///< the spacing must be set
};

}  // namespace runout
