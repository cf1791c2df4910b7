#include "validation/slopes_chart.h"

#include <Eigen/QR>
#include <cmath>
#include <limits>

namespace runout::slopes {
namespace {

constexpr double slowest = 0.02, fastest = 3.0;
constexpr int rates_tried = 400;

Eigen::VectorXd ordinates(const std::vector<Vec2>& points) {
    Eigen::VectorXd y(static_cast<Eigen::Index>(points.size()));
    for (std::size_t k = 0; k < points.size(); ++k) y[static_cast<Eigen::Index>(k)] = points[k].y();
    return y;
}

/// Columns 1, f(x).
template <class F>
Eigen::MatrixXd design(const std::vector<Vec2>& points, const F& f) {
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t k = 0; k < points.size(); ++k)
        rows.row(static_cast<Eigen::Index>(k)) << 1.0, f(points[k].x());
    return rows;
}

ChartCurve with_rate(const std::vector<Vec2>& points, double rate) {
    const Eigen::MatrixXd a = design(points, [&](double h) { return 1.0 - std::exp(-rate * h); });
    const Eigen::VectorXd y = ordinates(points);
    const Eigen::VectorXd c = a.colPivHouseholderQr().solve(y);
    const double rms = (a * c - y).norm() / std::sqrt(static_cast<double>(points.size()));
    return {c[0], c[1], rate, rms};
}

double unexplained(const Eigen::VectorXd& residual, const Eigen::VectorXd& y) {
    const Eigen::VectorXd centred = (y.array() - y.mean()).matrix();
    return residual.squaredNorm() / centred.squaredNorm();
}

}  // namespace

double ChartCurve::at(double height) const {
    return floor + rise * (1.0 - std::exp(-rate * height));
}

ChartCurve fit_chart(const std::vector<Vec2>& points) {
    ChartCurve best;
    best.residual = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= rates_tried; ++k) {
        const double rate = slowest * std::pow(fastest / slowest, static_cast<double>(k) / rates_tried);
        const ChartCurve tried = with_rate(points, rate);
        if (tried.residual < best.residual) best = tried;
    }
    return best;
}

Quadratic fit_quadratic(const std::vector<Vec2>& points) {
    Eigen::MatrixXd a(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double x = points[k].x();
        a.row(static_cast<Eigen::Index>(k)) << 1.0, x, x * x;
    }
    const Eigen::VectorXd y = ordinates(points);
    const Eigen::VectorXd c = a.colPivHouseholderQr().solve(y);
    return {c[0], c[1], c[2], 1.0 - unexplained(a * c - y, y)};
}

double line_r_squared(const std::vector<Vec2>& points) {
    const Eigen::MatrixXd a = design(points, [](double x) { return x; });
    const Eigen::VectorXd y = ordinates(points);
    const Eigen::VectorXd c = a.colPivHouseholderQr().solve(y);
    return 1.0 - unexplained(a * c - y, y);
}

}  // namespace runout::slopes
