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

/// All that particles carry with them, by kind of value.
struct SoilFields {
    std::array<std::vector<double>*, 9> numbers;
    std::array<std::vector<int>*, 1> names;
};

/// What is named here grows, is appended to and is sorted with the soil. A new member must be named, or this
/// does not compile.
inline SoilFields fields_of(Soil& soil) {
    auto& [count, x, y, vx, vy, pressure, sxx, sxy, contact_x, contact_y, id] = soil;
    return {{&x, &y, &vx, &vy, &pressure, &sxx, &sxy, &contact_x, &contact_y}, {&id}};
}

/// Adds particles at rest and free of stress, numbered on.
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

/// Soil at rest and free of stress, numbered in the order given, m.
inline Soil soil_at(const std::vector<Vec2>& points) {
    Soil soil;
    append_soil(soil, points);
    return soil;
}

}  // namespace runout
