#pragma once

// A block of soil on its lattice in a box with open top, for tests of the engine's parts.

#include <vector>

#include "engine/pairs/neighbours.h"

namespace runout::filled_box {

inline constexpr double spacing = 0.005;
inline constexpr double density = 2000.0;

/// Block of lattice points with its lower left cell at the origin.
inline Soil lattice(int columns, int rows) {
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j) {
            x.push_back((i + 0.5) * spacing);
            y.push_back((j + 0.5) * spacing);
        }
    }
    return soil_at(x, y);
}

/// A lattice in a box with open top: soil, wall and who is near whom, on one thread.
struct Filled {
    Discretisation d = make_discretisation(spacing, 1.3, density);
    Soil soil;
    Wall wall;
    NeighbourSearch search;
    Neighbours n;

    explicit Filled(int cells) : Filled(cells, cells) {}

    Filled(int columns, int rows)
        : soil(lattice(columns, rows)),
          wall(make_wall(BedLine({{0, 2 * rows * spacing},
                                  {0, 0},
                                  {columns * spacing, 0},
                                  {columns * spacing, 2 * rows * spacing}}),
                         d)),
          search(d, 1) {
        search.sort(soil);
        search.find(soil, wall, n);
    }
};

}  // namespace runout::filled_box
