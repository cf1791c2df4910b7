#pragma once

// Bodies of the pair kernels. Each file that includes this compiles them for one instruction set. Only plain
// arrays and arithmetic may be used here. A function of another header would be compiled with wider
// instructions too, and the linker might keep that copy for the whole program.

#include "engine/simd/pair_kernels.h"
#include "engine/simd/select_near_impl.h"

namespace runout::kernels {
namespace {

/// Both numbers of a node in one load.
inline std::uint64_t word_of(const FloatPair* values, int node) {
    std::uint64_t word;
    __builtin_memcpy(&word, values + node, sizeof word);
    return word;
}
inline float first_of(std::uint64_t word) {
    return __builtin_bit_cast(float, static_cast<std::uint32_t>(word));
}
inline float second_of(std::uint64_t word) {
    return __builtin_bit_cast(float, static_cast<std::uint32_t>(word >> 32));
}

/// Fetches entry e of an array of the next block into the cache. The arrays of a block are too short for the
/// processor to foresee the next one, and memory takes longer to answer than the sums take.
template <class T>
inline void prefetch(const T* next, int e) {
    // Computed as a number, since the next block may have fewer entries. A prefetch beyond them does no harm.
    const auto address = reinterpret_cast<std::uintptr_t>(next) + static_cast<unsigned>(e) * sizeof(T);
    __builtin_prefetch(reinterpret_cast<const void*>(address), 0, 2);
}
inline void prefetch_gradients(const PairRows& p, int e) {
    prefetch(p.next.column, e);
    prefetch(p.next.gx, e);
    prefetch(p.next.gy, e);
}

void stress_divergence(const PairRows& p, const FloatPair* stress, FloatPair* force) {
    for (int s = 0; s < p.slices; ++s) {
        const int row = p.first_row + s * lanes;
        float fx[lanes] = {};
        float fy[lanes] = {};
        for (int e = p.offset[s]; e < p.offset[s + 1]; e += lanes) {
            prefetch_gradients(p, e);
            for (int l = 0; l < lanes; ++l) {
                const std::uint64_t own = word_of(stress, row + l);
                const std::uint64_t other = word_of(stress, p.column[e + l]);
                const float a = first_of(own) + first_of(other);
                const float b = second_of(own) + second_of(other);
                const float gx = p.gx[e + l];
                const float gy = p.gy[e + l];
                fx[l] += a * gx + b * gy;
                fy[l] += b * gx - a * gy;
            }
        }
        for (int l = 0; l < lanes; ++l) force[row + l] = {fx[l], fy[l]};
    }
}

void pressure_gradient(const PairRows& p, const double* pressure, double* force_x, double* force_y) {
    for (int s = 0; s < p.slices; ++s) {
        const int row = p.first_row + s * lanes;
        double fx[lanes] = {};
        double fy[lanes] = {};
        for (int e = p.offset[s]; e < p.offset[s + 1]; e += lanes) {
            prefetch_gradients(p, e);
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

void velocity_divergence(const PairRows& p, const FloatPair* velocity, double* divergence) {
    for (int s = 0; s < p.slices; ++s) {
        const int row = p.first_row + s * lanes;
        float sum[lanes] = {};
        for (int e = p.offset[s]; e < p.offset[s + 1]; e += lanes) {
            prefetch_gradients(p, e);
            for (int l = 0; l < lanes; ++l) {
                const std::uint64_t own = word_of(velocity, row + l);
                const std::uint64_t other = word_of(velocity, p.column[e + l]);
                sum[l] += (first_of(other) - first_of(own)) * p.gx[e + l] +
                          (second_of(other) - second_of(own)) * p.gy[e + l];
            }
        }
        for (int l = 0; l < lanes; ++l) divergence[row + l] = static_cast<double>(sum[l]);
    }
}

void velocity_gradient(const PairRows& p, const FloatPair* velocity, VelocityGradients& gradients) {
    for (int s = 0; s < p.slices; ++s) {
        const int row = p.first_row + s * lanes;
        float xx[lanes] = {};
        float xy[lanes] = {};
        float yx[lanes] = {};
        float yy[lanes] = {};
        for (int e = p.offset[s]; e < p.offset[s + 1]; e += lanes) {
            prefetch_gradients(p, e);
            for (int l = 0; l < lanes; ++l) {
                const std::uint64_t own = word_of(velocity, row + l);
                const std::uint64_t other = word_of(velocity, p.column[e + l]);
                const float dvx = first_of(other) - first_of(own);
                const float dvy = second_of(other) - second_of(own);
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

void update_stress(const PairRows& p, const VelocityGradients& g, const StressUpdate& update) {
    const float* __restrict__ b0 = update.correction[0] + p.first_row;
    const float* __restrict__ b1 = update.correction[1] + p.first_row;
    const float* __restrict__ b2 = update.correction[2] + p.first_row;
    const float* __restrict__ b3 = update.correction[3] + p.first_row;
    const float* __restrict__ strength = update.strength + p.first_row;
    FloatPair* __restrict__ stress = update.stress + p.first_row;
    FloatPair* __restrict__ ahead = update.ahead + p.first_row;
    const float half_step = 0.5F * update.step;
    const float momentum = update.momentum;
    // Without this pragma the compiler leaves the loop scalar.
#pragma omp simd
    for (int k = 0; k < p.slices * lanes; ++k) {
        const float xx = g.xx[k] * b0[k] + g.xy[k] * b2[k];
        const float xy = g.xx[k] * b1[k] + g.xy[k] * b3[k];
        const float yx = g.yx[k] * b0[k] + g.yy[k] * b2[k];
        const float yy = g.yx[k] * b1[k] + g.yy[k] * b3[k];
        const float trial_xx = ahead[k].x - half_step * (xx - yy);
        const float trial_xy = ahead[k].y - half_step * (xy + yx);
        const float size2 = trial_xx * trial_xx + trial_xy * trial_xy;
        const float ratio = strength[k] / __builtin_sqrtf(size2 + 1e-30F);
        const float scale = ratio < 1.0F ? ratio : 1.0F;
        const float new_xx = scale * trial_xx;
        const float new_xy = scale * trial_xy;
        ahead[k].x = new_xx + momentum * (new_xx - stress[k].x);
        ahead[k].y = new_xy + momentum * (new_xy - stress[k].y);
        stress[k].x = new_xx;
        stress[k].y = new_xy;
    }
}

void rotate_stress(const PairRows& p, const VelocityGradients& g, const StressRotation& rotation) {
    const float* __restrict__ b0 = rotation.correction[0] + p.first_row;
    const float* __restrict__ b1 = rotation.correction[1] + p.first_row;
    const float* __restrict__ b2 = rotation.correction[2] + p.first_row;
    const float* __restrict__ b3 = rotation.correction[3] + p.first_row;
    FloatPair* __restrict__ stress = rotation.stress + p.first_row;
    const float half_dt = 0.5F * rotation.dt;
#pragma omp simd
    for (int k = 0; k < p.slices * lanes; ++k) {
        const float xy = g.xx[k] * b1[k] + g.xy[k] * b3[k];
        const float yx = g.yx[k] * b0[k] + g.yy[k] * b2[k];
        // The components turn by twice the angle of the soil; t is the tangent of half of that.
        const float t = half_dt * (yx - xy);
        const float inverse = 1.0F / (1.0F + t * t);
        const float c = (1.0F - t * t) * inverse;
        const float sine = 2.0F * t * inverse;
        const float sxx = stress[k].x;
        const float sxy = stress[k].y;
        stress[k].x = c * sxx - sine * sxy;
        stress[k].y = sine * sxx + c * sxy;
    }
}

void pressure_product(const PairRows& p, const double* diagonal, const double* x, double* out) {
    for (int s = 0; s < p.slices; ++s) {
        const int row = p.first_row + s * lanes;
        double sum[lanes] = {};
        for (int e = p.offset[s]; e < p.offset[s + 1]; e += lanes) {
            prefetch(p.next.column, e);
            prefetch(p.next.stiffness, e);
            for (int l = 0; l < lanes; ++l) sum[l] += p.stiffness[e + l] * x[p.column[e + l]];
        }
        for (int l = 0; l < lanes; ++l) out[row + l] = diagonal[row + l] * x[row + l] - sum[l];
    }
}

/// Gradient, k and W of one pair. All are 0 for a pair one support apart.
struct PairValues {
    float gx, gy, stiffness, kernel_value;
};

inline PairValues pair_values(float dx, float dy, const GeometryConstants& c) {
    const float r2 = dx * dx + dy * dy;
    const float q = __builtin_sqrtf(r2) * c.inverse_h;
    const float open = 1.0F - 0.5F * q;
    const float b = open > 0.0F ? open : 0.0F;
    const float b3 = b * b * b;
    return {c.gradient_scale * b3 * dx, c.gradient_scale * b3 * dy,
            c.stiffness_scale * b3 * r2 / (r2 + c.eta2), c.value_scale * b3 * b * (2.0F * q + 1.0F)};
}

void pair_geometry(const PairGeometry& p, const GeometryConstants& constants) {
    const GeometryConstants c = constants;
    const float* __restrict__ dx = p.dx;
    const float* __restrict__ dy = p.dy;
    float* __restrict__ gx = p.gx;
    float* __restrict__ gy = p.gy;
    float* __restrict__ stiffness = p.stiffness;
    float* __restrict__ kernel_value = p.kernel_value;
    for (int k = 0; k < p.count; ++k) {
        const PairValues pair = pair_values(dx[k], dy[k], c);
        gx[k] = pair.gx;
        gy[k] = pair.gy;
        stiffness[k] = pair.stiffness;
        kernel_value[k] = pair.kernel_value;
    }
}

void slice_geometry(const SliceGeometry& slice, const GeometryConstants& constants, SliceSums& sums) {
    const GeometryConstants c = constants;
    SliceSums total{};
    for (int e = 0; e < slice.width; ++e) {
        const FloatPair* __restrict__ separation = slice.separation + e * lanes;
        float* __restrict__ gx = slice.gx + e * lanes;
        float* __restrict__ gy = slice.gy + e * lanes;
        float* __restrict__ stiffness = slice.stiffness + e * lanes;
        for (int l = 0; l < lanes; ++l) {
            const float dx = separation[l].x;
            const float dy = separation[l].y;
            const PairValues pair = pair_values(dx, dy, c);
            gx[l] = pair.gx;
            gy[l] = pair.gy;
            stiffness[l] = pair.stiffness;
            total.kernel_sum[l] += pair.kernel_value;
            total.stiffness[l] += pair.stiffness;
            total.surface_x[l] += pair.gx;
            total.surface_y[l] += pair.gy;
            total.xx[l] -= dx * pair.gx;
            total.xy[l] -= dx * pair.gy;
            total.yy[l] -= dy * pair.gy;
        }
    }
    sums = total;
}

constexpr PairKernels table() {
    return {stress_divergence, pressure_gradient, velocity_divergence, velocity_gradient,
            update_stress,     rotate_stress,     pressure_product,    select_near,
            select_near_slice, pair_geometry,     slice_geometry};
}

}  // namespace
}  // namespace runout::kernels
