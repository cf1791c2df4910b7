#include <algorithm>
#include <map>

#include "report/page/html.h"
#include "report/page/run_page_parts.h"
#include "report/text/place_doubt.h"

namespace runout {
namespace {

/// Names of the places by their number.
std::map<double, std::string> place_names(const StoredTable& places) {
    std::map<double, std::string> names;
    for (const auto& row : places.rows)
        names[number_of(cell_of(places, row, "place_index"))] = stored_text(cell_of(places, row, "name"));
    return names;
}

/// One curve a place of a column over time.
std::vector<Curve> curves_of(const StoredTable& places, const StoredTable& series,
                             const std::string& column) {
    std::map<double, Curve> curves;
    for (const auto& [number, name] : place_names(places)) curves[number] = {name, Curve::Style::line, {}};
    for (const auto& row : series.rows)
        curves[number_of(cell_of(series, row, "place_index"))].points.emplace_back(
            number_of(cell_of(series, row, "time_s")), number_of(cell_of(series, row, column)));
    std::vector<Curve> all;
    for (const auto& [number, curve] : curves) all.push_back(curve);
    return all;
}

/// What the front says of it, its error beside it; of a run that is no result, nothing.
std::string verdict_on(const RunData& run, const std::string& name) {
    const auto found = std::ranges::find(run.run.places, name, &PlaceRecord::name);
    if (found == run.run.places.end() || !is_result(run.run.status)) return {};
    return place_doubt(run.run, *found).sentence();
}

std::string table_of(const RunData& run, const StoredTable& places) {
    std::vector<std::string> head = {"front"};
    for (const std::string& column : places.columns) {
        const ColumnWords words = column_words(column);
        head.push_back(words.unit.empty() ? words.words : words.words + ", " + words.unit);
    }
    std::vector<HtmlRow> rows;
    for (const auto& values : places.rows) {
        HtmlRow& row = rows.emplace_back();
        row.push_back(text_cell(verdict_on(run, stored_text(cell_of(places, values, "name")))));
        for (const StoredValue& value : values) row.push_back(value_cell(value));
    }
    return html_table("Places", head, rows);
}

}  // namespace

PageSection places_section(const RunData& run) {
    PageSection section{"places", "At the places", {}, {}, {}};
    const StoredTable* places = further_table(run, "place");
    if (places == nullptr) {
        section.body = paragraph(
            "The case names no place; thickness and speed are measured only where it asks for them.");
        return section;
    }
    section.body = table_of(run, *places);
    const StoredTable* series = further_table(run, "place_series");
    if (series == nullptr) return section;
    section.charts = {{"place-thickness",
                       {"place-thickness", "Thickness at the places", "time, s", "thickness, m",
                        curves_of(*places, *series, "thickness_m")},
                       false,
                       "Of the flow as it passes and of what stays."},
                      {"place-speed",
                       {"place-speed", "Speed at the places", "time, s", "speed, m/s",
                        curves_of(*places, *series, "speed_m_s")},
                       false,
                       "Mean over the depth."}};
    for (const PageChart& chart : section.charts) section.body += place_of(chart);
    return section;
}

}  // namespace runout
