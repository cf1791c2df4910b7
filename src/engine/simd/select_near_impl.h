#pragma once

// Which particles are near others; see pair_kernels_impl.h, of which this is a part.

#if defined(__AVX512DQ__) && defined(__AVX512VL__)
#include "engine/simd/select_near_avx512.h"
#elif defined(__AVX2__)
#include <immintrin.h>
#endif

#include "engine/simd/pair_kernels.h"

namespace runout::kernels {
namespace {

/// Without branches: every candidate is written, and the next one overwrites it unless it is near.
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

/// Takes a group of candidates at a time: one long loop over near rows has fewer wrongly predicted branches
/// than four short ones.
void select_near_slice(const double* x, const double* y, const SliceQuery& query, float support2,
                       const SliceNear& near) {
#if defined(__AVX512DQ__) && defined(__AVX512VL__)
    if (select_near_wide(x, y, query, support2, near)) return;
#endif
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

}  // namespace
}  // namespace runout::kernels
