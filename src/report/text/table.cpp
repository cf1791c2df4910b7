#include "report/text/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <type_traits>

#include "core/csv_cell.h"
#include "core/printable.h"
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

std::string csv_table(const std::vector<StoredRun>& runs) {
    std::string header;
    for (const RunColumn& column : run_columns({}))
        header += fmt::format("{}{}", header.empty() ? "" : ",", csv_cell(column.name));
    std::string text = header + "\n";
    for (const StoredRun& run : runs) {
        std::string line;
        for (const RunColumn& column : run_columns(run)) line += cell_text(column.value) + ",";
        line.back() = '\n';
        text += line;
    }
    return text;
}

/// A column of the text table: the few numbers that are compared at a glance.
struct TextColumn {
    const char* title;
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

const std::vector<TextColumn>& text_columns() {
    static const std::vector<TextColumn> columns = {
        {"run", "", false, [](const StoredRun& run) { return std::to_string(run.run_id); }},
        {"name", "", true, [](const StoredRun& run) { return run.name; }},
        {"source", "", true, [](const StoredRun& run) { return run.source_type; }},
        {"slope", "deg", false, angle(&StoredRun::slope_angle_deg)},
        {"friction", "deg", false, angle(&StoredRun::friction_angle_deg)},
        {"area", "m2", false, measure(&Measures::source_area_m2, "{:.4g}")},
        {"drop height", "m", false, measure(&Measures::drop_height_m, "{:.4g}")},
        {"run-out", "m", false, measure(&Measures::run_out_m, "{:.4g}")},
        {"+-", "m", false, error(&Appraisal::run_out_error_m, "{:.2g}")},
        {"L/sqrt(S)", "-", false, measure(&Measures::run_out_normalised, "{:.3f}")},
        {"reach angle", "deg", false, measure(&Measures::reach_angle_deg, "{:.1f}")},
        {"+-", "deg", false, error(&Appraisal::reach_angle_error_deg, "{:.1f}")},
        {"error from", "", true, [](const StoredRun& run) { return run.appraisal.error_origin; }},
        {"toe thickness", "m", false, measure(&Measures::toe_thickness_m, "{:.3g}")},
        {"front speed", "m/s", false, measure(&Measures::peak_front_speed_m_s, "{:.3g}")},
        {"status", "", true, [](const StoredRun& run) { return std::string(to_string(run.status)); }},
    };
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

std::string aligned(const std::vector<Line>& lines) {
    const auto& columns = text_columns();
    std::vector<std::size_t> widths(columns.size(), 0);
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

std::string text_table(const std::vector<StoredRun>& runs) {
    if (runs.empty()) return "no runs stored\n";
    std::vector<Line> lines(2);
    for (const TextColumn& column : text_columns()) {
        lines[0].emplace_back(column.title);
        lines[1].emplace_back(column.unit);
    }
    for (const StoredRun& run : runs) {
        Line& line = lines.emplace_back();
        for (const TextColumn& column : text_columns()) line.push_back(printable(column.cell(run)));
    }
    return aligned(lines) + reasons(runs);
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
