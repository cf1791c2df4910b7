#pragma once

#include <vector>

#include "engine/pair_kernels.h"

namespace runout {

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
