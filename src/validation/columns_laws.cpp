#include "validation/columns_laws.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace runout {
namespace {

constexpr double linear_end = 1.8, power_begin = 2.8;  // of Lube et al.
constexpr double near_factor = 1.6;

double lube_power(double aspect) {
    return 1.9 * std::pow(aspect, 2.0 / 3.0);
}

/// 97.5 % quantile of Student's t.
double student_t(std::size_t freedom) {
    static constexpr std::array quantiles{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365,
                                          2.306,  2.262, 2.228, 2.201, 2.179, 2.160, 2.145};
    return quantiles[std::min(freedom, quantiles.size()) - 1];
}

}  // namespace

double lube_front(double aspect) {
    if (aspect <= linear_end) return 1.0 + 1.2 * aspect;
    if (aspect >= power_begin) return 1.0 + lube_power(aspect);
    const double low = 1.2 * linear_end;
    return 1.0 + low + (lube_power(power_begin) - low) * (aspect - linear_end) / (power_begin - linear_end);
}

double lajeunesse_run_out(double aspect) {
    return aspect < 3.0 ? 1.79 * aspect : 2.68 * std::pow(aspect, 2.0 / 3.0);
}

double local_value(const std::vector<Vec2>& points, double aspect) {
    std::vector<Vec2> near;
    for (const Vec2& p : points) {
        const double distance = std::log(p.x() / aspect);
        if (std::abs(distance) <= std::log(near_factor)) near.emplace_back(distance, std::log(p.y()));
    }
    if (near.size() < 3) return std::numeric_limits<double>::quiet_NaN();
    return std::exp(fit_line(near).intercept);
}

LineFit fit_line(const std::vector<Vec2>& points) {
    assert(points.size() >= 3);
    const auto n = static_cast<double>(points.size());
    Vec2 mean = Vec2{};
    for (const Vec2& p : points) mean += p / n;
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (const Vec2& p : points) {
        const Vec2 d = p - mean;
        xx += d.x() * d.x();
        xy += d.x() * d.y();
        yy += d.y() * d.y();
    }
    LineFit fit;
    fit.slope = xy / xx;
    fit.intercept = mean.y() - fit.slope * mean.x();
    const double residual = std::max(0.0, yy - fit.slope * xy);
    const double variance = residual / (n - 2.0);
    const double t = student_t(points.size() - 2);
    fit.slope_half = t * std::sqrt(variance / xx);
    fit.intercept_half = t * std::sqrt(variance * (1.0 / n + mean.x() * mean.x() / xx));
    fit.r_squared = 1.0 - residual / yy;
    return fit;
}

}  // namespace runout
