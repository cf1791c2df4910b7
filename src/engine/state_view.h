#pragma once

#include <span>

#include "engine/bed_line.h"
#include "engine/kernel.h"

namespace runout {

/// Read-only view of a running simulation, valid until its next step. Spans have one value per soil particle.
struct StateView {
    double time = 0;  ///< s since release
    const Discretisation* discretisation = nullptr;
    const BedLine* bed = nullptr;
    double gravity = 0;
    std::span<const double> x, y;      ///< m, local frame
    std::span<const double> vx, vy;    ///< m/s
    std::span<const double> pressure;  ///< Pa
    std::span<const double> sxx, sxy;  ///< Pa
    std::span<const double>
        density;              ///< rho / rho_0, where the particles stood at the start of the last step
    std::span<const int> id;  ///< number given at packing
};

}  // namespace runout
