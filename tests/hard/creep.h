#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/simulation.h"
#include "observe.h"
#include "scene/scene.h"

namespace runout {

/// Height of the source above the lowest bed, m.
inline double fall_height(const Scene& scene) {
    double top = scene.source.outline.front().y();
    double floor = scene.source.bed.front().y();
    for (const Vec2& p : scene.source.outline) top = std::max(top, p.y());
    for (const Vec2& p : scene.source.bed) floor = std::min(floor, p.y());
    return top - floor;
}

/// What a deposit did that was left alone.
struct Creep {
    std::vector<double> moved_spacings;  ///< of each particle from its place, in rising order
    double energy_lost = 0;              ///< fall of potential energy / (M g sqrt(S))
};

/// Leaves a deposit for `fall_times` sqrt(H/g) more, H the fall of the source.
inline Creep leave_alone(Simulation& simulation, const Scene& scene, double fall_times = 100) {
    const std::vector<Vec2> before = positions_by_id(simulation);
    const double potential = simulation.energy().potential;
    const double end = simulation.time() + fall_times * std::sqrt(fall_height(scene) / scene.run.gravity);
    while (simulation.time() < end) simulation.step();
    const std::vector<Vec2> after = positions_by_id(simulation);
    const Discretisation& grain = *simulation.state().discretisation;
    Creep creep;
    for (std::size_t i = 0; i < before.size(); ++i)
        creep.moved_spacings.push_back((after[i] - before[i]).norm() / grain.spacing);
    std::ranges::sort(creep.moved_spacings);
    const double weight = grain.mass() * static_cast<double>(before.size()) * scene.run.gravity;
    creep.energy_lost = (potential - simulation.energy().potential) / (weight * std::sqrt(scene.source.area));
    return creep;
}

}  // namespace runout
