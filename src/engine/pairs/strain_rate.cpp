#include "engine/pairs/strain_rate.h"

#include <algorithm>

namespace runout {
namespace {

constexpr int segments_near = 8;  // of the bed line, on either side of the nearest boundary particle's

/// Sums over the pairs of one row.
struct Sums {
    double wall_x = 0, wall_y = 0;          ///< V gradW over the wall, 1/m
    double xx = 0, xy = 0, yx = 0, yy = 0;  ///< moments -V x gradW over the soil
};

Sums sums_of(const PairBlock& block, const Neighbours& n, const Soil& soil, int row) {
    const int slice = (row - block.first_row) / lanes;
    const int lane = (row - block.first_row) % lanes;
    Sums sums;
    for (int k = block.offset[slice] + lane; k < block.offset[slice + 1]; k += lanes) {
        const int j = block.column[k];
        if (j >= n.first_boundary_node) {
            sums.wall_x += block.gx[k];
            sums.wall_y += block.gy[k];
            continue;
        }
        const double dx = soil.x[row] - soil.x[j];
        const double dy = soil.y[row] - soil.y[j];
        sums.xx -= dx * block.gx[k];
        sums.xy -= dx * block.gy[k];
        sums.yx -= dy * block.gx[k];
        sums.yy -= dy * block.gy[k];
    }
    return sums;
}

}  // namespace

VelocityGradient gradient_without_slip(const ParticleSystem& particles, const PairBlock& block, int row,
                                       const VelocityGradient& plain, double spacing) {
    const Neighbours& n = particles.neighbours;
    const Soil& soil = particles.soil;
    const Wall& wall = particles.wall;
    const int wall_index = n.nearest_boundary[row];
    if (wall_index < 0) return plain;
    const double b0 = n.correction[0][row];
    const double b1 = n.correction[1][row];
    const double b2 = n.correction[2][row];
    const double b3 = n.correction[3][row];
    if (b1 == 0.0 && b2 == 0.0 && b0 == 1.0 && b3 == 1.0) return plain;  // too few neighbours
    const double det = b0 * b3 - b1 * b2;
    const BedLine::Nearest near =
        wall.bed_line.nearest({soil.x[row], soil.y[row]}, wall.segment[wall_index], segments_near);
    const Sums soil_sums = sums_of(block, n, soil, row);
    // n . M of the wall, with n the normal. M of the wall is the whole moment matrix less that of the soil.
    const Vec2& normal = near.normal;
    const double wall_x = normal.x() * (b3 / det - soil_sums.xx) + normal.y() * (-b2 / det - soil_sums.yx);
    const double wall_y = normal.x() * (-b1 / det - soil_sums.xy) + normal.y() * (b0 / det - soil_sums.yy);
    const double distance = std::max(near.distance, 0.25 * spacing);
    const double gx = soil_sums.wall_x + wall_x / distance;
    const double gy = soil_sums.wall_y + wall_y / distance;
    const double vx = soil.vx[row];
    const double vy = soil.vy[row];
    return {plain.xx + vx * gx, plain.xy + vx * gy, plain.yx + vy * gx, plain.yy + vy * gy};
}

}  // namespace runout
