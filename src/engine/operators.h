#pragma once

#include "engine/neighbours.h"

namespace runout {

// Sums over pairs for the soil rows of one block. Node arrays hold soil, padding, then active boundary particles
// (whose velocity is zero). V gradW is stored with the pairs; signs as in the paper: compression positive.

/// force = sum_j (s_i + s_j) . V gradW, Pa/m: divergence of the deviatoric stress, eq. 3. Plain, not renormalised
/// gradients: the renormalised form drags thin layers (false friction).
void stress_divergence(const PairBlock& block, int rows, const double* sxx, const double* sxy, double* force_x,
                       double* force_y);

/// force = sum_j (p_i + p_j) V gradW, Pa/m: pressure gradient, eq. 4.
void pressure_gradient(const PairBlock& block, int rows, const double* pressure, double* force_x, double* force_y);

/// div = sum_j V (v_j - v_i) . gradW, 1/s; the negative adjoint of `pressure_gradient`.
void velocity_divergence(const PairBlock& block, int rows, const double* vx, const double* vy, double* divergence);

/// out = sum_j k_ij x_j.
void stiffness_product(const PairBlock& block, int rows, const double* x, double* out);

/// Plain (uncorrected) velocity gradient sum_j V (v_j - v_i) (x) gradW, 1/s.
struct VelocityGradient {
    double xx = 0, xy = 0, yx = 0, yy = 0;  ///< dv_row / dx_column

    /// With the renormalised kernel gradient of eq. 9; `inverse_moment` as in Neighbours::correction.
    [[nodiscard]] VelocityGradient corrected(const double* inverse_moment) const {
        const double* b = inverse_moment;
        return {xx * b[0] + xy * b[2], xx * b[1] + xy * b[3], yx * b[0] + yy * b[2], yx * b[1] + yy * b[3]};
    }
    /// Components of the deviatoric strain rate, compression positive (eyy = -exx).
    [[nodiscard]] double exx() const { return -0.5 * (xx - yy); }
    [[nodiscard]] double exy() const { return -0.5 * (xy + yx); }
    /// Rate of rotation, anticlockwise.
    [[nodiscard]] double spin() const { return 0.5 * (yx - xy); }
};

/// Calls f(i, gradient) for every soil row i of the block.
template <class Function>
void for_each_velocity_gradient(const PairBlock& block, int rows, const double* vx, const double* vy,
                                const Function& f) {
    for (int slice = 0; slice < slices_per_block; ++slice) {
        const int row = block.first_row + slice * lanes;
        if (row >= rows) return;
        double xx[lanes] = {};
        double xy[lanes] = {};
        double yx[lanes] = {};
        double yy[lanes] = {};
        for (int e = block.offset[slice]; e < block.offset[slice + 1]; e += lanes) {
            for (int l = 0; l < lanes; ++l) {
                const int j = block.column[e + l];
                const double dvx = vx[j] - vx[row + l];
                const double dvy = vy[j] - vy[row + l];
                const double gx = block.gx[e + l];
                const double gy = block.gy[e + l];
                xx[l] += dvx * gx;
                xy[l] += dvx * gy;
                yx[l] += dvy * gx;
                yy[l] += dvy * gy;
            }
        }
        for (int l = 0; l < lanes && row + l < rows; ++l) {
            f(row + l, VelocityGradient{xx[l], xy[l], yx[l], yy[l]});
        }
    }
}

/// Velocity gradient at active boundary particle `a` from its own pairs.
VelocityGradient boundary_velocity_gradient(const Neighbours& n, int a, const double* vx, const double* vy);

}  // namespace runout
