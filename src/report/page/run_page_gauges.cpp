#include <map>

#include "report/page/html.h"
#include "report/page/run_page_parts.h"

namespace runout {
namespace {

/// Names of the gauges by their number.
std::map<double, std::string> gauge_names(const StoredTable& gauges) {
    std::map<double, std::string> names;
    for (const auto& row : gauges.rows)
        names[number_of(cell_of(gauges, row, "gauge_index"))] = stored_text(cell_of(gauges, row, "name"));
    return names;
}

/// One curve a gauge of a column over time.
std::vector<Curve> curves_of(const StoredTable& gauges, const StoredTable& series,
                             const std::string& column) {
    std::map<double, Curve> curves;
    for (const auto& [number, name] : gauge_names(gauges)) curves[number] = {name, Curve::Style::line, {}};
    for (const auto& row : series.rows)
        curves[number_of(cell_of(series, row, "gauge_index"))].points.emplace_back(
            number_of(cell_of(series, row, "time_s")), number_of(cell_of(series, row, column)));
    std::vector<Curve> all;
    for (const auto& [number, curve] : curves) all.push_back(curve);
    return all;
}

std::string table_of(const StoredTable& gauges) {
    std::vector<std::string> head;
    for (const std::string& column : gauges.columns) {
        const ColumnWords words = column_words(column);
        head.push_back(words.unit.empty() ? words.words : words.words + ", " + words.unit);
    }
    std::vector<HtmlRow> rows;
    for (const auto& values : gauges.rows) {
        HtmlRow& row = rows.emplace_back();
        for (const StoredValue& value : values) row.push_back(value_cell(value));
    }
    return html_table("Gauges", head, rows);
}

}  // namespace

PageSection gauges_section(const RunData& run) {
    PageSection section{"gauges", "At the gauges", {}, {}, {}};
    const StoredTable* gauges = further_table(run, "gauge");
    if (gauges == nullptr) {
        section.body = paragraph(
            "The case names no gauge; thickness and speed are measured only where it asks for them.");
        return section;
    }
    section.body = table_of(*gauges);
    const StoredTable* series = further_table(run, "gauge_series");
    if (series == nullptr) return section;
    section.charts = {{"gauge-thickness",
                       {"gauge-thickness", "Thickness at the gauges", "time, s", "thickness, m",
                        curves_of(*gauges, *series, "thickness_m")},
                       false,
                       "Of the flow as it passes and of what stays."},
                      {"gauge-speed",
                       {"gauge-speed", "Speed at the gauges", "time, s", "speed, m/s",
                        curves_of(*gauges, *series, "speed_m_s")},
                       false,
                       "Mean over the depth."}};
    for (const PageChart& chart : section.charts) section.body += place_of(chart);
    return section;
}

}  // namespace runout
