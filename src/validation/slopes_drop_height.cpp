#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/units.h"
#include "validation/slopes.h"
#include "validation/slopes_chart.h"
#include "validation/slopes_shared.h"

namespace runout {
namespace {

using namespace slopes;

constexpr const char* case_file = "drop-height/case.toml";
constexpr double area = 0.01;   // of the case, m2
constexpr double aspect = 2.0;  // L0/H0 of the series over drop height
constexpr double box_aspect = 96.0 / 45.0;
constexpr double box_area = 0.00432;      // m2
constexpr double box_spacing = 0.003286;  // sqrt(S)/20 of the smallest, the same for all sizes
constexpr double area_band = 0.02, aspect_band = 0.05;

double resolution(bool quick) {
    return quick ? 15.0 : 30.0;
}

std::string at_resolution(bool quick) {
    return fmt::format("sqrt(S)/dl = {:g}", resolution(quick));
}

std::vector<double> slopes_of(bool quick) {
    return quick ? std::vector{60.0} : std::vector{45.0, 60.0, 70.0};
}

/// H_d/sqrt(S) of a box whose lower end is at the toe, rounded up.
double least_height(double slope_deg) {
    return std::ceil(1e4 * std::sqrt(aspect) * std::sin(radians(slope_deg))) / 1e4;
}

std::vector<double> heights(double slope_deg, bool quick) {
    if (quick) return {2.0, 5.86, 10.0};
    return {least_height(slope_deg), 1.5, 2.0, 3.5, 5.86, 8.0, 10.0};
}

std::string height_id(double slope_deg, double height) {
    return fmt::format("{:g}deg-height{:g}", slope_deg, height);
}

Settings rectangle(double slope_deg, double height, double aspect_ratio, double source_area) {
    return {{"section.file", chute_file(slope_deg)},
            {"source.aspect_ratio", text_of(aspect_ratio)},
            {"source.area_m2", text_of(source_area)},
            {"source.drop_height_m", text_of(height * std::sqrt(source_area))}};
}

/// Slope and H_d/sqrt(S) of an experiment of Bryant et al.
struct Place {
    double slope_deg, height;
};
const Place places[] = {{45, 0.233 / std::sqrt(box_area)}, {70, 0.385 / std::sqrt(box_area)}};
constexpr int multiples[] = {1, 2, 4};

/// Where the shape is varied: heights of the series.
constexpr Place shape_places[] = {{45, 3.5}, {70, 5.86}};
constexpr double shapes[] = {1.0, 3.0};

std::string area_id(const Place& place, int multiple) {
    return fmt::format("{:g}deg-area{}", place.slope_deg, multiple);
}

std::string shape_id(const Place& place, double shape) {
    return fmt::format("{:g}deg-shape{:g}", place.slope_deg, shape);
}

std::vector<PlannedRun> plan(bool quick) {
    std::vector<PlannedRun> runs;
    for (const double slope : slopes_of(quick))
        for (const double height : heights(slope, quick))
            plan_ensemble(runs, height_id(slope, height), case_file, rectangle(slope, height, aspect, area),
                          "run.resolution", resolution(quick));
    if (quick) return runs;
    for (const Place& place : places)
        for (const int multiple : multiples)
            plan_ensemble(runs, area_id(place, multiple), case_file,
                          rectangle(place.slope_deg, place.height, box_aspect, multiple * box_area),
                          "run.particle_spacing_m", box_spacing);
    for (const Place& place : shape_places)
        for (const double shape : shapes)
            plan_ensemble(runs, shape_id(place, shape), case_file,
                          rectangle(place.slope_deg, place.height, shape, area), "run.resolution",
                          resolution(false));
    return runs;
}

// --- (a) size --------------------------------------------------------------------------------------------

void add_areas(CaseReport& report, const CaseRuns& runs) {
    for (const Place& place : places) {
        const Estimate largest = run_out(runs, area_id(place, 4));
        for (const int multiple : {1, 2}) {
            report.entries.push_back(
                held(ratio(run_out(runs, area_id(place, multiple)), largest),
                     fmt::format("(a) L/sqrt(S), area x{} over area x4, {:g} deg", multiple, place.slope_deg),
                     {"scaling (paper Fig. 12a)", 1.0, area_band},
                     fmt::format("dl = 3.29 mm, sqrt(S)/dl = {:.0f} and 40", 20.0 * std::sqrt(multiple))));
        }
    }
}

// --- (b) drop height -------------------------------------------------------------------------------------

struct Series {
    double slope_deg;
    std::vector<double> height;
    std::vector<Estimate> run_out;     ///< 99.5 % mass point
    std::vector<Estimate> contiguous;  ///< by top

