#pragma once

// A block of soil on its lattice in a box with open top, for tests of the engine's parts.

#include <algorithm>
#include <vector>

#include "engine/pairs/particle_system.h"

namespace runout::filled_box {

inline constexpr double spacing = 0.005;
inline constexpr double density = 2000.0;

/// Block of lattice points with its lower left cell at the origin.
inline Soil lattice(int columns, int rows) {
    std::vector<Vec2> points;
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j) points.emplace_back((i + 0.5) * spacing, (j + 0.5) * spacing);
    return soil_at(points);
}

/// A lattice in a box with open top: soil, wall and who is near whom, on one thread.
struct Filled : ParticleSystem {
    Discretisation d = make_discretisation(spacing, 1.3, density);
    NeighbourSearch search;

    explicit Filled(int cells) : Filled(cells, cells) {}

    Filled(int columns, int rows) : search(d, 1) {
        soil = lattice(columns, rows);
        wall = make_wall(BedLine({{0, 2 * rows * spacing},
                                  {0, 0},
                                  {columns * spacing, 0},
                                  {columns * spacing, 2 * rows * spacing}}),
                         d);
        search.sort(soil);
        search.find(soil, wall, neighbours);
    }
};

/// The same velocity per soil particle, none elsewhere.
inline NodeVectors even_velocity(const Filled& f, const Vec2& velocity) {
    const auto nodes = static_cast<std::size_t>(f.neighbours.nodes);
    NodeVectors field{std::vector(nodes, 0.0), std::vector(nodes, 0.0)};
    std::fill_n(field.x.begin(), f.soil.count, velocity.x());
    std::fill_n(field.y.begin(), f.soil.count, velocity.y());
    return field;
}

}  // namespace runout::filled_box
