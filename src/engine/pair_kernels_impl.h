#pragma once

// Bodies of the pair kernels, for the files that compile them for one instruction set each. Nothing but plain
// arrays and arithmetic may be used here: whatever function of a header is compiled with wider instructions
// could be the copy that the linker keeps for the whole program.

#if defined(__AVX2__)
#include <immintrin.h>
#endif

#include "engine/pair_kernels.h"

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

/// Asks for entry e of an array that the next block has. Its arrays are too short for the machine to see by
/// itself where they are, and memory answers later than the sums take.
template <class T>
inline void prefetch(const T* next, int e) {
    // As a number: the block may have fewer entries than this one, and a prefetch of nothing does no harm.
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

void update_stress(const PairRows& p, const StressUpdate& update) {
    VelocityGradients g;
    velocity_gradient(p, update.velocity, g);
    const float* __restrict__ b0 = update.correction[0] + p.first_row;
    const float* __restrict__ b1 = update.correction[1] + p.first_row;
    const float* __restrict__ b2 = update.correction[2] + p.first_row;
    const float* __restrict__ b3 = update.correction[3] + p.first_row;
    const float* __restrict__ strength = update.strength + p.first_row;
    FloatPair* __restrict__ stress = update.stress + p.first_row;
    FloatPair* __restrict__ ahead = update.ahead + p.first_row;
    const float half_step = 0.5F * update.step;
    const float momentum = update.momentum;
    // Asked for: by its own estimate the compiler leaves this loop scalar.
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

void rotate_stress(const PairRows& p, const StressRotation& rotation) {
    VelocityGradients g;
    velocity_gradient(p, rotation.velocity, g);
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

/// Branchless: every candidate is written, and kept by moving on.
int select_near(const double* x, const double* y, const NearQuery& query, float support2,
                std::int32_t* column, float* dx, float* dy) {
    int count = 0;
    for (int r = 0; r < query.ranges; ++r) {
        for (int k = query.first[r]; k < query.last[r]; ++k) {
            const auto sx = static_cast<float>(query.x - x[k]);
            const auto sy = static_cast<float>(query.y - y[k]);
            column[count] = k;
            dx[count] = sx;
            dy[count] = sy;
            count += static_cast<int>(sx * sx + sy * sy < support2);
        }
    }
    return count;
}

/// Separations of a slice's rows from one point, x_row - x. Returns a bit for each row that is near.
inline std::uint32_t near_rows(const double* row_x, const double* row_y, double x, double y, float support2,
                               FloatPair* separations) {
#if defined(__AVX2__)
    std::uint32_t near = 0;
    for (int first = 0; first < lanes; first += 4) {
        const auto separation = [first](const double* rows, double from) {
            return _mm256_cvtpd_ps(_mm256_sub_pd(_mm256_loadu_pd(rows + first), _mm256_set1_pd(from)));
        };
        const __m128 sx = separation(row_x, x);
        const __m128 sy = separation(row_y, y);
        float* to = &separations[first].x;
        _mm_storeu_ps(to, _mm_unpacklo_ps(sx, sy));
        _mm_storeu_ps(to + 4, _mm_unpackhi_ps(sx, sy));
        const __m128 r2 = _mm_add_ps(_mm_mul_ps(sx, sx), _mm_mul_ps(sy, sy));
        near |= static_cast<std::uint32_t>(_mm_movemask_ps(_mm_cmplt_ps(r2, _mm_set1_ps(support2)))) << first;
    }
    return near;
#else
    std::uint32_t near = 0;
    for (int l = 0; l < lanes; ++l) {
        const auto sx = static_cast<float>(row_x[l] - x);
        const auto sy = static_cast<float>(row_y[l] - y);
        separations[l] = {sx, sy};
        near |= static_cast<std::uint32_t>(sx * sx + sy * sy < support2) << l;
    }
    return near;
#endif
}

constexpr int candidate_group = 4;  // bits of as many candidates fit into a word

/// A group of candidates at a time: the processor foretells the end of one long loop over near rows better
/// than of four short ones.
void select_near_slice(const double* x, const double* y, const SliceQuery& query, float support2,
                       const SliceNear& near) {
    const double* row_x = x + query.first_row;
    const double* row_y = y + query.first_row;
    FloatPair separation[candidate_group * lanes];
    std::size_t slot[lanes];
    for (int l = 0; l < lanes; ++l) slot[l] = static_cast<std::size_t>(l);
    for (int first = 0; first < query.count; first += candidate_group) {
        const std::int32_t* candidate = query.candidate + first;
        std::uint64_t pairs = 0;
        for (int c = 0; c < candidate_group && first + c < query.count; ++c) {
            const int k = candidate[c];
            const auto own = static_cast<unsigned>(k - query.first_row);
            const std::uint32_t self = own < lanes ? 1U << own : 0U;
            const std::uint32_t rows = near_rows(row_x, row_y, x[k], y[k], support2, separation + c * lanes);
            pairs |= static_cast<std::uint64_t>(rows & query.asking & ~self) << (c * lanes);
        }
        for (; pairs != 0; pairs &= pairs - 1) {
            const auto bit = static_cast<unsigned>(__builtin_ctzll(pairs));
            std::size_t& next = slot[bit % lanes];
            near.column[next] = candidate[bit / lanes];
            near.separation[next] = separation[bit];
            next += lanes;
        }
    }
    for (int l = 0; l < lanes; ++l) {
        if ((query.asking >> l & 1U) != 0) near.count[l] = static_cast<int>(slot[l] / lanes);
    }
}

/// Gradient, k and kernel of one pair. Nothing comes of a pair one support apart.
struct PairValues {
    float gx, gy, stiffness, kernel;
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
    float* __restrict__ kernel = p.kernel;
    for (int k = 0; k < p.count; ++k) {
        const PairValues pair = pair_values(dx[k], dy[k], c);
        gx[k] = pair.gx;
        gy[k] = pair.gy;
        stiffness[k] = pair.stiffness;
        kernel[k] = pair.kernel;
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
            total.kernel[l] += pair.kernel;
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
