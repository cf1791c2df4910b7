#pragma once

#include <vector>

namespace runout {

/// Rows of the pair lists are worked on in slices of this many lanes.
constexpr int lanes = 16;

/// Particles of soil, structure of arrays, kept in spatial order. All have the same mass and volume.
struct Soil {
    int count = 0;
    std::vector<double> x, y;      ///< position, m
    std::vector<double> vx, vy;    ///< velocity, m/s
    std::vector<double> pressure;  ///< mean stress, compression positive, Pa
    std::vector<double> sxx, sxy;  ///< deviatoric stress, compression positive (syy = -sxx), Pa
    std::vector<int> id;           ///< number given at packing
    std::vector<int> aggregate;    ///< coarse cell of the pressure solver, -1: none yet

    [[nodiscard]] int padded() const { return (count + lanes - 1) / lanes * lanes; }
};

}  // namespace runout
