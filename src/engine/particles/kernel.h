#pragma once

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

    /// W at distance `r`, m; 1/m2.
    [[nodiscard]] double value(double r) const {
        const double q = r * inverse_h_;
        const double c = 1.0 - 0.5 * q;
        return q < 2.0 ? value_scale_ * (c * c) * (c * c) * (2.0 * q + 1.0) : 0.0;
    }

    /// (1/r) dW/dr at distance `r`, m; 1/m4. Never positive, finite at r = 0.
    [[nodiscard]] double slope(double r) const {
        const double c = 1.0 - 0.5 * r * inverse_h_;
        return c > 0.0 ? slope_scale_ * c * c * c : 0.0;
    }

    /// 1/h, 1/m.
    [[nodiscard]] double inverse_smoothing_length() const { return inverse_h_; }
    /// 7/(4 pi h^2), 1/m2.
    [[nodiscard]] double value_scale() const { return value_scale_; }
    /// -35/(4 pi h^4), 1/m4.
    [[nodiscard]] double slope_scale() const { return slope_scale_; }

  private:
    double inverse_h_;
    double value_scale_;
    double slope_scale_;
};

}  // namespace runout
