#include "accuracy/richardson.h"

#include <cmath>

namespace runout {
namespace {

constexpr int most_iterations = 200;
constexpr double iteration_tolerance = 1e-13;

/// p of (f3 - f2) / (f2 - f1) = r21^p (r32^p - 1) / (r21^p - 1); both ratios above one.
double observed_order(double quotient, double r21, double r32) {
    double order = std::log(quotient) / std::log(r21);
    for (int k = 0; k < most_iterations; ++k) {
        const double q = std::log((std::pow(r21, order) - 1.0) / (std::pow(r32, order) - 1.0));
        const double next = (std::log(quotient) + q) / std::log(r21);
        const bool settled = std::abs(next - order) < iteration_tolerance;
        order = next;
        if (settled || !(order > 0)) break;
    }
    return order;
}

}  // namespace

std::optional<Richardson> richardson(const std::array<GridValue, 3>& values) {
    const auto& [fine, medium, coarse] = values;
    const double near = medium.value - fine.value, far = coarse.value - medium.value;
    const double r21 = medium.spacing / fine.spacing, r32 = coarse.spacing / medium.spacing;
    if (!(near * far > 0)) return std::nullopt;
    const double order = observed_order(far / near, r21, r32);
    if (!(order > 0) || !std::isfinite(order)) return std::nullopt;
    const double growth = std::pow(r21, order) - 1.0;
    return Richardson{order, fine.value - near / growth,
                      std::abs(gci_safety_factor * near / growth / fine.value)};
}

}  // namespace runout
