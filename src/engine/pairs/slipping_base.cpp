#include "engine/pairs/slipping_base.h"

namespace runout {
namespace {

/// Calls f(pair) for the pairs of the rows with a slipping base.
template <class Function>
void for_each_slipping_pair(const PairRows& rows, const Neighbours& n, const Wall& wall, const Function& f) {
    if (wall.slips.empty()) return;
    const PairBlock& block = n.blocks[static_cast<std::size_t>(rows.first_row / rows_per_block)];
    const int end = rows.first_row + rows.slices * lanes;
    for (const WallPair& pair : block.wall_pairs)
        if (pair.row >= rows.first_row && pair.row < end && wall.slips_at(pair.wall_index)) f(pair);
}

}  // namespace

void leave_out_slip(const PairRows& rows, const Neighbours& n, const Wall& wall, const FloatPair* velocity,
                    VelocityGradients& gradients) {
    for_each_slipping_pair(rows, n, wall, [&](const WallPair& pair) {
        const int k = pair.row - rows.first_row;
        const FloatPair v = velocity[pair.row];  // the wall's is 0
        gradients.xx[k] += v.x * pair.gx;
        gradients.xy[k] += v.x * pair.gy;
        gradients.yx[k] += v.y * pair.gx;
        gradients.yy[k] += v.y * pair.gy;
    });
}

void carry_by_wall(const PairRows& rows, const Neighbours& n, const Wall& wall, const NodeStress& stress,
                   FloatPair* force) {
    for_each_slipping_pair(rows, n, wall, [&](const WallPair& pair) {
        const int node = n.node_of_boundary[pair.wall_index];
        const FloatPair own = stress.deviatoric[pair.row];
        const FloatPair base = stress.deviatoric[node];
        const auto more =
            static_cast<float>(traction_factor(stress.pressure[pair.row], stress.pressure[node]) - 1.0);
        const float a = more * base.x - own.x;
        const float b = more * base.y - own.y;
        force[pair.row].x += a * pair.gx + b * pair.gy;
        force[pair.row].y += b * pair.gx - a * pair.gy;
    });
}

}  // namespace runout
