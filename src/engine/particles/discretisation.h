#pragma once

#include <cmath>

#include "engine/particles/kernel.h"

namespace runout {

/// Density ratio below which a particle belongs to the free surface (the paper's 0.97).
constexpr double surface_density = 0.97;

/// Density ratio below which a particle flies alone. It does not load the others or pull at them, and does
/// not set their time step.
constexpr double body_density = 0.6;

/// Numbers that every operator needs, the same for the whole run.
struct Discretisation {
    double spacing = 0;            ///< dl, m; spacing^2 is a particle's volume per metre of width
    double smoothing_length = 0;   ///< h, m
    double density = 0;            ///< rho_0, kg/m3
    double lattice_sum = 0;        ///< sum of W over the full lattice, 1/m2: density ratio 1 by definition
    double lattice_stiffness = 0;  ///< sum of k over the full lattice, m/kg (see `stiffness`)

    /// Of a particle, m3 per metre of width.
    [[nodiscard]] double volume() const { return spacing * spacing; }
    /// Of a particle, kg per metre of width.
    [[nodiscard]] double mass() const { return density * volume(); }

    /// k_ij of the symmetric pressure equation (eq. 5 with rho = rho_0):
    /// -(2 m / rho_0^2) x.gradW / (r^2 + eta^2), eta = 0.1 h. `slope`: WendlandKernel::slope at distance r,
    /// 1/m4; `r2`: r^2, m2.
    [[nodiscard]] double stiffness(double slope, double r2) const {
        return -(2.0 * volume() / density) * slope * r2 / (r2 + eta2());
    }
    /// eta^2 of eq. 5, which keeps its denominator from 0, m2.
    [[nodiscard]] double eta2() const { return 0.01 * smoothing_length * smoothing_length; }
};

/// Discretisation with its sums over a square lattice. `spacing`: dl, m; `smoothing_ratio`: h/dl; `density`:
/// rho_0, kg/m3. All positive.
inline Discretisation make_discretisation(double spacing, double smoothing_ratio, double density) {
    Discretisation d{spacing, smoothing_ratio * spacing, density, 0.0, 0.0};
    const WendlandKernel kernel(d.smoothing_length);
    const int reach = static_cast<int>(std::ceil(2.0 * smoothing_ratio));
    for (int i = -reach; i <= reach; ++i) {
        for (int j = -reach; j <= reach; ++j) {
            const double r = spacing * std::hypot(i, j);
            d.lattice_sum += kernel.value(r);
            if (i != 0 || j != 0) d.lattice_stiffness += d.stiffness(kernel.slope(r), r * r);
        }
    }
    return d;
}

}  // namespace runout
