#include <fmt/format.h>

#include <cmath>

#include "report/chart/svg_chart.h"
#include "report/page/animation_json.h"
#include "report/page/html.h"
#include "report/page/run_page_parts.h"
#include "report/page/section_figure.h"

namespace runout {
namespace {

constexpr const char* stage_html =
    R"(<div class="stage"><canvas id="stage" role="img" aria-label="Animation of the run: particles over the ground. The table of results has its outcome in numbers."></canvas></div>
<div class="controls">
<button type="button" id="animation-play">Play</button>
<input type="range" id="animation-time" aria-label="Time">
<output id="animation-clock" for="animation-time"></output>
<label>Colour <select id="animation-field"><option value="speed">speed</option><option value="pressure">pressure</option><option value="layer">material layer</option></select></label>
<label>Pace <select id="animation-pace"><option value="0.1">tenth</option><option value="0.25">quarter</option><option value="1" selected>real time</option><option value="2">double</option></select></label>
</div>
<div class="scale"><span id="animation-low"></span><canvas id="animation-scale" width="256" height="14" aria-hidden="true"></canvas><span id="animation-high"></span></div>
)";

std::string how_known(const std::string& origin) {
    return origin.empty() ? "found or given" : origin;
}

PageChart chart(const char* id, const char* title, const char* y_label, std::vector<Curve> curves,
                const char* caption) {
    return {id, {id, title, "time, s", y_label, std::move(curves)}, false, caption};
}

std::vector<Vec2> over_time(const std::vector<SeriesRow>& series, double SeriesRow::*value,
                            double scale = 1.0) {
    std::vector<Vec2> points;
    for (const SeriesRow& row : series)
        if (std::isfinite(row.*value)) points.emplace_back(row.time_s, scale * row.*value);
    return points;
}

/// Mean speed of the mass point between samples.
std::vector<Vec2> mass_point_speed(const std::vector<SeriesRow>& series) {
    std::vector<Vec2> points;
    for (std::size_t i = 1; i < series.size(); ++i) {
        const double step = series[i].time_s - series[i - 1].time_s;
        if (!(step > 0)) continue;
        points.emplace_back(0.5 * (series[i].time_s + series[i - 1].time_s),
                            (series[i].front_mass_995_m - series[i - 1].front_mass_995_m) / step);
    }
    return points;
}

}  // namespace

PageSection picture_section(const RunData& run) {
    const auto& profile = run.geometry.profile;
    std::string body =
        "<figure class=\"drawing\">" + svg_chart(section_figure(run)) + "<figcaption>" +
        html_text(fmt::format(
            "One metre is as long across as upwards. The toe of the cut is at chainage {:.6g} m, elevation "
            "{:.6g} m of {} ({}), its crest at chainage {:.6g} m ({}): a face of {:.4g} m at {:.1f} deg. The "
            "discontinuity line rises at {:.4g} deg from where the slip "
            "surface daylights.",
            profile.toe_chainage_m, profile.toe_elevation_m, profile.origin, how_known(run.run.toe_origin),
            run.run.crest_chainage_m, how_known(run.run.crest_origin), run.run.face_height_m,
            run.run.slope_angle_deg, run.run.discontinuity_angle_deg)) +
        "</figcaption></figure>\n";
    return {"section", "Section, source and deposit", body, {}, {}};
}

PageSection animation_section(const RunData& run) {
    PageSection section{"animation", "The run", {}, {}, animation_json(run)};
    if (section.animation.empty()) {
        section.body = paragraph(
            "No pictures of the particles were stored with this run (runout run --frames 60 keeps them).");
        return section;
    }
    const std::size_t shown = run.frames.back().x.size();
    section.body = stage_html;
    section.body += paragraph(fmt::format(
        "{} of {} particles, {} stored instants, straight lines between them. Dashed: the source; line: the "
        "final deposit.",
        shown, run.run.work.particles, run.frames.size()));
    return section;
}

PageSection motion_section(const RunData& run) {
    if (run.series.size() < 2) return {"motion", "Front, speed and energy", {}, {}, {}};
    PageSection section{"motion", "Front, speed and energy", {}, {}, {}};
    section.charts = {
        chart("front", "Front over time", "front past the toe, m",
              {{"front", Curve::Style::line, over_time(run.series, &SeriesRow::front_m)},
               {"99.5 % mass point", Curve::Style::dashed,
                over_time(run.series, &SeriesRow::front_mass_995_m)}},
              "Horizontal distances from the toe: the front is the farthest place where the soil is as thick "
              "as "
              "its threshold; 99.5 % of the mass do not pass the mass point. Below zero it is still on the "
              "cut."),
        chart("speed", "Speed of the mass point over time", "speed, m/s",
              {{"99.5 % mass point", Curve::Style::line, mass_point_speed(run.series)}},
              "Change of the 99.5 % mass point between stored samples over the time between them."),
        chart("energy", "Energy over time", "kJ per metre of width",
              {{"kinetic", Curve::Style::line, over_time(run.series, &SeriesRow::kinetic_energy_j_m, 1e-3)},
               {"potential above the toe", Curve::Style::line,
                over_time(run.series, &SeriesRow::potential_energy_j_m, 1e-3)},
               {"lost to friction", Curve::Style::line,
                over_time(run.series, &SeriesRow::plastic_work_j_m, 1e-3)}},
              "What potential energy loses, friction takes, apart from the error of the method."),
    };
    for (const PageChart& part : section.charts) section.body += place_of(part);
    return section;
}

PageSection deposit_section(const RunData& run) {
    if (run.deposit.empty()) return {"deposit", "Thickness of the deposit", {}, {}, {}};
    std::vector<Vec2> by_top, by_mass;
    for (const DepositRow& row : run.deposit) {
        const double x = run.geometry.profile.to_local({row.chainage_m, row.bed_elevation_m}).x();
        by_top.emplace_back(x, row.thickness_by_top_m);
        by_mass.emplace_back(x, row.thickness_by_mass_m);
    }
    PageSection section{"deposit", "Thickness of the deposit", {}, {}, {}};
    Figure figure{"deposit",
                  "Thickness of the deposit",
                  "distance from the toe, m",
                  "thickness, m",
                  {{"by top", Curve::Style::line, by_top}, {"by mass", Curve::Style::dashed, by_mass}}};
    section.charts = {
        {"deposit", figure, false,
         "Upwards from the bed. By top: the highest particle; by mass: soil area per width. They "
         "part where the deposit is loose or one particle thick."}};
    section.body = place_of(section.charts.front());
    return section;
}

}  // namespace runout
