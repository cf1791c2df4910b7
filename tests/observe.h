#pragma once

#include <cmath>
#include <vector>

#include "engine/simulation.h"

namespace runout {

/// Where the particles are, in the order they were packed, m.
inline std::vector<Vec2> positions_by_id(const Simulation& simulation) {
    const StateView state = simulation.state();
    std::vector<Vec2> positions(state.x.size());
    for (std::size_t i = 0; i < state.x.size(); ++i) positions[state.id[i]] = {state.x[i], state.y[i]};
    return positions;
}

/// Mean velocity down the plane of the middle fifth of a slab (scenes::slab), m/s. `slope`: rad.
inline double slab_speed(const Simulation& simulation, int columns, int rows, double slope) {
    const StateView state = simulation.state();
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        const int column = state.id[i] / rows;  // packing goes column by column
        if (column < 2 * columns / 5 || column >= 3 * columns / 5) continue;
        sum += state.vx[i] * std::cos(slope) - state.vy[i] * std::sin(slope);
        ++count;
    }
    return sum / count;
}

}  // namespace runout
