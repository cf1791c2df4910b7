#include <algorithm>
#include <cmath>

#include "profile/profile.h"

namespace runout {
namespace {

double tricube(double u) {
    const double rest = 1 - std::abs(u * u * u);
    return rest * rest * rest;
}

/// Value at points[i] of the weighted straight line through the points within `half` of it.
double fitted(const std::vector<Vec2>& points, std::size_t i, double half) {
    const double here = points[i].x();
    double w = 0;
    double wx = 0;
    double wz = 0;
    double wxx = 0;
    double wxz = 0;
    const auto add = [&](const Vec2& point) {
        const double x = point.x() - here;
        const double weight = tricube(x / half);
        // Differences to the point itself, so that a plane loses no digits.
        const double z = point.y() - points[i].y();
        w += weight;
        wx += weight * x;
        wz += weight * z;
        wxx += weight * x * x;
        wxz += weight * x * z;
    };
    for (std::size_t j = i + 1; j-- > 0 && here - points[j].x() < half;) add(points[j]);
    for (std::size_t j = i + 1; j < points.size() && points[j].x() - here < half; ++j) add(points[j]);
    const double determinant = w * wxx - wx * wx;
    if (!(determinant > 1e-12 * w * wxx)) return points[i].y();  // no other point in the window
    return points[i].y() + (wz * wxx - wx * wxz) / determinant;
}

double steepest(const std::vector<Vec2>& points) {
    double angle = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec2 d = points[i] - points[i - 1];
        angle = std::max(angle, std::atan2(std::abs(d.y()), d.x()));
    }
    return angle;
}

}  // namespace

Smoothing smooth_elevations(std::vector<Vec2>& points, double window_m) {
    Smoothing told;
    told.steepest_before = steepest(points);
    std::vector<Vec2> smooth = points;
    double squares = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        smooth[i].y() = fitted(points, i, window_m / 2);
        const double change = std::abs(smooth[i].y() - points[i].y());
        squares += change * change;
        if (change <= told.greatest_change_m) continue;
        told.greatest_change_m = change;
        told.greatest_change_chainage_m = points[i].x();
    }
    if (!points.empty()) told.rms_change_m = std::sqrt(squares / static_cast<double>(points.size()));
    points = std::move(smooth);
    told.steepest_after = steepest(points);
    return told;
}

}  // namespace runout
