#include "report/text/run_out_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/csv_cell.h"
#include "core/printable.h"
#include "report/text/reach_probability.h"
#include "report/text/sensitivity.h"
#include "report/text/study_layout.h"
#include "report/text/table.h"

namespace runout {
namespace {

using Json = nlohmann::ordered_json;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::array percentiles = {0.5, 0.16, 0.02};

std::string number_or_dash(double value) {
    return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-";
}

std::string cell_text(const StudyCell& cell) {
    if (cell.runs.size() > 1)
        return fmt::format("{} / {} / {} (n {})", number_or_dash(cell.reached(percentiles[0])),
                           number_or_dash(cell.reached(percentiles[1])),
                           number_or_dash(cell.reached(percentiles[2])), cell.runs.size());
    const StudyRow& run = *cell.runs.front();
    if (run.status == "stable") return "stands";
    std::string text = number_or_dash(run.run_out_m);
    if (std::isfinite(run.run_out_error_m)) text += fmt::format(" +-{:.2g}", run.run_out_error_m);
    if (std::isfinite(run.reach_angle_deg)) text += fmt::format(", {:.1f} deg", run.reach_angle_deg);
    return text;
}

using Grid = std::vector<std::vector<std::string>>;

Grid grid_of(const std::vector<StudyEntry>& entries, const StudyLayout& layout) {
    const StudyCells cells = cells_of(entries, layout);
    const StudyLabels rows = labels_of(entries, layout.rows), columns = labels_of(entries, layout.columns);
    Grid grid(1, {printable(fmt::format("{} \\ {}", layout.rows, layout.columns))});
    for (const std::string& column : columns) grid[0].push_back(printable(column));
    for (const std::string& row : rows) {
        std::vector<std::string>& line = grid.emplace_back(1, printable(row));
        for (const std::string& column : columns) {
            const auto cell = cells.find({row, column});
            line.push_back(cell == cells.end() ? "-" : cell_text(cell->second));
        }
    }
    return grid;
}

/// Display width of ASCII and of what UTF-8 spreads over several bytes.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string aligned(const Grid& grid, bool markdown) {
    std::vector<std::size_t> widths(grid[0].size(), 0);
    for (const auto& line : grid)
        for (std::size_t c = 0; c < line.size(); ++c) widths[c] = std::max(widths[c], width_of(line[c]));
    std::string text;
    for (std::size_t r = 0; r < grid.size(); ++r) {
        std::string line = markdown ? "| " : "";
        for (std::size_t c = 0; c < grid[r].size(); ++c) {
            const std::string padding(widths[c] - width_of(grid[r][c]), ' ');
            line += c == 0 ? grid[r][c] + padding : padding + grid[r][c];
            line += markdown ? " | " : "  ";
        }
        while (line.ends_with(' ')) line.pop_back();
        text += line + "\n";
        if (r > 0 || !markdown) continue;
        text += "|";
        for (std::size_t c = 0; c < widths.size(); ++c) text += c == 0 ? "---|" : "---:|";
        text += "\n";
    }
    return text;
}

// ---- what stands below the table

std::vector<double> run_outs(const std::vector<StudyEntry>& entries) {
    std::vector<double> values;
    for (const StudyEntry& entry : entries)
        if (entry.row->is_result)
            values.push_back(std::isfinite(entry.row->run_out_m) ? entry.row->run_out_m : 0.0);
    return values;
}

std::vector<VariedInput> varied_numbers(const std::vector<StudyEntry>& entries) {
    std::vector<VariedInput> inputs;
    if (entries.empty()) return inputs;
    for (const auto& [key, first] : entries.front().numbers) {
        VariedInput input{key, {}};
        for (const StudyEntry& entry : entries) {
            const auto number = entry.numbers.find(key);
            if (entry.row->is_result)
                input.values.push_back(number == entry.numbers.end() ? none : number->second);
        }
        inputs.push_back(std::move(input));
    }
    return inputs;
}

/// Farthest front at any instant, as a place is reached; of a run that does not know it, the front at rest.
double reached_by(const StudyRow& row) {
    if (std::isfinite(row.farthest_front_m)) return row.farthest_front_m;
    return std::isfinite(row.run_out_m) ? row.run_out_m : 0.0;
}

std::string former_fronts(const std::vector<StudyEntry>& entries) {
    const auto count = std::ranges::count_if(entries, [](const StudyEntry& entry) {
        return entry.row->is_result && entry.row->front_definition != current_front_definition;
    });
    if (count == 0) return {};
    return fmt::format("{} of {} scenarios: {}\n", count, entries.size(), former_front_sentence());
}

struct Reached {
    double distance_m;
    Probability probability;
};

std::vector<Reached> reached_distances(const std::vector<StudyEntry>& entries,
                                       const std::vector<double>& distances) {
    std::vector<ReachSample> samples;
    for (const StudyEntry& entry : entries)
        if (entry.row->is_result) samples.push_back({reached_by(*entry.row), 1});
    std::vector<Reached> all;
    if (samples.empty()) return all;
    for (const double distance : distances)
        all.push_back({distance, probability_of_reaching(samples, distance)});
    return all;
}

std::string why_not(const StudyRow& row) {
    if (!row.scenario.refusal.empty()) return "refused: " + row.scenario.refusal;
    if (!row.run_id) return "not run yet";
    return row.status + (row.status_detail.empty() ? "" : ": " + row.status_detail);
}

std::vector<const StudyRow*> without_result(const std::vector<StudyEntry>& entries) {
    std::vector<const StudyRow*> rows;
    for (const StudyEntry& entry : entries)
        if (!entry.row->is_result) rows.push_back(entry.row);
    return rows;
}

std::string below(const std::vector<StudyEntry>& entries, const RunOutTableOptions& options,
                  const char* item) {
    const std::string former = former_fronts(entries);
    std::string text = former.empty() ? former : item + former;
    for (const Reached& reached : reached_distances(entries, options.distances))
        text += fmt::format(
            "{}{:g} m or more is reached with a probability of {:.3g} +-{:.2g} (one standard error)\n", item,
            reached.distance_m, reached.probability.value, reached.probability.standard_error);
    for (const Sensitivity& one : sensitivities(varied_numbers(entries), run_outs(entries))) {
        if (!std::isfinite(one.rank_correlation)) continue;
        text += fmt::format("{}{}: rank correlation with the run-out {:.2f}", item, printable(one.name),
                            one.rank_correlation);
        if (std::isfinite(one.first_order))
            text += fmt::format(", share of its variance {:.2f} (first-order Sobol index, {} classes)",
                                one.first_order, one.classes);
        text += "\n";
    }
    const auto failed = without_result(entries);
    if (!failed.empty())
        text += fmt::format("\n{} of {} scenarios gave no result:\n", failed.size(), entries.size());
    for (const StudyRow* row : failed)
        text += fmt::format("{}{} {}: {}\n", item, row->scenario.index, printable(row->scenario.inputs),
                            printable(why_not(*row)));
    return text;
}

std::string page(const std::string& study, const std::vector<StudyEntry>& entries,
                 const RunOutTableOptions& options, bool markdown) {
    const StudyLayout layout = layout_of(entries, options);
    bool many = false;
    for (const auto& [place, cell] : cells_of(entries, layout)) many = many || cell.runs.size() > 1;
    std::string text =
        fmt::format("{}Run-out of {} past the toe, m{}\n\n", markdown ? "# " : "", printable(study),
                    many ? ": distances that 50 / 16 / 2 % of the scenarios reach or pass"
                         : ", with its numerical error (95 %) where it is known, and the reach angle");
    text += aligned(grid_of(entries, layout), markdown);
    const std::string rest = below(entries, options, markdown ? "- " : "");
    return rest.empty() ? text : text + "\n" + rest;
}

// ---- for machines

Json json_number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json cells_json(const std::vector<StudyEntry>& entries, const StudyLayout& layout) {
    Json list = Json::array();
    for (const auto& [labels, cell] : cells_of(entries, layout)) {
        const bool one = cell.runs.size() == 1;
        const StudyRow& run = *cell.runs.front();
        list.push_back(
            {{"row", labels.first},
             {"column", labels.second},
             {"scenarios", cell.runs.size()},
             {"run_out_m", one ? json_number(run.run_out_m) : Json(nullptr)},
             {"run_out_error_m", one ? json_number(run.run_out_error_m) : Json(nullptr)},
             {"reach_angle_deg", one ? json_number(run.reach_angle_deg) : Json(nullptr)},
             {"reach_angle_error_deg", one ? json_number(run.reach_angle_error_deg) : Json(nullptr)},
             {"run_out_50_percent_m", json_number(cell.reached(percentiles[0]))},
             {"run_out_16_percent_m", json_number(cell.reached(percentiles[1]))},
             {"run_out_2_percent_m", json_number(cell.reached(percentiles[2]))}});
    }
    return list;
}

std::string table_json(const std::string& study, const std::vector<StudyEntry>& entries,
                       const RunOutTableOptions& options) {
    const StudyLayout layout = layout_of(entries, options);
    Json object = {{"study", study},
                   {"rows", layout.rows},
                   {"columns", layout.columns},
                   {"cells", cells_json(entries, layout)}};
    object["reached"] = Json::array();
    for (const Reached& reached : reached_distances(entries, options.distances))
        object["reached"].push_back({{"distance_m", reached.distance_m},
                                     {"probability", reached.probability.value},
                                     {"standard_error", reached.probability.standard_error}});
    object["sensitivity"] = Json::array();
    for (const Sensitivity& one : sensitivities(varied_numbers(entries), run_outs(entries)))
        object["sensitivity"].push_back({{"input", one.name},
                                         {"rank_correlation", json_number(one.rank_correlation)},
                                         {"first_order_index", json_number(one.first_order)}});
    object["without_result"] = Json::array();
    for (const StudyRow* row : without_result(entries))
        object["without_result"].push_back(
            {{"scenario", row->scenario.index}, {"inputs", inputs_of(*row)}, {"reason", why_not(*row)}});
    return object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// One line a cell.
std::string table_csv(const std::vector<StudyEntry>& entries, const RunOutTableOptions& options) {
    const StudyLayout layout = layout_of(entries, options);
    std::string text = fmt::format(
        "{},{},scenarios,run_out_m,run_out_error_m,reach_angle_deg,reach_angle_error_deg,run_out_50_percent_"
        "m,"
        "run_out_16_percent_m,run_out_2_percent_m\n",
        csv_cell(layout.rows), csv_cell(layout.columns));
    for (const Json& cell : cells_json(entries, layout)) {
        std::vector<std::string> fields;
        for (const auto& [name, value] : cell.items()) {
            if (value.is_string())
                fields.push_back(csv_cell(value.get<std::string>()));
            else
                fields.push_back(
                    value.is_null() ? "" : value.dump(-1, ' ', false, Json::error_handler_t::replace));
        }
        text += fmt::format("{}\n", fmt::join(fields, ","));
    }
    return text;
}

}  // namespace

std::string run_out_table(const std::string& study, const std::vector<StudyRow>& rows,
                          const RunOutTableOptions& options, RunOutTableFormat format) {
    const std::vector<StudyEntry> entries = entries_of(rows);
    switch (format) {
        case RunOutTableFormat::text:
            return page(study, entries, options, false);
        case RunOutTableFormat::markdown:
            return page(study, entries, options, true);
        case RunOutTableFormat::csv:
            return table_csv(entries, options);
        case RunOutTableFormat::json:
            return table_json(study, entries, options);
    }
    return {};
}

}  // namespace runout
