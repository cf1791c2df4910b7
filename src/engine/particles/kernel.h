#pragma once

#include <cmath>
#include <numbers>

namespace runout {

/// Wendland C2 kernel in two dimensions, support 2h (the paper's "quintic Wendland").
/// W(r) = 7/(4 pi h^2) (1 - q/2)^4 (2q + 1), q = r/h; its gradient is x * slope(r).
class WendlandKernel {
  public:
    /// h: smoothing length, m.
    explicit WendlandKernel(double h)
        : inverse_h_(1.0 / h),
          value_scale_(7.0 / (4.0 * std::numbers::pi * h * h)),
          slope_scale_(-35.0 / (4.0 * std::numbers::pi * h * h * h * h)) {}

    /// Distance at which the kernel ends, m.
    [[nodiscard]] double support() const { return 2.0 / inverse_h_; }

    /// W, 1/m2.
    [[nodiscard]] double value(double r) const {
        const double q = r * inverse_h_;
        const double c = 1.0 - 0.5 * q;
        return q < 2.0 ? value_scale_ * (c * c) * (c * c) * (2.0 * q + 1.0) : 0.0;
    }

    /// (1/r) dW/dr, 1/m4; never positive, finite at r = 0.
    [[nodiscard]] double slope(double r) const {
        const double c = 1.0 - 0.5 * r * inverse_h_;
        return c > 0.0 ? slope_scale_ * c * c * c : 0.0;
    }

    [[nodiscard]] double inverse_smoothing_length() const { return inverse_h_; }
    [[nodiscard]] double value_scale() const { return value_scale_; }
    [[nodiscard]] double slope_scale() const { return slope_scale_; }

  private:
    double inverse_h_;
    double value_scale_;
    double slope_scale_;
};

/// Density ratio below which a particle belongs to the free surface (the paper's 0.97).
constexpr double surface_density = 0.97;

/// Density ratio below which a particle flies alone: it does not load, pull at or pace the others.
constexpr double body_density = 0.6;

/// Numbers that every operator needs, the same for the whole run.
struct Discretisation {
    double spacing = 0;            ///< dl, m; spacing^2 is a particle's volume per metre of width
    double smoothing_length = 0;   ///< h, m
    double density = 0;            ///< rho_0, kg/m3
    double lattice_sum = 0;        ///< sum of W over the full lattice, 1/m2: density ratio 1 by definition
    double lattice_stiffness = 0;  ///< sum of k over the full lattice (see `stiffness`)

    [[nodiscard]] double volume() const { return spacing * spacing; }
    [[nodiscard]] double mass() const { return density * volume(); }

    /// k_ij of the symmetric pressure equation (eq. 5 with rho = rho_0): -(2 m / rho_0^2) x.gradW / (r^2 +
    /// eta^2), eta = 0.1 h; `slope` is the kernel's at distance r.
    [[nodiscard]] double stiffness(double slope, double r2) const {
        return -(2.0 * volume() / density) * slope * r2 / (r2 + eta2());
    }
    [[nodiscard]] double eta2() const { return 0.01 * smoothing_length * smoothing_length; }
};

/// Discretisation with its lattice sums, for a square lattice of the given spacing.
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
