#include "accuracy/richardson.h"

#include <cmath>
#include <limits>

namespace runout {
namespace {

constexpr double greatest_order = 50.0;
constexpr int bisections = 200;

/// (f3 - f2) / (f2 - f1) of f0 + c h^order; rises with the order. Both ratios above one.
double quotient_of(double order, double r21, double r32) {
    return std::pow(r21, order) * std::expm1(order * std::log(r32)) / std::expm1(order * std::log(r21));
}

/// NaN when no positive order has this quotient.
double observed_order(double quotient, double r21, double r32) {
    double low = 0, high = greatest_order;
    const double least = std::log(r32) / std::log(r21);  // of order zero
    if (!(quotient > least) || !(quotient < quotient_of(high, r21, r32)))
        return std::numeric_limits<double>::quiet_NaN();
    for (int k = 0; k < bisections; ++k) {
        const double middle = 0.5 * (low + high);
        if (quotient_of(middle, r21, r32) < quotient)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

std::optional<Richardson> richardson(const std::array<GridValue, 3>& values) {
    const auto& [fine, medium, coarse] = values;
    const double near = medium.value - fine.value, far = coarse.value - medium.value;
    const double r21 = medium.spacing / fine.spacing, r32 = coarse.spacing / medium.spacing;
    if (!(near * far > 0)) return std::nullopt;
    const double order = observed_order(far / near, r21, r32);
    if (!std::isfinite(order)) return std::nullopt;
    const double growth = std::pow(r21, order) - 1.0;
    return Richardson{order, fine.value - near / growth,
                      std::abs(gci_safety_factor * near / growth / fine.value)};
}

}  // namespace runout
