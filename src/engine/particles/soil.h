#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

#include "core/geometry.h"
#include "engine/simd/pair_kernels.h"

namespace runout {

/// Particles of soil, structure of arrays, kept in spatial order. All have the same mass and volume.
struct Soil {
    int count = 0;
    std::vector<double> x, y;                  ///< position, m
    std::vector<double> vx, vy;                ///< velocity, m/s
    std::vector<double> pressure;              ///< mean stress, compression positive, Pa
    std::vector<double> sxx, sxy;              ///< deviatoric stress, compression positive (syy = -sxx), Pa
    std::vector<double> contact_x, contact_y;  ///< push of the bed line in the last step, m/s2
    std::vector<int> id;                       ///< number given at packing
    std::vector<int> aggregate;                ///< coarse cell of the pressure solver, -1: none yet

    [[nodiscard]] int padded() const { return (count + lanes - 1) / lanes * lanes; }
};

/// Soil at rest and free of stress, numbered in the order given. x, y: m, of one length.
inline Soil soil_at(const std::vector<double>& x, const std::vector<double>& y) {
    Soil soil;
    soil.count = static_cast<int>(x.size());
    const auto padded = static_cast<std::size_t>(soil.padded());
    soil.x = x;
    soil.y = y;
    for (auto* field : {&soil.x, &soil.y, &soil.vx, &soil.vy, &soil.pressure, &soil.sxx, &soil.sxy,
                        &soil.contact_x, &soil.contact_y}) {
        field->resize(padded, 0.0);
    }
    soil.id.resize(padded);
    std::iota(soil.id.begin(), soil.id.end(), 0);
    soil.aggregate.resize(padded, -1);
    return soil;
}

/// Adds particles at rest and free of stress, numbered on.
inline void append_soil(Soil& soil, const std::vector<Vec2>& points) {
    const auto old_count = static_cast<std::size_t>(soil.count);
    soil.count += static_cast<int>(points.size());
    const auto padded = static_cast<std::size_t>(soil.padded());
    for (auto* field : {&soil.x, &soil.y, &soil.vx, &soil.vy, &soil.pressure, &soil.sxx, &soil.sxy,
                        &soil.contact_x, &soil.contact_y}) {
        field->resize(old_count);
        field->resize(padded, 0.0);
    }
    soil.aggregate.resize(old_count);
    soil.aggregate.resize(padded, -1);
    soil.id.resize(padded);
    for (std::size_t k = 0; k < points.size(); ++k) {
        soil.x[old_count + k] = points[k].x();
        soil.y[old_count + k] = points[k].y();
        soil.id[old_count + k] = static_cast<int>(old_count + k);
    }
}

}  // namespace runout
