#pragma once

#include <array>
#include <cstddef>
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

    [[nodiscard]] int padded() const { return (count + lanes - 1) / lanes * lanes; }
};

/// All arrays of a Soil, by kind of value.
struct SoilFields {
    std::array<std::vector<double>*, 9> numbers;
    std::array<std::vector<int>*, 1> names;
};

/// All arrays named here grow and are sorted together. A new member of Soil must be named here, or this does
/// not compile.
inline SoilFields fields_of(Soil& soil) {
    auto& [count, x, y, vx, vy, pressure, sxx, sxy, contact_x, contact_y, id] = soil;
    return {{&x, &y, &vx, &vy, &pressure, &sxx, &sxy, &contact_x, &contact_y}, {&id}};
}

/// Adds particles, m, at rest and free of stress. Their numbers follow those before.
inline void append_soil(Soil& soil, const std::vector<Vec2>& points) {
    const auto old_count = static_cast<std::size_t>(soil.count);
    soil.count += static_cast<int>(points.size());
    const auto grow = [&](auto& field) {
        field.resize(old_count);
        field.resize(static_cast<std::size_t>(soil.padded()));
    };
    const SoilFields fields = fields_of(soil);
    for (auto* field : fields.numbers) grow(*field);
    for (auto* field : fields.names) grow(*field);
    for (std::size_t k = 0; k < points.size(); ++k) {
        soil.x[old_count + k] = points[k].x();
        soil.y[old_count + k] = points[k].y();
        soil.id[old_count + k] = static_cast<int>(old_count + k);
    }
}

/// Soil at these points, m, at rest and free of stress, numbered in their order.
inline Soil soil_at(const std::vector<Vec2>& points) {
    Soil soil;
    append_soil(soil, points);
    return soil;
}

}  // namespace runout
