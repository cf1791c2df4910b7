#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/page/html.h"
#include "report/page/run_page_parts.h"
#include "report/text/intensity.h"

namespace runout {
namespace {

std::vector<Vec2> along(const Envelope& envelope, const std::vector<double>& values) {
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (std::isfinite(values[i]))
            points.emplace_back(envelope.first_m + static_cast<double>(i) * envelope.step_m, values[i]);
    return points;
}

/// Each place as a box from zero to the greatest value, or a line where it has no width.
void add_places(const RunData& run, Figure& figure) {
    double top = 0;
    for (const Curve& curve : figure.curves)
        for (const Vec2& point : curve.points) top = std::max(top, point.y());
    for (const PlaceRecord& place : run.run.places) {
        const double near = run.geometry.profile.to_local({place.chainage_m, 0}).x();
        Polyline box = {{near, 0}, {near, top}};
        if (place.width_m > 0) {
            box.emplace_back(near + place.width_m, top);
            box.emplace_back(near + place.width_m, 0);
        }
        figure.curves.push_back({place.name, Curve::Style::dashed, box});
    }
}

PageChart chart_of(const RunData& run, Figure figure, const std::string& note) {
    add_places(run, figure);
    std::string name = figure.name;
    return {name, std::move(figure), false, note};
}

std::string intensity_table(const RunData& run) {
    std::vector<HtmlRow> rows;
    for (const IntensityStretch& stretch :
         intensity_stretches(*run.envelope, run.run.measures.front_thickness_m, run.intensities.classes))
        rows.push_back({text_cell(stretch.name), number_cell(stretch.from_m), number_cell(stretch.to_m)});
    if (rows.empty()) return {};
    return "<h3>Intensity along the section</h3>\n" + paragraph(run.intensities.origin) +
           html_table("Intensity", {"class", "from, m past the toe", "to, m past the toe"}, rows);
}

}  // namespace

PageSection envelope_section(const RunData& run) {
    PageSection section{"envelope", "What passed along the section", {}, {}, {}};
    if (!run.envelope || !is_result(run.run.status)) return section;
    const Envelope& envelope = *run.envelope;
    section.charts = {
        chart_of(run,
                 {"envelope-thickness",
                  "Thickness along the section",
                  "distance from the toe, m",
                  "thickness, m",
                  {{"greatest", Curve::Style::line, along(envelope, envelope.greatest_thickness_m)},
                   {"at the end", Curve::Style::dashed, along(envelope, envelope.final_thickness_m)}}},
                 fmt::format("All soil, in windows of +-{:.3g} m, every {:.3g} m.",
                             run.run.measures.front_window_m, envelope.step_m)),
        chart_of(run,
                 {"envelope-speed",
                  "Greatest speed along the section",
                  "distance from the toe, m",
                  "speed, m/s",
                  {{"greatest", Curve::Style::line, along(envelope, envelope.greatest_speed_m_s)}}},
                 "Mean over depth and window, of soil as thick as the front."),
        chart_of(run,
                 {"envelope-flux",
                  "Greatest momentum flux along the section",
                  "distance from the toe, m",
                  "kN per metre of width",
                  {{"rho v^2 h", Curve::Style::line,
                    along(envelope,
                          [&] {
                              std::vector<double> flux = envelope.greatest_momentum_flux_n_m;
                              for (double& value : flux) value *= 1e-3;
                              return flux;
                          }())}}},
                 "What a wall feels, before a coefficient.")};
    for (const PageChart& chart : section.charts) section.body += place_of(chart);
    section.body += intensity_table(run);
    return section;
}

}  // namespace runout
