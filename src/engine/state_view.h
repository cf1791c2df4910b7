#pragma once

#include <span>

#include "engine/particles/bed_line.h"
#include "engine/particles/discretisation.h"

namespace runout {

/// Read-only view of a running simulation, valid until its next step and while it lives. Every span has one
/// value per soil particle, all in the same order.
struct StateView {
    double time = 0;                                 ///< s since release
    const Discretisation* discretisation = nullptr;  ///< spacing, density and the like
    const BedLine* bed = nullptr;                    ///< what is rigid under the soil
    /// The bed without barrier and erodible layer: where thickness and run-out start.
    const BedLine* ground = nullptr;
    double gravity = 0;                ///< m/s2
    std::span<const double> x,         ///< position in the frame of the problem, m
        y;                             ///< upwards, m
    std::span<const double> vx,        ///< velocity, m/s
        vy;                            ///< upwards, m/s
    std::span<const double> pressure;  ///< mean stress in the plane, compression positive, Pa
    std::span<const double> sxx,       ///< deviatoric stress, compression positive, Pa; syy = -sxx
        sxy;                           ///< likewise
    /// rho / rho_0, where the particles stood at the start of the last step.
    std::span<const double> density;
    std::span<const int> id;  ///< number given at packing, from 0; the order of the particles changes
    /// 1: soil of an erodible layer that has not moved yet, no part of the debris. Empty without such a
    /// layer.
    std::span<const char> unmoved_layer;

    /// Whether particle `i` of the spans is debris: not of a layer that still lies.
    [[nodiscard]] bool is_debris(std::size_t i) const {
        return unmoved_layer.empty() || unmoved_layer[i] == 0;
    }
};

}  // namespace runout
