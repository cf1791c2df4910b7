#include "run/effect_cost.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "engine/simulation.h"
#include "measures/front_rule.h"
#include "measures/places.h"
#include "scene/effect_settings.h"
#include "scene/make_problem.h"

namespace runout {
namespace {

constexpr double low_resolution = 15;  // sqrt(S) / dl
constexpr int steps = 150;
constexpr int repetitions = 9;

double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// CPU seconds of a step after release, with what is measured in it.
double cost_of_step(const Scene& scene) {
    Simulation simulation(make_problem(scene));
    while (!simulation.released()) simulation.step();
    PlaceRecorder places(scene.places, 0.0, scene.material.density);
    ReachRecorder reach(front_rule(scene), simulation.state());
    const double start = thread_seconds();
    while (simulation.work().steps < steps && simulation.status() == RunStatus::running) {
        simulation.step();
        reach.look(simulation.state());
        if (!scene.places.empty()) places.sample(reach, simulation.state());
    }
    const long taken = simulation.work().steps;
    return taken > 0 ? (thread_seconds() - start) / static_cast<double>(taken) : 0.0;
}

/// Least of the repetitions for each scene, taken in turn so that a busy machine treats all alike.
std::vector<double> costs_of(const std::vector<Scene>& scenes) {
    std::vector<double> costs(scenes.size(), std::numeric_limits<double>::infinity());
    for (int k = 0; k < repetitions; ++k)
        for (std::size_t i = 0; i < scenes.size(); ++i)
            costs[i] = std::min(costs[i], cost_of_step(scenes[i]));
    return costs;
}

}  // namespace

std::vector<MeasuredEffect> measure_effects(const Scene& scene) {
    Scene coarse = scene;
    coarse.run.particle_spacing = 0;
    coarse.run.resolution =
        std::min(scene.run.particle_spacing > 0 ? std::sqrt(scene.source.area) / scene.run.particle_spacing
                                                : scene.run.resolution,
                 low_resolution);
    coarse.run.threads = 1;
    std::vector<Scene> scenes = {coarse};
    std::vector<MeasuredEffect> effects;
    for (const EffectState& state : effect_states(scene.effects, scene.places.size())) {
        effects.push_back({state.name, state.on, state.meaning, std::numeric_limits<double>::quiet_NaN()});
        if (!state.on) continue;
        scenes.push_back(coarse);
        if (state.effect)
            scenes.back().effects = without(coarse.effects, *state.effect);
        else
            scenes.back().places.clear();
    }
    if (scenes.size() == 1) return effects;
    const std::vector<double> costs = costs_of(scenes);
    std::size_t next = 1;
    for (MeasuredEffect& effect : effects) {
        if (!effect.on) continue;
        const double bare = costs[next++];
        if (bare > 0) effect.share = costs.front() / bare - 1.0;
    }
    return effects;
}

}  // namespace runout
