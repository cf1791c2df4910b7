#include "report/run_out_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/input_error.h"
#include "report/reach_probability.h"
#include "report/sensitivity.h"
#include "report/table.h"

namespace runout {
namespace {

using Json = nlohmann::ordered_json;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::array percentiles = {0.5, 0.16, 0.02};
constexpr std::array row_words = {"section", "source_type", "slope_angle_deg", "drop_height_m",
                                  "friction_angle_deg"};
constexpr std::size_t most_columns = 40;
// What has more values than this is sampled, and no table is laid out by it unasked.
constexpr std::size_t most_unasked = 12;

/// A row of the study with its inputs read.
struct Entry {
    const StudyRow* row = nullptr;
    std::map<std::string, std::string> inputs;  ///< as labels
    std::map<std::string, double> numbers;      ///< those that are numbers
};

std::string label_of(const Json& value) {
    if (value.is_number()) return fmt::format("{:.4g}", value.get<double>());
    return value.is_string() ? value.get<std::string>() : value.dump();
}

std::vector<Entry> entries_of(const std::vector<StudyRow>& rows) {
    std::vector<Entry> entries;
    for (const StudyRow& row : rows) {
        Entry& entry = entries.emplace_back();
        entry.row = &row;
        const Json inputs = Json::parse(row.scenario.inputs);
        for (const auto& [key, value] : inputs.items()) {
            entry.inputs[key] = label_of(value);
            if (value.is_number()) entry.numbers[key] = value.get<double>();
        }
    }
    return entries;
}

/// "cut-60" for profiles/cut-60.csv; a line on a map has its name behind that of the case.
std::string section_label(const StudyRow& row) {
    const bool on_map = row.section_origin.find(" along ") != std::string::npos;
    return on_map ? row.name : std::filesystem::path(row.section_origin).stem().string();
}

std::string value_of(const Entry& entry, const std::string& word) {
    const StudyRow& row = *entry.row;
    if (const auto input = entry.inputs.find(word); input != entry.inputs.end()) return input->second;
    if (word == "section") return section_label(row);
    if (word == "source_type") return row.source_type;
    if (word == "slope_angle_deg") return fmt::format("{:.4g}", row.slope_angle_deg);
    if (word == "drop_height_m") return fmt::format("{:.4g}", row.drop_height_m);
    if (word == "friction_angle_deg") return fmt::format("{:.4g}", row.friction_angle_deg);
    return {};
}

/// Numbers by size, then words.
struct LabelOrder {
    bool operator()(const std::string& a, const std::string& b) const {
        const auto number = [](const std::string& text) {
            double value = 0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
            return error == std::errc{} && end == text.data() + text.size() ? value : none;
        };
        const double x = number(a), y = number(b);
        if (std::isfinite(x) != std::isfinite(y)) return std::isfinite(x);
        if (std::isfinite(x) && x != y) return x < y;
        return a < b;
    }
};
using Labels = std::set<std::string, LabelOrder>;

Labels labels_of(const std::vector<Entry>& entries, const std::string& word) {
    Labels labels;
    for (const Entry& entry : entries)
        if (entry.row->run_id) labels.insert(value_of(entry, word));
    return labels;
}

/// Sections, then what the study varies, then what follows from them.
std::vector<std::string> known_words(const std::vector<Entry>& entries) {
    std::vector<std::string> words = {row_words.front()};
    if (!entries.empty())
        for (const auto& [key, value] : entries.front().inputs) words.push_back(key);
    words.insert(words.end(), row_words.begin() + 1, row_words.end());
    return words;
}

void check_word(const char* option, const std::string& word, const std::vector<Entry>& entries) {
    const std::vector<std::string> words = known_words(entries);
    if (std::ranges::find(words, word) == words.end())
        throw InputError({.file = option, .line = 0, .key = {}, .value = word}, "is not varied by this study",
                         fmt::format("valid: {}", fmt::join(words, ", ")));
}

/// Whether the two words tell the same scenarios apart, as an angle and the key that sets it do.
bool say_the_same(const std::vector<Entry>& entries, const std::string& a, const std::string& b) {
    std::set<std::pair<std::string, std::string>> pairs;
    for (const Entry& entry : entries)
        if (entry.row->run_id) pairs.insert({value_of(entry, a), value_of(entry, b)});
    return pairs.size() == labels_of(entries, a).size() && pairs.size() == labels_of(entries, b).size();
}

/// The first word with some values, but not as many as a sampled one.
std::string chosen_word(const std::vector<Entry>& entries, const std::string& except) {
    for (const std::string& word : known_words(entries)) {
        const std::size_t count = labels_of(entries, word).size();
        if (count < 2 || count > most_unasked) continue;
        if (word != except && (except.empty() || !say_the_same(entries, word, except))) return word;
    }
    return except == "section" ? "source_type" : "section";
}

struct Layout {
    std::string rows, columns;
};

Layout layout_of(const std::vector<Entry>& entries, const RunOutTableOptions& options) {
    Layout layout{options.rows, options.columns};
    if (!layout.rows.empty()) check_word("--rows", layout.rows, entries);
    if (!layout.columns.empty()) check_word("--columns", layout.columns, entries);
    if (layout.rows.empty()) layout.rows = chosen_word(entries, layout.columns);
    if (layout.columns.empty()) layout.columns = chosen_word(entries, layout.rows);
    if (labels_of(entries, layout.columns).size() > most_columns)
        throw InputError({.file = "--columns", .line = 0, .key = {}, .value = layout.columns},
                         fmt::format("has more than {} values", most_columns), "choose what has fewer");
    return layout;
}

/// The results that share a row and a column.
struct TableCell {
    std::vector<const StudyRow*> runs;

