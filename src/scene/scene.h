#pragma once

#include <string>
#include <vector>

#include "engine/problem.h"
#include "profile/profile.h"
#include "scene/place.h"
#include "source/source.h"

namespace runout {

/// Numbers of the simulation that are not the ground, the mass or the soil.
struct RunSettings {
    double particle_spacing = 0;   ///< dl, m; 0: from `resolution`
    double resolution = 40;        ///< sqrt(S)/dl when no spacing is given; `runout run` chooses it
    double gravity = 9.81;         ///< m/s2
    double courant = 0.2;          ///< C_max of eq. 6
    double smoothing_ratio = 1.3;  ///< h/dl
    FrictionScheme friction = FrictionScheme::projected;
    int friction_iterations = 6;         ///< a step
    double pressure_tolerance = 1e-2;    ///< relative residual of the pressure equation
    double time_limit = 0;               ///< s of simulated time; 0: 60 sqrt(H/g) or more
    double front_thickness = 0;          ///< m, threshold of the front; 0: 3 % of sqrt(S)
    double front_window = 0;             ///< m, half-width of its window; 0: 30 % of sqrt(S)
    bool sleeping = true;                ///< nothing is solved for soil at rest; projected friction only
    int lattice_seed = 0;                ///< 0: regular lattice; else particles start off it at random
    std::vector<double> snapshot_times;  ///< s since release, rising: instants to keep the particles of
    int threads = 0;                     ///< 0: all cores
};

/// The question, whole and valid: what stands, what moves, of what, and how to simulate it.
struct Scene {
    std::string name;
    Profile profile;
    Source source;
    Material material;
    Effects effects;
    std::vector<Place> places;  ///< in the order of the case
    RunSettings run;
    std::vector<std::string>
        assumed;  ///< "source.base_angle_deg = 35", what was not given and had to be chosen
};

/// The ground and what may come down from it: a scene before anyone has said of what soil.
struct Site {
    Profile profile;
    Source source;
    std::vector<std::string> assumed;
};

struct CaseSpec;

/// Reads the ground. Throws InputError.
Profile make_ground(const CaseSpec& spec);

/// Reads the ground and derives the source. Throws InputError, also when keys of the case do not go together.
Site make_site(const CaseSpec& spec);

/// The whole scene. Throws InputError as make_site, and when the friction angle is missing or the spacing
/// makes too few or too many particles.
Scene make_scene(const CaseSpec& spec);

}  // namespace runout
