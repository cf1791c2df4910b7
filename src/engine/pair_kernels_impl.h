#pragma once

// Bodies of the pair kernels, for the files that compile them for one instruction set each. Nothing but plain
// arrays and arithmetic may be used here: whatever function of a header is compiled with wider instructions
// could be the copy that the linker keeps for the whole program.

#include "engine/pair_kernels.h"

namespace runout::kernels {
namespace {

void stress_divergence(const PairRows& p, const float* sxx, const float* sxy, float* force_x,
                       float* force_y) {
    for (int s = 0; s < p.slices; ++s) {
        const int row = p.first_row + s * lanes;
        float fx[lanes] = {};
        float fy[lanes] = {};
        for (int e = p.offset[s]; e < p.offset[s + 1]; e += lanes) {
            for (int l = 0; l < lanes; ++l) {
                const int j = p.column[e + l];
                const float a = sxx[row + l] + sxx[j];
                const float b = sxy[row + l] + sxy[j];
                const float gx = p.gx[e + l];
                const float gy = p.gy[e + l];
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

void velocity_gradient(const PairRows& p, const float* vx, const float* vy, VelocityGradients& gradients) {
    for (int s = 0; s < p.slices; ++s) {
        const int row = p.first_row + s * lanes;
        float xx[lanes] = {};
        float xy[lanes] = {};
        float yx[lanes] = {};
        float yy[lanes] = {};
        for (int e = p.offset[s]; e < p.offset[s + 1]; e += lanes) {
            for (int l = 0; l < lanes; ++l) {
                const int j = p.column[e + l];
                const float dvx = vx[j] - vx[row + l];
                const float dvy = vy[j] - vy[row + l];
                const float gx = p.gx[e + l];
                const float gy = p.gy[e + l];
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

void update_stress(const PairRows& p, const StressUpdate& update) {
    VelocityGradients g;
    velocity_gradient(p, update.vx, update.vy, g);
    const float* __restrict__ b0 = update.correction[0] + p.first_row;
    const float* __restrict__ b1 = update.correction[1] + p.first_row;
    const float* __restrict__ b2 = update.correction[2] + p.first_row;
    const float* __restrict__ b3 = update.correction[3] + p.first_row;
    const float* __restrict__ strength = update.strength + p.first_row;
    float* __restrict__ sxx = update.sxx + p.first_row;
    float* __restrict__ sxy = update.sxy + p.first_row;
    float* __restrict__ ahead_sxx = update.ahead_sxx + p.first_row;
    float* __restrict__ ahead_sxy = update.ahead_sxy + p.first_row;
    const float half_step = 0.5F * update.step;
    const float momentum = update.momentum;
    for (int k = 0; k < p.slices * lanes; ++k) {
        const float xx = g.xx[k] * b0[k] + g.xy[k] * b2[k];
        const float xy = g.xx[k] * b1[k] + g.xy[k] * b3[k];
        const float yx = g.yx[k] * b0[k] + g.yy[k] * b2[k];
        const float yy = g.yx[k] * b1[k] + g.yy[k] * b3[k];
        const float trial_xx = ahead_sxx[k] - half_step * (xx - yy);
        const float trial_xy = ahead_sxy[k] - half_step * (xy + yx);
        const float size2 = trial_xx * trial_xx + trial_xy * trial_xy;
        const float ratio = strength[k] / __builtin_sqrtf(size2 + 1e-30F);
        const float scale = ratio < 1.0F ? ratio : 1.0F;
        const float new_xx = scale * trial_xx;
        const float new_xy = scale * trial_xy;
        ahead_sxx[k] = new_xx + momentum * (new_xx - sxx[k]);
        ahead_sxy[k] = new_xy + momentum * (new_xy - sxy[k]);
        sxx[k] = new_xx;
        sxy[k] = new_xy;
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

constexpr PairKernels table() {
    return {stress_divergence, pressure_gradient, velocity_divergence, velocity_gradient,
            update_stress,     stiffness_product, pair_geometry};
}

}  // namespace
}  // namespace runout::kernels
