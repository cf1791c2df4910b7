#include "report/text/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <type_traits>

#include "core/csv_cell.h"
#include "core/printable.h"
#include "report/text/place_doubt.h"
#include "report/text/run_columns.h"
#include "report/text/run_json.h"

namespace runout {
namespace {

std::string cell_text(const Cell& cell) {
    return std::visit(
        [](const auto& value) -> std::string {
            using Value = std::decay_t<decltype(value)>;
            if constexpr (std::is_same_v<Value, std::monostate>)
                return {};
            else if constexpr (std::is_same_v<Value, std::string>)
                return csv_cell(value);
            else
                return fmt::format("{}", value);  // shortest text that reads back as the same number
        },
        cell);
}

/// Of all runs, each once, in the order in which they come.
std::vector<std::string> place_names(const std::vector<StoredRun>& runs) {
    std::vector<std::string> names;
    for (const StoredRun& run : runs)
        for (const PlaceRecord& place : run.places)
            if (std::ranges::find(names, place.name) == names.end()) names.push_back(place.name);
    return names;
}

/// Null where the run does not know the place or is no result.
const PlaceRecord* place_named(const StoredRun& run, const std::string& name) {
    const auto found = std::ranges::find(run.places, name, &PlaceRecord::name);
    return found == run.places.end() || !is_result(run.status) ? nullptr : &*found;
}

/// What a place adds to a line of CSV: "place house reached", ...
std::vector<RunColumn> place_columns_of(const StoredRun& run, const std::string& name) {
    const PlaceRecord* place = place_named(run, name);
    const auto number = [&](double PlaceRecord::*value) {
        return place != nullptr && std::isfinite(place->*value) ? Cell(place->*value) : Cell();
    };
    const bool is_reached = place != nullptr && std::isfinite(place->arrival_time_s);
    const std::string start = fmt::format("place {} ", name);
    return {{start + "reached", place == nullptr ? Cell() : Cell(is_reached ? 1L : 0L)},
            {start + "arrival_time_s", number(&PlaceRecord::arrival_time_s)},
            {start + "greatest_thickness_m", number(&PlaceRecord::greatest_thickness_m)},
            {start + "greatest_speed_m_s", number(&PlaceRecord::greatest_speed_m_s)}};
}

std::string csv_table(const std::vector<StoredRun>& runs) {
    const std::vector<std::string> places = place_names(runs);
    std::string header;
    for (const RunColumn& column : run_columns({}))
        header += fmt::format("{}{}", header.empty() ? "" : ",", csv_cell(column.name));
    for (const std::string& place : places)
        for (const RunColumn& column : place_columns_of({}, place))
            header += fmt::format(",{}", csv_cell(column.name));
    std::string text = header + "\n";
    for (const StoredRun& run : runs) {
        std::string line;
        for (const RunColumn& column : run_columns(run)) line += fmt::format("{},", cell_text(column.value));
        for (const std::string& place : places)
            for (const RunColumn& column : place_columns_of(run, place))
                line += fmt::format("{},", cell_text(column.value));
        line.back() = '\n';
        text += line;
    }
    return text;
}

/// A column of the text table: the few numbers that are compared at a glance.
struct TextColumn {
    std::string title;
    const char* unit;
    bool is_word;  ///< words to the left, numbers to the right
    std::function<std::string(const StoredRun&)> cell;
};

std::function<std::string(const StoredRun&)> angle(double StoredRun::*value) {
    return [value](const StoredRun& run) { return fmt::format("{:.1f}", run.*value); };
}

std::function<std::string(const StoredRun&)> measure(double Measures::*value, const char* format) {
    return [value, format](const StoredRun& run) -> std::string {
        const double number = run.measures.*value;
        if (!is_result(run.status) || !std::isfinite(number)) return {};
        return fmt::format(fmt::runtime(format), number);
    };
}

/// Numerical uncertainty; nothing where it is not known.
std::function<std::string(const StoredRun&)> error(double Appraisal::*value, const char* format) {
    return [value, format](const StoredRun& run) -> std::string {
        const double number = run.appraisal.*value;
        if (!is_result(run.status) || !std::isfinite(number)) return {};
        return fmt::format(fmt::runtime(format), number);
    };
}

/// With a mark where the front has its former definition.
std::string run_out_cell(const StoredRun& run) {
    const std::string number = measure(&Measures::run_out_m, "{:.4g}")(run);
    return number.empty() || run.front_definition == current_front_definition ? number
                                                                              : fmt::format("{}*", number);
}

/// Thickness and speed of what arrived at a place.
std::string place_cell(const StoredRun& run, const std::string& name) {
    const PlaceRecord* place = place_named(run, name);
    if (place == nullptr) return {};
    const PlaceDoubt doubt = place_doubt(run, *place);
    if (!doubt.reached) return doubt.words();
    return fmt::format("{:.3g} m, {:.3g} m/s{}", place->greatest_thickness_m, place->greatest_speed_m_s,
                       doubt.within_error() ? ", within error" : "");
}

std::vector<TextColumn> text_columns(const std::vector<StoredRun>& runs) {
    std::vector<TextColumn> columns = {
        {"run", "", false, [](const StoredRun& run) { return std::to_string(run.run_id); }},
        {"name", "", true, [](const StoredRun& run) { return run.name; }},
        {"source", "", true, [](const StoredRun& run) { return run.source_type; }},
        {"slope", "deg", false, angle(&StoredRun::slope_angle_deg)},
        {"friction", "deg", false, angle(&StoredRun::friction_angle_deg)},
        {"area", "m2", false, measure(&Measures::source_area_m2, "{:.4g}")},
        {"drop height", "m", false, measure(&Measures::drop_height_m, "{:.4g}")},
        {"run-out", "m", false, run_out_cell},
        {"+-", "m", false, error(&Appraisal::run_out_error_m, "{:.2g}")},
        {"L/sqrt(S)", "-", false, measure(&Measures::run_out_normalised, "{:.3f}")},
        {"reach angle", "deg", false, measure(&Measures::reach_angle_deg, "{:.1f}")},
        {"+-", "deg", false, error(&Appraisal::reach_angle_error_deg, "{:.1f}")},
        {"error from", "", true, [](const StoredRun& run) { return run.appraisal.error_origin; }},
        {"toe thickness", "m", false, measure(&Measures::toe_thickness_m, "{:.3g}")},
        {"front speed", "m/s", false, measure(&Measures::peak_front_speed_m_s, "{:.3g}")},
        {"status", "", true, [](const StoredRun& run) { return std::string(to_string(run.status)); }},
    };
    for (const std::string& name : place_names(runs))
        columns.insert(columns.end() - 1, {fmt::format("at {}", name), "", true,
                                           [name](const StoredRun& run) { return place_cell(run, name); }});
    return columns;
}

/// Columns that a terminal needs for UTF-8 text: none for continuation bytes, two for the characters of
/// Chinese, Japanese and Korean, which begin with the bytes E3 to ED.
std::size_t display_width(const std::string& text) {
    std::size_t width = 0;
    for (const char letter : text) {
        const auto byte = static_cast<unsigned char>(letter);
        if ((byte & 0xC0U) == 0x80U) continue;
        width += byte >= 0xE3 && byte <= 0xED ? 2 : 1;
    }
    return width;
}

using Line = std::vector<std::string>;

std::string aligned(const std::vector<Line>& lines, const std::vector<TextColumn>& columns) {
    std::vector<std::size_t> widths(lines.front().size(), 0);
    for (const Line& line : lines)
        for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], display_width(line[i]));
    std::string text;
    for (const Line& line : lines) {
        std::string row;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const std::string gap(widths[i] - display_width(line[i]), ' ');
            row += (i == 0 ? "" : "  ") + (columns[i].is_word ? line[i] + gap : gap + line[i]);
        }
        row.erase(row.find_last_not_of(' ') + 1);
        text += row + "\n";
    }
    return text;
}