    [[nodiscard]] std::vector<ReachSample> samples() const {
        std::vector<ReachSample> all;
        for (const StudyRow* run : runs)
            all.push_back({std::isfinite(run->run_out_m) ? run->run_out_m : 0.0, 1});
        return all;
    }
    [[nodiscard]] double reached(double probability) const {
        return distance_reached(samples(), probability).distance_m;
    }
};
using Cells = std::map<std::pair<std::string, std::string>, TableCell>;

Cells cells_of(const std::vector<Entry>& entries, const Layout& layout) {
    Cells cells;
    for (const Entry& entry : entries)
        if (entry.row->is_result)
            cells[{value_of(entry, layout.rows), value_of(entry, layout.columns)}].runs.push_back(entry.row);
    return cells;
}

std::string number_or_dash(double value) {
    return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-";
}

std::string cell_text(const TableCell& cell) {
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

Grid grid_of(const std::vector<Entry>& entries, const Layout& layout) {
    const Cells cells = cells_of(entries, layout);
    const Labels rows = labels_of(entries, layout.rows), columns = labels_of(entries, layout.columns);
    Grid grid(1, {fmt::format("{} \\ {}", layout.rows, layout.columns)});
    grid[0].insert(grid[0].end(), columns.begin(), columns.end());
    for (const std::string& row : rows) {
        std::vector<std::string>& line = grid.emplace_back(1, row);
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

std::vector<double> run_outs(const std::vector<Entry>& entries) {
    std::vector<double> values;
    for (const Entry& entry : entries)
        if (entry.row->is_result)
            values.push_back(std::isfinite(entry.row->run_out_m) ? entry.row->run_out_m : 0.0);
    return values;
}

std::vector<VariedInput> varied_numbers(const std::vector<Entry>& entries) {
    std::vector<VariedInput> inputs;
    if (entries.empty()) return inputs;
    for (const auto& [key, first] : entries.front().numbers) {
        VariedInput input{key, {}};
        for (const Entry& entry : entries) {
            const auto number = entry.numbers.find(key);
            if (entry.row->is_result)
                input.values.push_back(number == entry.numbers.end() ? none : number->second);
        }
        inputs.push_back(std::move(input));
    }
    return inputs;
}

struct Reached {
    double distance_m;
    Probability probability;
};

std::vector<Reached> reached_distances(const std::vector<Entry>& entries,
                                       const std::vector<double>& distances) {
    std::vector<ReachSample> samples;
    for (const double run_out : run_outs(entries)) samples.push_back({run_out, 1});
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

std::vector<const StudyRow*> without_result(const std::vector<Entry>& entries) {
    std::vector<const StudyRow*> rows;
    for (const Entry& entry : entries)
        if (!entry.row->is_result) rows.push_back(entry.row);
    return rows;
}

std::string below(const std::vector<Entry>& entries, const RunOutTableOptions& options, const char* item) {
    std::string text;
    for (const Reached& reached : reached_distances(entries, options.distances))
        text += fmt::format(
            "{}{:g} m or more is reached with a probability of {:.3g} +-{:.2g} (one standard error)\n", item,
            reached.distance_m, reached.probability.value, reached.probability.standard_error);
    for (const Sensitivity& one : sensitivities(varied_numbers(entries), run_outs(entries))) {
        if (!std::isfinite(one.rank_correlation)) continue;
        text += fmt::format("{}{}: rank correlation with the run-out {:.2f}", item, one.name,
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
        text += fmt::format("{}{} {}: {}\n", item, row->scenario.index, row->scenario.inputs, why_not(*row));
    return text;
}

std::string page(const std::string& study, const std::vector<Entry>& entries,
                 const RunOutTableOptions& options, bool markdown) {
    const Layout layout = layout_of(entries, options);
    bool many = false;
    for (const auto& [place, cell] : cells_of(entries, layout)) many = many || cell.runs.size() > 1;
    std::string text =
        fmt::format("{}Run-out of {} past the toe, m{}\n\n", markdown ? "# " : "", study,
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

Json cells_json(const std::vector<Entry>& entries, const Layout& layout) {
    Json list = Json::array();
    const Cells cells = cells_of(entries, layout);
    for (const std::string& row : labels_of(entries, layout.rows))
        for (const std::string& column : labels_of(entries, layout.columns)) {
            const auto found = cells.find({row, column});
            if (found == cells.end()) continue;
            const TableCell& cell = found->second;
            const bool one = cell.runs.size() == 1;
            const StudyRow& run = *cell.runs.front();
            list.push_back(
                {{"row", row},
                 {"column", column},
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

std::string table_json(const std::string& study, const std::vector<Entry>& entries,
                       const RunOutTableOptions& options) {
    const Layout layout = layout_of(entries, options);
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
        object["without_result"].push_back({{"scenario", row->scenario.index},
                                            {"inputs", Json::parse(row->scenario.inputs)},
                                            {"reason", why_not(*row)}});
    return object.dump(2) + "\n";
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

/// One line a cell.
std::string table_csv(const std::vector<Entry>& entries, const RunOutTableOptions& options) {
    const Layout layout = layout_of(entries, options);
    std::string text = fmt::format(
        "{},{},scenarios,run_out_m,run_out_error_m,reach_angle_deg,reach_angle_error_deg,run_out_50_percent_"
        "m,"
        "run_out_16_percent_m,run_out_2_percent_m\n",
        layout.rows, layout.columns);
    for (const Json& cell : cells_json(entries, layout)) {
        std::vector<std::string> fields;
        for (const auto& [name, value] : cell.items()) {
            if (value.is_string())
                fields.push_back(quoted(value.get<std::string>()));
            else
                fields.push_back(value.is_null() ? "" : value.dump());
        }
        text += fmt::format("{}\n", fmt::join(fields, ","));
    }
    return text;
}

}  // namespace

std::string run_out_table(const std::string& study, const std::vector<StudyRow>& rows,
                          const RunOutTableOptions& options, RunOutTableFormat format) {
    const std::vector<Entry> entries = entries_of(rows);
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