    [[nodiscard]] std::vector<Vec2> points(const std::vector<Estimate>& values) const {
        std::vector<Vec2> all;
        for (std::size_t k = 0; k < height.size(); ++k) all.emplace_back(height[k], values[k].mean);
        return all;
    }
};

Series series_of(const CaseRuns& runs, double slope_deg, bool quick) {
    Series series{slope_deg, heights(slope_deg, quick), {}, {}};
    for (const double height : series.height) {
        series.run_out.push_back(run_out(runs, height_id(slope_deg, height)));
        series.contiguous.push_back(
            measured(runs, height_id(slope_deg, height), &Measures::run_out_normalised));
    }
    return series;
}

/// Growth of run-out between two neighbouring heights, with what lattices leave uncertain of it.
Estimate growth(const Series& s, std::size_t k) {
    const double step = s.height[k + 1] - s.height[k];
    return {(s.run_out[k + 1].mean - s.run_out[k].mean) / step,
            std::hypot(s.run_out[k + 1].scatter, s.run_out[k].scatter) / step, ValidationEntry::none};
}

/// The greatest of several numbers that ought not to be positive, in standard errors of the mean of four
/// lattices.
double worst(const std::vector<Estimate>& numbers) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Estimate& n : numbers) {
        const double score = n.mean / (0.5 * n.scatter);
        if (!(score <= most)) most = score;  // NaN gets through
    }
    return most;
}

void add_trends(CaseReport& report, const Series& series, bool quick) {
    std::vector<Estimate> falls, rises_of_growth;
    for (std::size_t k = 0; k + 1 < series.height.size(); ++k) {
        Estimate g = growth(series, k);
        falls.push_back({-g.mean, g.scatter, g.error});
        if (k == 0) continue;
        const Estimate before = growth(series, k - 1);
        rises_of_growth.push_back(
            {g.mean - before.mean, std::hypot(g.scatter, before.scatter), ValidationEntry::none});
    }
    const Reference trend{"the paper, Fig. 12b", ValidationEntry::none, 2.0};
    const std::string slope = fmt::format("{:g} deg", series.slope_deg);
    report.entries.push_back(limited(
        exact(worst(falls)), "(b) greatest fall of L/sqrt(S) with H_d, in its standard error, " + slope,
        trend, at_resolution(quick), "negative: rises at every step"));
    report.entries.push_back(limited(exact(worst(rises_of_growth)),
                                     "(b) greatest rise of its growth rate, in its standard error, " + slope,
                                     trend, at_resolution(quick), "negative: concave everywhere"));
}

/// The numbers behind the chart, without a reference: the paper has them as a picture only.
void add_values(CaseReport& report, const Series& series, bool quick) {
    for (std::size_t k = 0; k < series.height.size(); ++k)
        report.entries.push_back(held(series.run_out[k],
                                      fmt::format("(d) L/sqrt(S) at H_d/sqrt(S) = {:.2f}, {:g} deg",
                                                  series.height[k], series.slope_deg),
                                      {}, at_resolution(quick),
                                      fmt::format("contiguous front {:.2f}", series.contiguous[k].mean)));
}

// --- (c) shape -------------------------------------------------------------------------------------------

void add_shapes(CaseReport& report, const CaseRuns& runs) {
    for (const Place& place : shape_places) {
        const Estimate reference = run_out(runs, height_id(place.slope_deg, place.height));
        for (const double shape : shapes)
            report.entries.push_back(
                held(ratio(run_out(runs, shape_id(place, shape)), reference),
                     fmt::format("(c) L/sqrt(S), L0/H0 = {:g} over L0/H0 = 2, {:g} deg, H_d/sqrt(S) = {:g}",
                                 shape, place.slope_deg, place.height),
                     {"the paper, Fig. 12c", 1.0, aspect_band}, at_resolution(false)));
    }
}

// --- (d) chart -------------------------------------------------------------------------------------------

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

// --- profiles --------------------------------------------------------------------------------------------

Figure figure_of(const std::string& name, const std::string& title) {
    return {name, title, "x/sqrt(S)", "y/sqrt(S)", {}, true, false};
}

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

CaseReport evaluate(const CaseRuns& runs, const std::string&, bool quick) {
    CaseReport report{
        "drop-height", "Size, drop height and shape of a granular rectangle (paper Fig. 12)", {}, {}, {}};
    if (!quick) add_areas(report, runs);
    std::vector<Series> all;
    for (const double slope : slopes_of(quick)) all.push_back(series_of(runs, slope, quick));
    for (const Series& series : all) add_trends(report, series, quick);
    if (!quick) add_shapes(report, runs);
    for (const Series& series : all) add_values(report, series, quick);
    add_chart(report, all);
    if (!quick) add_profiles(report, runs);
    report.remarks.emplace_back(
        "H_d is the height of the head, and a box of L0/H0 = 2 does not fit onto the face below H_d/sqrt(S) "
        "= "
        "sqrt(2) sin(slope): 1.00 at 45, 1.22 at 60 and 1.33 at 70 deg. The series begins there, not at "
        "0.5.");
    return report;
}

}  // namespace

ValidationCase drop_height_case() {
    return {"drop-height", plan, evaluate};
}

}  // namespace runout
