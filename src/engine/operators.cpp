#include "engine/operators.h"

namespace runout {
namespace {

/// Calls add(lane, entry, column) for every pair of a slice, then finish(row) for every row that exists.
template <class Add, class Start, class Finish>
void for_each_slice(const PairBlock& block, int rows, const Start& start, const Add& add, const Finish& finish) {
    for (int slice = 0; slice < slices_per_block; ++slice) {
        const int row = block.first_row + slice * lanes;
        if (row >= rows) return;
        start(row);
        for (int e = block.offset[slice]; e < block.offset[slice + 1]; e += lanes) {
            for (int l = 0; l < lanes; ++l) add(row, l, e + l, block.column[e + l]);
        }
        for (int l = 0; l < lanes && row + l < rows; ++l) finish(row + l, l);
    }
}

}  // namespace

void stress_divergence(const PairBlock& block, int rows, const double* sxx, const double* sxy, double* force_x,
                       double* force_y) {
    double fx[lanes];
    double fy[lanes];
    for_each_slice(
        block, rows,
        [&](int) {
            for (int l = 0; l < lanes; ++l) fx[l] = fy[l] = 0.0;
        },
        [&](int row, int l, int e, int j) {
            const double a = sxx[row + l] + sxx[j];
            const double b = sxy[row + l] + sxy[j];
            const double gx = block.gx[e];
            const double gy = block.gy[e];
            fx[l] += a * gx + b * gy;
            fy[l] += b * gx - a * gy;
        },
        [&](int i, int l) {
            force_x[i] = fx[l];
            force_y[i] = fy[l];
        });
}

void pressure_gradient(const PairBlock& block, int rows, const double* pressure, double* force_x, double* force_y) {
    double fx[lanes];
    double fy[lanes];
    for_each_slice(
        block, rows,
        [&](int) {
            for (int l = 0; l < lanes; ++l) fx[l] = fy[l] = 0.0;
        },
        [&](int row, int l, int e, int j) {
            const double p = pressure[row + l] + pressure[j];
            fx[l] += p * block.gx[e];
            fy[l] += p * block.gy[e];
        },
        [&](int i, int l) {
            force_x[i] = fx[l];
            force_y[i] = fy[l];
        });
}

void velocity_divergence(const PairBlock& block, int rows, const double* vx, const double* vy, double* divergence) {
    double sum[lanes];
    for_each_slice(
        block, rows,
        [&](int) {
            for (int l = 0; l < lanes; ++l) sum[l] = 0.0;
        },
        [&](int row, int l, int e, int j) {
            sum[l] += (vx[j] - vx[row + l]) * block.gx[e] + (vy[j] - vy[row + l]) * block.gy[e];
        },
        [&](int i, int l) { divergence[i] = sum[l]; });
}

void stiffness_product(const PairBlock& block, int rows, const double* x, double* out) {
    double sum[lanes];
    for_each_slice(
        block, rows,
        [&](int) {
            for (int l = 0; l < lanes; ++l) sum[l] = 0.0;
        },
        [&](int, int l, int e, int j) { sum[l] += block.stiffness[e] * x[j]; },
        [&](int i, int l) { out[i] = sum[l]; });
}

VelocityGradient boundary_velocity_gradient(const Neighbours& n, int a, const double* vx, const double* vy) {
    VelocityGradient g;
    for (int k = n.boundary_start[a]; k < n.boundary_start[a + 1]; ++k) {
        const BoundaryPair& pair = n.boundary_pairs[k];
        g.xx += vx[pair.soil] * pair.own_gx;
        g.xy += vx[pair.soil] * pair.own_gy;
        g.yx += vy[pair.soil] * pair.own_gx;
        g.yy += vy[pair.soil] * pair.own_gy;
    }
    return g;
}

}  // namespace runout
