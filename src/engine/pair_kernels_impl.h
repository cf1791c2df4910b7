#pragma once

// Bodies of the pair kernels, for the files that compile them for one instruction set each. Nothing but plain
// arrays and arithmetic may be used here: whatever function of a header is compiled with wider instructions
// could be the copy that the linker keeps for the whole program.

#include "engine/pair_kernels.h"

namespace runout::kernels {
namespace {

void stress_divergence(const PairRows& p, const double* sxx, const double* sxy, double* force_x,
                       double* force_y) {
    for (int s = 0; s < p.slices; ++s) {
        const int row = p.first_row + s * lanes;
        double fx[lanes] = {};
        double fy[lanes] = {};
        for (int e = p.offset[s]; e < p.offset[s + 1]; e += lanes) {
            for (int l = 0; l < lanes; ++l) {
                const int j = p.column[e + l];
                const double a = sxx[row + l] + sxx[j];
                const double b = sxy[row + l] + sxy[j];
                const double gx = p.gx[e + l];
                const double gy = p.gy[e + l];
                fx[l] += a * gx + b * gy;
                fy[l] += b * gx - a * gy;
            }
        }
        for (int l = 0; l < lanes; ++l) force_x[row + l] = fx[l];
        for (int l = 0; l < lanes; ++l) force_y[row + l] = fy[l];
    }
}

void pressure_gradient(const PairRows& p, const double* pressure, double* force_x, double* force_y) {
    for (int s = 0; s < p.slices; ++s) {
        const int row = p.first_row + s * lanes;
        double fx[lanes] = {};
        double fy[lanes] = {};
        for (int e = p.offset[s]; e < p.offset[s + 1]; e += lanes) {
            for (int l = 0; l < lanes; ++l) {
                const double both = pressure[row + l] + pressure[p.column[e + l]];
                fx[l] += both * p.gx[e + l];
                fy[l] += both * p.gy[e + l];
            }
        }
        for (int l = 0; l < lanes; ++l) force_x[row + l] = fx[l];
        for (int l = 0; l < lanes; ++l) force_y[row + l] = fy[l];
    }
}

void velocity_divergence(const PairRows& p, const double* vx, const double* vy, double* divergence) {
    for (int s = 0; s < p.slices; ++s) {
        const int row = p.first_row + s * lanes;
        double sum[lanes] = {};
        for (int e = p.offset[s]; e < p.offset[s + 1]; e += lanes) {
            for (int l = 0; l < lanes; ++l) {
                const int j = p.column[e + l];
                sum[l] += (vx[j] - vx[row + l]) * p.gx[e + l] + (vy[j] - vy[row + l]) * p.gy[e + l];
            }
        }
        for (int l = 0; l < lanes; ++l) divergence[row + l] = sum[l];
    }
}

void velocity_gradient(const PairRows& p, const double* vx, const double* vy, VelocityGradients& gradients) {
    for (int s = 0; s < p.slices; ++s) {
        const int row = p.first_row + s * lanes;
        double xx[lanes] = {};
        double xy[lanes] = {};
        double yx[lanes] = {};
        double yy[lanes] = {};
        for (int e = p.offset[s]; e < p.offset[s + 1]; e += lanes) {
            for (int l = 0; l < lanes; ++l) {
                const int j = p.column[e + l];
                const double dvx = vx[j] - vx[row + l];
                const double dvy = vy[j] - vy[row + l];
                const double gx = p.gx[e + l];
                const double gy = p.gy[e + l];
                xx[l] += dvx * gx;
                xy[l] += dvx * gy;
                yx[l] += dvy * gx;
                yy[l] += dvy * gy;
            }
        }
        for (int l = 0; l < lanes; ++l) {
            gradients.xx[s * lanes + l] = xx[l];
            gradients.xy[s * lanes + l] = xy[l];
            gradients.yx[s * lanes + l] = yx[l];
            gradients.yy[s * lanes + l] = yy[l];
        }
    }
}

void stiffness_product(const PairRows& p, const double* x, double* out) {
    for (int s = 0; s < p.slices; ++s) {
        const int row = p.first_row + s * lanes;
        double sum[lanes] = {};
        for (int e = p.offset[s]; e < p.offset[s + 1]; e += lanes) {
            for (int l = 0; l < lanes; ++l) sum[l] += p.stiffness[e + l] * x[p.column[e + l]];
        }
        for (int l = 0; l < lanes; ++l) out[row + l] = sum[l];
    }
}

void pair_geometry(const PairGeometry& p, const GeometryConstants& constants) {
    const GeometryConstants c = constants;
    const double* __restrict__ dx = p.dx;
    const double* __restrict__ dy = p.dy;
    const double* __restrict__ r2 = p.r2;
    double* __restrict__ gx = p.gx;
    double* __restrict__ gy = p.gy;
    double* __restrict__ stiffness = p.stiffness;
    double* __restrict__ kernel = p.kernel;
    for (int k = 0; k < p.count; ++k) {
        const double q = __builtin_sqrt(r2[k]) * c.inverse_h;
        const double b = 1.0 - 0.5 * q;
        const double b3 = b * b * b;
        gx[k] = c.gradient_scale * b3 * dx[k];
        gy[k] = c.gradient_scale * b3 * dy[k];
        stiffness[k] = c.stiffness_scale * b3 * r2[k] / (r2[k] + c.eta2);
        kernel[k] = c.value_scale * b3 * b * (2.0 * q + 1.0);
    }
}

constexpr PairKernels table(const char* instruction_set) {
    return {instruction_set,   stress_divergence, pressure_gradient, velocity_divergence,
            velocity_gradient, stiffness_product, pair_geometry};
}

}  // namespace
}  // namespace runout::kernels
