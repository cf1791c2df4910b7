#pragma once

#include <span>

#include "engine/particles/bed_line.h"
#include "engine/particles/kernel.h"

namespace runout {

/// Read-only view of a running simulation, valid until its next step. Spans have one value per soil particle.
struct StateView {
    double time = 0;  ///< s since release
    const Discretisation* discretisation = nullptr;
    const BedLine* bed = nullptr;
    const BedLine* ground =
        nullptr;  ///< the bed without barrier and erodible layer: where thickness and run-out start
    double gravity = 0;
    std::span<const double> x, y;      ///< m, local frame
    std::span<const double> vx, vy;    ///< m/s
    std::span<const double> pressure;  ///< Pa
    std::span<const double> sxx, sxy;  ///< Pa
    std::span<const double>
        density;              ///< rho / rho_0, where the particles stood at the start of the last step
    std::span<const int> id;  ///< number given at packing
    /// 1: soil of an erodible layer that has not moved yet, no part of the debris. Empty without such a
    /// layer.
    std::span<const char> resting_layer;

    [[nodiscard]] bool is_debris(std::size_t i) const {
        return resting_layer.empty() || resting_layer[i] == 0;
    }
};

}  // namespace runout
