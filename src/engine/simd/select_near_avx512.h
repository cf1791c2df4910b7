#pragma once

// Which particles are near the rows of a slice, for machines with AVX-512; a part of select_near_impl.h. Each
// row looks at sixteen candidates at once and keeps those that are near by one instruction, without a branch
// that could be predicted wrongly. The rows are then transposed, so that they lie lane beside lane.

#include <immintrin.h>

#include "engine/simd/pair_kernels.h"

namespace runout::kernels {
namespace {

constexpr int group = 16;  // candidates that a row looks at at a time
// Neighbours of a row that fit here; even soil of twice the density has fewer.
constexpr int most_near = 4 * group;

/// What is near one row.
struct NearRow {
    int count = 0;
    alignas(64) std::int32_t column[most_near + group];
    alignas(64) float dx[most_near + group];
    alignas(64) float dy[most_near + group];
};

/// A group of candidates; those beyond the last are not `valid`.
struct Candidates {
    __mmask16 valid;
    __m512i index;
    __m512d x[2], y[2];
};

inline Candidates load_candidates(const double* x, const double* y, const std::int32_t* candidate,
                                  int count) {
    Candidates c;
    c.valid = static_cast<__mmask16>(count < group ? (1U << count) - 1U : 0xFFFFU);
    c.index = _mm512_maskz_loadu_epi32(c.valid, candidate);
    const __m512d zero = _mm512_setzero_pd();
    for (int h = 0; h < 2; ++h) {
        const auto valid = static_cast<__mmask8>(c.valid >> (8 * h));
        const __m256i half = _mm256_maskz_loadu_epi32(valid, candidate + 8 * h);
        c.x[h] = _mm512_mask_i32gather_pd(zero, valid, half, x, sizeof(double));
        c.y[h] = _mm512_mask_i32gather_pd(zero, valid, half, y, sizeof(double));
    }
    return c;
}

/// x_row - x of each candidate, in double precision, then rounded to single.
inline __m512 separation(double row, const __m512d* candidates) {
    const __m512d from = _mm512_set1_pd(row);
    const __m256 low = _mm512_maskz_cvtpd_ps(0xFF, _mm512_sub_pd(from, candidates[0]));
    const __m256 high = _mm512_maskz_cvtpd_ps(0xFF, _mm512_sub_pd(from, candidates[1]));
    return _mm512_insertf32x8(_mm512_castps256_ps512(low), high, 1);
}

/// Adds those of a group that are near row i. There must be room for all of them.
inline void add_near(const Candidates& c, int i, double x, double y, float support2, NearRow& row) {
    const __m512 dx = separation(x, c.x);
    const __m512 dy = separation(y, c.y);
    const __m512 r2 = _mm512_add_ps(_mm512_mul_ps(dx, dx), _mm512_mul_ps(dy, dy));
    const __mmask16 others = _mm512_mask_cmpneq_epi32_mask(c.valid, c.index, _mm512_set1_epi32(i));
    const __mmask16 near = _mm512_mask_cmp_ps_mask(others, r2, _mm512_set1_ps(support2), _CMP_LT_OQ);
    const int count = row.count;
    _mm512_storeu_si512(row.column + count, _mm512_maskz_compress_epi32(near, c.index));
    _mm512_storeu_ps(row.dx + count, _mm512_maskz_compress_ps(near, dx));
    _mm512_storeu_ps(row.dy + count, _mm512_maskz_compress_ps(near, dy));
    row.count = count + __builtin_popcount(near);
}

constexpr std::int32_t first_halves[16] = {0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23};
constexpr std::int32_t second_halves[16] = {8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31};

/// Sixteen rows of sixteen become columns: four perfect shuffles of the rows.
inline void transpose(__m512 (&rows)[lanes]) {
    const __m512i first = _mm512_loadu_si512(first_halves);
    const __m512i second = _mm512_loadu_si512(second_halves);
    for (int stage = 0; stage < 4; ++stage) {
        __m512 shuffled[lanes];
        for (int l = 0; l < lanes / 2; ++l) {
            shuffled[2 * l] = _mm512_permutex2var_ps(rows[l], first, rows[l + lanes / 2]);
            shuffled[2 * l + 1] = _mm512_permutex2var_ps(rows[l], second, rows[l + lanes / 2]);
        }
        for (int l = 0; l < lanes; ++l) rows[l] = shuffled[l];
    }
}

/// Writes entries [first, last) of the rows that ask, at most 16, lane beside lane.
inline void write_lanes(const NearRow* rows, int first, int last, __mmask16 asking, const SliceNear& near) {
    __m512 column[lanes];
    __m512 dx[lanes];
    __m512 dy[lanes];
    for (int l = 0; l < lanes; ++l) {
        column[l] = _mm512_loadu_ps(rows[l].column + first);
        dx[l] = _mm512_loadu_ps(rows[l].dx + first);
        dy[l] = _mm512_loadu_ps(rows[l].dy + first);
    }
    transpose(column);
    transpose(dx);
    transpose(dy);
    const __m512i low = _mm512_loadu_si512(first_halves);
    const __m512i high = _mm512_loadu_si512(second_halves);
    const __mmask16 low_asking = static_cast<__mmask16>(_pdep_u32(asking, 0x5555U) * 3U);
    const __mmask16 high_asking = static_cast<__mmask16>(_pdep_u32(asking >> 8U, 0x5555U) * 3U);
    for (int e = first; e < last; ++e) {
        _mm512_mask_storeu_ps(near.column + e * lanes, asking, column[e - first]);
        float* to = &near.separation[e * lanes].x;
        _mm512_mask_storeu_ps(to, low_asking, _mm512_permutex2var_ps(dx[e - first], low, dy[e - first]));
        _mm512_mask_storeu_ps(to + 16, high_asking,
                              _mm512_permutex2var_ps(dx[e - first], high, dy[e - first]));
    }
}

/// As select_near_slice, sixteen candidates of a row at a time. False, and nothing done: too much is near.
inline bool select_near_wide(const double* x, const double* y, const SliceQuery& query, float support2,
                             const SliceNear& near) {
    NearRow rows[lanes];
    int most = 0;
    for (int first = 0; first < query.count; first += group) {
        if (most > most_near) return false;
        const Candidates candidates = load_candidates(x, y, query.candidate + first, query.count - first);
        for (std::uint32_t left = query.asking; left != 0; left &= left - 1) {
            const int l = __builtin_ctz(left);
            const int i = query.first_row + l;
            add_near(candidates, i, x[i], y[i], support2, rows[l]);
            most = rows[l].count > most ? rows[l].count : most;
        }
    }
    for (int first = 0; first < most; first += group)
        write_lanes(rows, first, most < first + group ? most : first + group,
                    static_cast<__mmask16>(query.asking), near);
    for (std::uint32_t left = query.asking; left != 0; left &= left - 1) {
        const int l = __builtin_ctz(left);
        near.count[l] = rows[l].count;
    }
    return true;
}

}  // namespace
}  // namespace runout::kernels
