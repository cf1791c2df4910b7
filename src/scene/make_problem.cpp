#include "scene/make_problem.h"

#include <cmath>

namespace runout {
namespace {

SolverSettings solver_settings(const RunSettings& run, double spacing) {
    // A new setting must be given its place here, or this does not compile.
    const auto& [particle_spacing, resolution, gravity, courant, smoothing_ratio, friction,
                 friction_iterations, pressure_tolerance, time_limit, front_thickness, front_window, sleeping,
                 lattice_seed, snapshot_times, threads] = run;
    return {spacing,
            gravity,
            courant,
            smoothing_ratio,
            friction,
            friction_iterations,
            pressure_tolerance,
            time_limit,
            sleeping,
            lattice_seed,
            threads};
}

}  // namespace

Mass mass_of(const Source& source) {
    return {source.outline, source.bed, source.area};
}

double spacing_of(const Scene& scene) {
    return scene.run.particle_spacing > 0 ? scene.run.particle_spacing
                                          : std::sqrt(scene.source.area) / scene.run.resolution;
}

Problem make_problem(const Scene& scene) {
    return {mass_of(scene.source), scene.material, scene.effects,
            solver_settings(scene.run, spacing_of(scene))};
}

}  // namespace runout
