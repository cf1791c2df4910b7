#pragma once

#include <vector>

#include "core/geometry.h"

namespace runout::slopes {

/// L/sqrt(S) = floor + rise (1 - exp(-rate h)), h = H_d/sqrt(S): rises at a falling rate to an asymptote.
struct ChartCurve {
    double floor = 0, rise = 0, rate = 0;
    double residual = 0;  ///< rms of the points, in sqrt(S)

    [[nodiscard]] double at(double height) const;
    [[nodiscard]] double asymptote() const { return floor + rise; }
};

/// By least squares over (h, L/sqrt(S)): `rate` by search from 0.02 to 3, the others linear. Needs four
/// points or more.
ChartCurve fit_chart(const std::vector<Vec2>& points);

/// y = c0 + c1 x + c2 x^2 by least squares.
struct Quadratic {
    double c0 = 0, c1 = 0, c2 = 0;
    double r_squared = 0;  ///< 1 - residual over variance

    [[nodiscard]] double at(double x) const { return c0 + x * (c1 + x * c2); }
};

/// Needs four points or more, three of different x.
Quadratic fit_quadratic(const std::vector<Vec2>& points);

/// Pearson's coefficient of a straight line, squared.
double line_r_squared(const std::vector<Vec2>& points);

}  // namespace runout::slopes
