#include "accuracy/refinement_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace runout {
namespace {

constexpr double least_order = 0.05, greatest_order = 8.0;         // sought
constexpr double least_usual_order = 0.5, most_usual_order = 2.1;  // believed
constexpr int orders_tried = 160;
constexpr double wide_safety_factor = 3.0;

/// Least-squares coefficients of value + sum_k c_k h^powers[k], and the standard deviation of the data with
/// `freedom` fitted numbers in all.
struct LinearFit {
    Eigen::VectorXd coefficients;
    double deviation = std::numeric_limits<double>::infinity();
};

LinearFit linear_fit(std::span<const GridValue> values, std::span<const double> powers, int fitted) {
    const auto count = static_cast<Eigen::Index>(values.size());
    const auto columns = static_cast<Eigen::Index>(powers.size()) + 1;
    Eigen::MatrixXd matrix(count, columns);
    Eigen::VectorXd right(count), weight(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const GridValue& at = values[static_cast<std::size_t>(i)];
        weight[i] = 1.0 / at.spacing;
        matrix(i, 0) = 1.0;
        for (Eigen::Index k = 1; k < columns; ++k)
            matrix(i, k) = std::pow(at.spacing, powers[static_cast<std::size_t>(k - 1)]);
        right[i] = at.value;
    }
    weight /= weight.sum();
    const Eigen::VectorXd root = weight.cwiseSqrt();
    LinearFit fit;
    fit.coefficients = (root.asDiagonal() * matrix).colPivHouseholderQr().solve(root.cwiseProduct(right));
    const Eigen::VectorXd rest = matrix * fit.coefficients - right;
    const double squares = static_cast<double>(count) * weight.dot(rest.cwiseAbs2());
    fit.deviation = std::sqrt(squares / std::max(1.0, static_cast<double>(count - fitted)));
    return fit;
}

/// value + first h^order.
RefinementFit power_fit(std::span<const GridValue> values, double order, int fitted) {
    const std::array powers{order};
    const LinearFit linear = linear_fit(values, powers, fitted);
    RefinementFit fit;
    fit.value = linear.coefficients[0];
    fit.first = linear.coefficients[1];
    fit.first_order = order;
    fit.deviation = linear.deviation;
    return fit;
}

RefinementFit first_and_second_order_fit(std::span<const GridValue> values) {
    constexpr std::array powers{1.0, 2.0};
    const LinearFit linear = linear_fit(values, powers, 3);
    RefinementFit fit;
    fit.value = linear.coefficients[0];
    fit.first = linear.coefficients[1];
    fit.second = linear.coefficients[2];
    fit.deviation = linear.deviation;
    return fit;
}

/// The order with the least deviation; refined between its neighbours by golden section.
RefinementFit best_order_fit(std::span<const GridValue> values) {
    const auto deviation = [&](double order) { return power_fit(values, order, 3).deviation; };
    const double ratio = std::pow(greatest_order / least_order, 1.0 / orders_tried);
    double best = least_order, least = deviation(best);
    for (int k = 1; k <= orders_tried; ++k) {
        const double order = least_order * std::pow(ratio, k);
        const double here = deviation(order);
        if (here < least) {
            least = here;
            best = order;
        }
    }
    double low = std::max(least_order, best / ratio), high = std::min(greatest_order, best * ratio);
    constexpr double golden = 0.6180339887498949;
    for (int k = 0; k < 60; ++k) {
        const double left = high - golden * (high - low), right = low + golden * (high - low);
        if (deviation(left) < deviation(right))
            high = right;
        else
            low = left;
    }
    return power_fit(values, 0.5 * (low + high), 3);
}

const RefinementFit& least_deviation(const std::vector<RefinementFit>& fits) {
    return *std::ranges::min_element(fits, {}, &RefinementFit::deviation);
}

}  // namespace

double RefinementFit::at(double spacing) const {
    return value + first * std::pow(spacing, first_order) + second * spacing * spacing;
}

RefinementFit fit_refinement(std::span<const GridValue> values) {
    const RefinementFit free = best_order_fit(values);
    const bool at_an_end =
        free.first_order < 1.001 * least_order || free.first_order > 0.999 * greatest_order;
    RefinementFit fit = free;
    const bool believed = free.first_order >= least_usual_order && free.first_order <= most_usual_order;
    if (free.first_order > most_usual_order) {
        fit = least_deviation({power_fit(values, 1.0, 2), power_fit(values, 2.0, 2)});
    } else if (!believed) {
        std::vector<RefinementFit> fits{power_fit(values, 1.0, 2), power_fit(values, 2.0, 2)};
        if (values.size() > 3) fits.push_back(first_and_second_order_fit(values));
        fit = least_deviation(fits);
    }
    fit.believed = believed;
    fit.safety_factor = believed ? gci_safety_factor : wide_safety_factor;
    fit.observed_order = at_an_end ? std::numeric_limits<double>::quiet_NaN() : free.first_order;
    const auto [low, high] = std::ranges::minmax(values, {}, &GridValue::value);
    fit.range_per_step = (high.value - low.value) / std::max(1.0, static_cast<double>(values.size()) - 1.0);
    return fit;
}

double refinement_uncertainty(const RefinementFit& fit, double spacing, double value) {
    const double error = std::abs(fit.discretisation_error(spacing));
    const double off_the_fit = std::abs(value - fit.at(spacing));
    if (fit.deviation <= fit.range_per_step) return fit.safety_factor * error + fit.deviation + off_the_fit;
    if (!(fit.range_per_step > 0)) return fit.deviation + off_the_fit;
    return 3.0 * fit.deviation / fit.range_per_step * (error + fit.deviation + off_the_fit);
}

}  // namespace runout
