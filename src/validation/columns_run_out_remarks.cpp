#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "validation/columns_laws.h"
#include "validation/columns_run_out.h"

namespace runout::run_out_columns {
namespace {

void add_fit(CaseReport& report, const Spread& spread) {
    const std::vector<Vec2> points = eq10_points(spread);
    if (points.size() < 3) return;
    const LineFit fit = fit_line(points);
    const double least_aspect = 1.0 / (points.front().x() * points.front().x());
    report.remarks.push_back(
        fmt::format("Eq. 10, phi {:.0f} deg: L_inf/sqrt(S) = l3 + l4/sqrt(a) with l3 = {:.3f} +- {:.3f}, l4 "
                    "= {:.3f} +- {:.3f} "
                    "(95 % confidence, {} columns, a from {:.2g}), R2 = {:.4f}.",
                    spread.friction_angle, fit.intercept, fit.intercept_half, fit.slope, fit.slope_half,
                    points.size(), least_aspect, fit.r_squared));
}

struct Limits {
    double least = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();
    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
};

void add_over_spread(CaseReport& report, const Spread& spread, const std::vector<Vec2>& points) {
    Limits law, near;
    for (std::size_t k = 0; k < spread.aspects.size(); ++k) {
        const double a = spread.aspects[k];
        if (a <= 2.0 || std::isnan(spread.front[k].mean)) continue;
        const double run_out = spread.front[k].mean - 1.0;
        law.add(100.0 * (run_out / lajeunesse_run_out(a) - 1.0));
        near.add(100.0 * (run_out / local_value(points, a) - 1.0));
    }
    report.remarks.push_back(fmt::format(
        "For a > 2 the columns of phi 27 go {:+.0f} to {:+.0f} % beyond the law of Lajeunesse et al., and "
        "{:+.0f} to "
        "{:+.0f} % beyond the points near the same a, which hardly rise above a = 10. Tall columns fall "
        "before they "
        "spread, and a friction that is constant lacks what grains add then: it rises with the rate of "
        "shear, they "
        "loosen (the measured area grows by some 10 %), and side walls and a third dimension take energy.",
        law.least, law.most, near.least, near.most));
}

void add_explanations(CaseReport& report) {
    report.remarks.emplace_back(
        "Eq. 10 fitted to the laws of the experiments: Lube et al. l3 = 3.575, l4 = -1.463; Lajeunesse et "
        "al. "
        "l3 = 4.465, l4 = -1.638. The paper's own coefficients are only drawn in its figure. The "
        "residuals of the fits are systematic (flat near the least run-out, still rising at a = 20), so the "
        "confidence is that of the coefficients, not of the form.");
    report.remarks.emplace_back(
        "phi 27 is the glass of the paper (repose 24.5 deg). The beads of Lajeunesse et al. have a repose of "
        "22 deg, which "
        "by tan(repose) = sin(phi) is phi 23.8: a model of constant friction that takes it goes too far from "
        "the "
        "lowest column on.");
    report.remarks.emplace_back(
        "The material points of Kumar have the same constant friction as the columns of phi 22.2. Where his "
        "tall columns and "
        "ours agree, both go too far. His low columns go less far than ours, and also less far than the "
        "aluminium "
        "bars of nearly that strength (2.0 to 2.2 a at a = 0.5, cases/aluminium-column); we do not know "
        "why.");
    report.remarks.emplace_back(
        "The failure plane is the straight line through the foot of the column that best parts fast soil "
        "from slow. "
        "At a = 3 it meets the wall and the soil above sinks along the wall, so the straight line comes out "
        "flatter "
        "than at a = 1.5, where the plane comes out on top.");
}

}  // namespace

void add_remarks(CaseReport& report, const std::vector<Spread>& spreads, const std::vector<Vec2>& measured) {
    for (const Spread& spread : spreads) add_fit(report, spread);
    for (const Spread& spread : spreads)
        if (spread.friction_angle == 27.0) add_over_spread(report, spread, measured);
    add_explanations(report);
}

}  // namespace runout::run_out_columns
