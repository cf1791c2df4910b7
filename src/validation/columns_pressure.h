#pragma once

#include "measures/measures.h"

namespace runout {

/// Part of a snapshot and what its pressure is measured by.
struct PressureProbe {
    double x_end_m = 0;  ///< particles from the wall up to here
    double spacing_m = 0;
    double unit_weight = 0;    ///< rho g, N/m3
    double pressure_unit = 0;  ///< rho g H, Pa
};

struct PressureNoise {
    double from_lithostatic = 0;  ///< rms of p - rho g (surface - y), in units
    /// rms of p against the plane fitted to the pressures within two spacings, in units: what varies from
    /// particle to particle. A plane, not their mean: at an uneven spacing the mean sees the gradient of the
    /// weight as noise.
    double local = 0;
};

/// Throws nothing; NaN where no particle lies in the part.
PressureNoise pressure_noise(const Snapshot& snapshot, const PressureProbe& probe);

}  // namespace runout
