#pragma once

#include <algorithm>

#include "core/vec2.h"
#include "engine/pairs/particle_system.h"
#include "engine/simd/pair_kernels.h"
#include "engine/threads/node_array.h"

namespace runout {

/// Velocity gradient at one particle, dv_row / dx_column, 1/s.
struct VelocityGradient {
    double xx = 0, xy = 0, yx = 0, yy = 0;

    /// With the renormalised kernel gradient of eq. 9 at `node`.
    [[nodiscard]] VelocityGradient corrected(const Neighbours& n, int node) const {
        return corrected(n.correction, node);
    }
    [[nodiscard]] VelocityGradient corrected(const std::array<std::vector<float>, 4>& correction,
                                             int node) const {
        const double b0 = correction[0][node];
        const double b1 = correction[1][node];
        const double b2 = correction[2][node];
        const double b3 = correction[3][node];
        return {xx * b0 + xy * b2, xx * b1 + xy * b3, yx * b0 + yy * b2, yx * b1 + yy * b3};
    }
    /// Components of the deviatoric strain rate, compression positive (eyy = -exx).
    [[nodiscard]] double exx() const { return -0.5 * (xx - yy); }
    [[nodiscard]] double exy() const { return -0.5 * (xy + yx); }
    /// Rate of rotation, anticlockwise.
    [[nodiscard]] double spin() const { return 0.5 * (yx - xy); }
};

/// The block's pairs as the compute kernels take them.
PairRows pair_rows(const PairBlock& block, const Neighbours& n);

/// Calls f(rows, last) for each run of slices of the block that do not sleep. `last`: one past the last of
/// these rows that is soil, not padding.
template <class Function>
void for_each_awake_run(const PairBlock& block, const Neighbours& n, const Function& f) {
    const PairRows all = pair_rows(block, n);
    if (n.asleep.empty()) return f(all, std::min(all.first_row + rows_per_block, n.soil_count));
    const auto asleep = [&](int slice) { return n.is_asleep(all.first_row + slice * lanes); };
    for (int first = 0; first < all.slices;) {
        int end = first;
        while (end < all.slices && !asleep(end)) ++end;
        if (end > first) {
            PairRows run = all;
            run.first_row += first * lanes;
            run.offset += first;
            run.slices = end - first;
            f(run, std::min(run.first_row + run.slices * lanes, n.soil_count));
        }
        first = end + 1;
    }
}

/// Gives a node array its size, and one value in all places but the rows of soil that is awake. These are
/// undefined and must be written before they are read.
template <class T>
void set_beyond_awake(const Neighbours& n, std::vector<T>& field, const T& value) {
    if (n.asleep.empty()) return set_rest(field, n.soil_count, n.nodes, value);
    set_all(field, n.nodes, value);
}

/// Calls f(i, j, k) for each pair of soil row i of the block and neighbour node j; k: its entry in the block.
template <class Function>
void for_each_pair(const PairBlock& block, const Neighbours& n, const Function& f) {
    for (int slice = 0; slice < slices_per_block; ++slice) {
        for (int k = block.offset[slice]; k < block.offset[slice + 1]; ++k) {
            const int i = block.first_row + slice * lanes + (k - block.offset[slice]) % lanes;
            if (i < n.soil_count && block.stiffness[k] > 0.0F) f(i, block.column[k], k);
        }
    }
}

/// On return `velocity` has every node's velocity as the compute kernels take it, m/s: 0 for all but soil.
void soil_velocities(const Neighbours& n, const Soil& soil, std::vector<FloatPair>& velocity);

/// Calls f(i, gradient) with the plain velocity gradient of every soil row i of the block.
template <class Function>
void for_each_velocity_gradient(const PairBlock& block, const Neighbours& n, const FloatPair* velocity,
                                const Function& f) {
    VelocityGradients g;
    pair_kernels().velocity_gradient(pair_rows(block, n), velocity, g);
    for (int k = 0; k < rows_per_block && block.first_row + k < n.soil_count; ++k) {
        f(block.first_row + k, VelocityGradient{g.xx[k], g.xy[k], g.yx[k], g.yy[k]});
    }
}

/// Force of a soil particle on the bed over one pair, per volume of a particle, N/m3.
Vec2 pair_traction(const ParticleSystem& particles, const WallPair& pair);

/// Force of the soil on the bed, summed over the pairs, N per metre of width. `volume`: of a particle, m2.
Vec2 bed_force(const ParticleSystem& particles, double volume);

/// Strain rate |e| per soil particle for the velocities as they are, 1/s.
std::vector<double> strain_rates(const ParticleSystem& particles);

/// Velocity gradient at active boundary particle `a` from its own pairs.
VelocityGradient boundary_velocity_gradient(const Neighbours& n, int a, const FloatPair* velocity);

}  // namespace runout
