#include "report/page/study_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "report/page/html.h"
#include "report/page/run_data.h"
#include "report/text/table.h"
#include "validation/slopes_chart.h"

namespace runout {
namespace {

using Groups = std::map<std::string, std::vector<StoredRun>>;

std::vector<StoredRun> results_of(const std::vector<StoredRun>& runs) {
    std::vector<StoredRun> results;
    std::ranges::copy_if(runs, std::back_inserter(results),
                         [](const StoredRun& run) { return is_result(run.status); });
    return results;
}

/// Runs that one curve may join: the same slope and the same soil.
Groups by_slope_and_soil(const std::vector<StoredRun>& runs) {
    Groups groups;
    for (const StoredRun& run : runs)
        groups[fmt::format("slope {:.0f} deg, friction {:.4g} deg", run.slope_angle_deg,
                           run.friction_angle_deg)]
            .push_back(run);
    return groups;
}

std::vector<Vec2> points_of(const std::vector<StoredRun>& runs, double Measures::*x, double Measures::*y) {
    std::vector<Vec2> points;
    for (const StoredRun& run : runs)
        if (std::isfinite(run.measures.*x) && std::isfinite(run.measures.*y))
            points.emplace_back(run.measures.*x, run.measures.*y);
    std::ranges::sort(points, {}, [](const Vec2& point) { return point.x(); });
    return points;
}

std::size_t distinct_x(const std::vector<Vec2>& points) {
    std::set<double> values;
    for (const Vec2& point : points) values.insert(point.x());
    return values.size();
}

Curve fitted_curve(const std::string& label, const std::vector<Vec2>& points) {
    constexpr int steps = 60;
    const slopes::ChartCurve fit = slopes::fit_chart(points);
    Curve curve{"fit, " + label, Curve::Style::line, {}};
    for (int k = 0; k <= steps; ++k) {
        const double x = points.front().x() + (points.back().x() - points.front().x()) * k / steps;
        curve.points.emplace_back(x, fit.at(x));
    }
    return curve;
}

PageSection table_section(const std::vector<StoredRun>& runs) {
    std::vector<HtmlRow> rows;
    for (const StoredRun& run : runs) {
        const Measures& m = run.measures;
        HtmlRow row = {text_cell(fmt::format("{} ({})", run_title(run), run.run_id)),
                       text_cell(run.source_type), number_cell(run.slope_angle_deg, 3),
                       number_cell(run.friction_angle_deg, 3)};
        const bool result = is_result(run.status);
        for (const double value : {m.source_area_m2, m.drop_height_m, m.run_out_m, m.run_out_normalised,
                                   m.reach_angle_deg, m.toe_thickness_m, m.peak_front_speed_m_s})
            row.push_back(result ? number_cell(value, 4) : text_cell(""));
        row.push_back(text_cell(std::string(to_string(run.status))));
        rows.push_back(row);
    }
    std::string body =
        html_table("Runs",
                   {"run", "source", "slope, deg", "friction, deg", "area, m²", "drop, m", "run-out, m",
                    "L/√S", "reach angle, deg", "at the toe, m", "front, m/s", "status"},
                   rows);
    std::vector<std::string> failed;
    for (const StoredRun& run : runs)
        if (!is_result(run.status))
            failed.push_back(fmt::format("run {}: {}{}{}", run.run_id, status_reason(run.status),
                                         run.status_detail.empty() ? "" : "; ", run.status_detail));
    if (!failed.empty())
        body +=
            "<div class=\"warnings\"><p>No result, and in no chart:</p>" + bullet_list(failed) + "</div>\n";
    return {"runs", "Runs", body, {}, {}};
}

PageSection scaling_section(const std::vector<StoredRun>& results) {
    Figure height{"drop", "Run-out against drop height", "H_d/√S", "L/√S", {}};
    Figure front{"front-area", "Run-out against the share of the front", "S_front/S", "L/√S", {}};
    std::size_t fitted_groups = 0;
    for (const auto& [label, runs] : by_slope_and_soil(results)) {
        const auto points = points_of(runs, &Measures::drop_height_normalised, &Measures::run_out_normalised);
        height.curves.push_back({label, Curve::Style::markers, points});
        if (distinct_x(points) >= 5) {
            height.curves.push_back(fitted_curve(label, points));
            ++fitted_groups;
        }
        front.curves.push_back({label, Curve::Style::markers,
                                points_of(runs, &Measures::front_area_ratio, &Measures::run_out_normalised)});
    }
    PageSection section{"scaling", "Normalised run-out", {}, {}, {}};
    section.charts = {
        {"drop", height, false,
         fitted_groups > 0
             ? "Lines: L/√S = a + b (1 - exp(-c H_d/√S)), fitted: it rises at a falling rate, as the paper "
               "found."
             : "The paper: it rises with the drop height at a falling rate. A line is fitted through five "
               "heights or more of one slope and soil."},
        {"front-area", front, false,
         "The paper: at one slope and drop height all shapes of the source fall on one curve of S_front/S."}};
    for (const PageChart& chart : section.charts) section.body += place_of(chart);
    return section;
}

PageChart exceedance_chart(const char* id, const char* title, const char* unit,
                           const std::vector<StoredRun>& results, double Measures::*value) {
    std::vector<double> values;
    for (const StoredRun& run : results) values.push_back(run.measures.*value);
    const Figure figure{id, title, unit, "share of runs", {{"runs", Curve::Style::line, exceedance(values)}}};
    return {id, figure, false, ""};
}

PageSection exceedance_section(const std::vector<StoredRun>& results) {
    PageSection section{"exceedance", "How often a value is reached", {}, {}, {}};
    if (results.size() < 2) return section;
    section.charts = {exceedance_chart("exceed-run-out", "Run-out reached or passed",
                                       "run-out past the toe, m", results, &Measures::run_out_m),
                      exceedance_chart("exceed-toe", "Thickness at the toe reached or passed",
                                       "thickness at the toe, m", results, &Measures::toe_thickness_m)};
    for (const PageChart& chart : section.charts) section.body += place_of(chart);
    section.body +=
        paragraph(fmt::format("Each of the {} results counts once; that is a probability only if the runs "
                              "were drawn like that. A share of "
                              "a half is then uncertain by {:.2g} (one standard error of sampling).",
                              results.size(), std::sqrt(0.25 / static_cast<double>(results.size()))));
    return section;
}

}  // namespace

std::vector<StoredRun> latest_of_each_scenario(const std::vector<StoredRun>& runs) {
    std::map<std::string, std::size_t> last;
    for (std::size_t i = 0; i < runs.size(); ++i) last[runs[i].scenario_hash] = i;
    std::vector<StoredRun> latest;
    for (std::size_t i = 0; i < runs.size(); ++i)
        if (last[runs[i].scenario_hash] == i) latest.push_back(runs[i]);
    return latest;
}

std::vector<Vec2> exceedance(std::vector<double> values) {
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    std::ranges::sort(values);
    std::vector<Vec2> points;
    const auto count = static_cast<double>(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        // Level up to the value, then down by one run.
        points.emplace_back(values[i], (count - static_cast<double>(i)) / count);
        points.emplace_back(values[i], (count - static_cast<double>(i) - 1) / count);
    }
    return points;
}

std::string study_page(const std::string& title, const std::vector<StoredRun>& runs) {
    const std::vector<StoredRun> latest = latest_of_each_scenario(runs);
    const std::vector<StoredRun> results = results_of(latest);
    std::vector<PageSection> sections = {table_section(latest)};
    if (!results.empty()) sections.push_back(scaling_section(results));
    sections.push_back(exceedance_section(results));
    return html_page(title,
                     fmt::format("{} scenarios, {} of them with a result", latest.size(), results.size()),
                     sections);
}

}  // namespace runout
