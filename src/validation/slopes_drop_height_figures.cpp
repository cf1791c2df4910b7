#include <fmt/format.h>

#include <cmath>

#include "validation/slopes_chart.h"
#include "validation/slopes_drop_height.h"
#include "validation/slopes_shared.h"

namespace runout::slopes {
namespace {

std::vector<Vec2> drawn(const ChartCurve& curve, double from, double to) {
    constexpr int steps = 60;
    std::vector<Vec2> points;
    for (int k = 0; k <= steps; ++k) {
        const double h = from + (to - from) * k / steps;
        points.emplace_back(h, curve.at(h));
    }
    return points;
}

std::string sentence_of(const ChartCurve& curve, const Series& series, const char* front) {
    return fmt::format(
        "Run-out chart, {:g} deg, phi 38 deg, {}: L/sqrt(S) = {:.3f} + {:.3f} (1 - exp(-{:.4f} "
        "H_d/sqrt(S))), "
        "rms residual {:.3f}, for H_d/sqrt(S) from {:.2f} to {:g}; asymptote {:.2f}{}. Ready for use as a "
        "run-out chart within that range.",
        series.slope_deg, front, curve.floor, curve.rise, curve.rate, curve.residual, series.height.front(),
        series.height.back(), curve.asymptote(),
        curve.rate * series.height.back() < 1.0 ? ", far beyond the range and not determined by it" : "");
}

}  // namespace

void add_chart(CaseReport& report, const std::vector<Series>& all) {
    Figure chart{"chart", "Run-out against drop height", "H_d/sqrt(S)", "L/sqrt(S)", {}, false, false};
    for (const Series& series : all) {
        const auto points = series.points(series.run_out);
        chart.curves.push_back({fmt::format("{:g} deg", series.slope_deg), Curve::Style::markers, points});
        if (points.size() < 4) continue;
        const ChartCurve curve = fit_chart(points);
        report.remarks.push_back(sentence_of(curve, series, "front by 99.5 % of the mass"));
        report.remarks.push_back(
            sentence_of(fit_chart(series.points(series.contiguous)), series, "contiguous front by top"));
        chart.curves.push_back({fmt::format("fit, {:g} deg", series.slope_deg), Curve::Style::line,
                                drawn(curve, series.height.front(), series.height.back())});
    }
    report.figures.push_back(chart);
}

namespace {

Figure figure_of(const std::string& name, const std::string& title) {
    return {name, title, "x/sqrt(S)", "y/sqrt(S)", {}, true, false};
}

}  // namespace

void add_profiles(CaseReport& report, const CaseRuns& runs) {
    for (const Place& place : places) {
        Figure figure = figure_of(fmt::format("areas-{:g}", place.slope_deg),
                                  fmt::format("(a) Deposits of three areas, {:g} deg", place.slope_deg));
        for (const int multiple : multiples)
            figure.curves.push_back(surface_curve(runs, lattices_of(area_id(place, multiple)).front(),
                                                  chute_toe(place.slope_deg),
                                                  fmt::format("area x{}", multiple)));
        report.figures.push_back(figure);
    }
    for (const double slope : slopes_of(false)) {
        Figure figure = figure_of(fmt::format("heights-{:g}", slope),
                                  fmt::format("(b) Deposits of several drop heights, {:g} deg", slope));
        for (const double height : heights(slope, false))
            figure.curves.push_back(surface_curve(runs, lattices_of(height_id(slope, height)).front(),
                                                  chute_toe(slope),
                                                  fmt::format("H_d/sqrt(S) = {:.2f}", height)));
        report.figures.push_back(figure);
    }
    for (const Place& place : shape_places) {
        Figure figure = figure_of(fmt::format("shapes-{:g}", place.slope_deg),
                                  fmt::format("(c) Deposits of three shapes, {:g} deg", place.slope_deg));
        const auto add = [&](const std::string& id, double shape) {
            figure.curves.push_back(surface_curve(runs, lattices_of(id).front(), chute_toe(place.slope_deg),
                                                  fmt::format("L0/H0 = {:g}", shape)));
        };
        add(shape_id(place, 1.0), 1.0);
        add(height_id(place.slope_deg, place.height), 2.0);
        add(shape_id(place, 3.0), 3.0);
        report.figures.push_back(figure);
    }
}

}  // namespace runout::slopes
