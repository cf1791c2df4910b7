#pragma once

#include <vector>

#include "engine/particles/bed_line.h"
#include "engine/particles/cell_grid.h"
#include "engine/particles/discretisation.h"

namespace runout {

/// Fixed particles that stand for the bed. One layer of boundary particles lies half a spacing behind the bed
/// line, so that soil cells and wall cells meet on the line. (The paper puts it on the line itself; the soil
/// then stands half a spacing off its own outline.) Behind it are layers of dummies, each of which copies the
/// pressure and the stress of its nearest boundary particle.
struct Wall {
    BedLine bed_line{Polyline{}};  ///< the bed that the particles stand for

    // Boundary particles first, then dummies, each kind sorted by cell of `grid`.
    std::vector<double> x, y;  ///< m
    std::vector<int> group;    ///< index of the boundary particle whose values this particle has
    int boundary_count = 0;
    std::vector<int> segment;  ///< of the bed line, for boundary particles
    /// Per boundary particle, 1 where the base is weaker than the soil and the soil slips on it; empty:
    /// nowhere.
    std::vector<char> slips;
    CellGrid grid;                             ///< cells of one kernel support over all wall particles
    std::vector<int> order;                    ///< wall particles by cell: grid.start indexes this
    std::vector<double> ordered_x, ordered_y;  ///< positions in that order, m

    // Sums over the other wall particles around a boundary particle, constant in time.
    std::vector<double> kernel_sum;  ///< sum of W, itself included, 1/m2
    std::vector<double> moment;      ///< 4 per particle: sum V (x_j - x_b) (x) gradW, row-major
    std::vector<int> neighbour_start,
        neighbour;  ///< boundary particles near b: neighbour[neighbour_start[b]] to before [b + 1]
    std::vector<double> neighbour_stiffness;  ///< k of each such pair

    // State of the boundary particles, carried from step to step.
    std::vector<double> pressure, sxx, sxy;  ///< Pa

    [[nodiscard]] int size() const { return static_cast<int>(x.size()); }
    [[nodiscard]] bool slips_at(int boundary) const {
        return !slips.empty() && slips[static_cast<std::size_t>(boundary)] != 0;
    }
};

/// Wall particles along the bed line.
Wall make_wall(const BedLine& bed, const Discretisation& discretisation);

}  // namespace runout