/// The reasons, below the table, for every row that has no numbers.
std::string reasons(const std::vector<StoredRun>& runs) {
    std::string text;
    for (const StoredRun& run : runs)
        if (!is_result(run.status))
            text += fmt::format("run {}: no result: {}{}{}\n", run.run_id, to_string(run.status),
                                run.status_detail.empty() ? "" : ", ", printable(run.status_detail));
    return text.empty() ? text : "\n" + text;
}

/// What the mark means.
std::string former_fronts(const std::vector<StoredRun>& runs) {
    const bool any = std::ranges::any_of(runs, [](const StoredRun& run) {
        return is_result(run.status) && run.front_definition != current_front_definition;
    });
    return any ? fmt::format("\n* {}\n", former_front_sentence()) : "";
}

std::string text_table(const std::vector<StoredRun>& runs) {
    if (runs.empty()) return "no runs stored\n";
    const std::vector<TextColumn> columns = text_columns(runs);
    std::vector<Line> lines(2);
    for (const TextColumn& column : columns) {
        lines[0].push_back(printable(column.title));
        lines[1].emplace_back(column.unit);
    }
    for (const StoredRun& run : runs) {
        Line& line = lines.emplace_back();
        for (const TextColumn& column : columns) line.push_back(printable(column.cell(run)));
    }
    return aligned(lines, columns) + former_fronts(runs) + reasons(runs);
}

}  // namespace

std::string run_table(const std::vector<StoredRun>& runs, TableFormat format) {
    switch (format) {
        case TableFormat::csv:
            return csv_table(runs);
        case TableFormat::json:
            return runs_json(runs);
        case TableFormat::text:
            break;
    }
    return text_table(runs);
}

}  // namespace runout
