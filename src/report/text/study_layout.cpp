#include "report/text/study_layout.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/input_error.h"
#include "core/printable.h"
#include "report/text/reach_probability.h"

namespace runout {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array row_words = {"section", "source_type", "slope_angle_deg", "drop_height_m",
                                  "friction_angle_deg"};
constexpr std::size_t most_columns = 40;
// What has more values than this is sampled, and no table is laid out by it unasked.
constexpr std::size_t most_unasked = 12;

std::string label_of(const Json& value) {
    if (value.is_number()) return fmt::format("{:.4g}", value.get<double>());
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// "cut-60" for profiles/cut-60.csv; a line on a map has its name behind that of the case.
std::string section_label(const StudyRow& row) {
    const bool on_map = row.section_origin.find(" along ") != std::string::npos;
    return on_map ? row.name : std::filesystem::path(row.section_origin).stem().string();
}

std::string value_of(const StudyEntry& entry, const std::string& word) {
    const StudyRow& row = *entry.row;
    if (const auto input = entry.inputs.find(word); input != entry.inputs.end()) return input->second;
    if (word == "section") return section_label(row);
    if (word == "source_type") return row.source_type;
    if (word == "slope_angle_deg") return fmt::format("{:.4g}", row.slope_angle_deg);
    if (word == "drop_height_m") return fmt::format("{:.4g}", row.drop_height_m);
    if (word == "friction_angle_deg") return fmt::format("{:.4g}", row.friction_angle_deg);
    return {};
}

/// Sections, then what the study varies, then what follows from them.
std::vector<std::string> known_words(const std::vector<StudyEntry>& entries) {
    std::vector<std::string> words = {row_words.front()};
    if (!entries.empty())
        for (const auto& [key, value] : entries.front().inputs) words.push_back(key);
    words.insert(words.end(), row_words.begin() + 1, row_words.end());
    return words;
}

void check_word(const char* option, const std::string& word, const std::vector<StudyEntry>& entries) {
    const std::vector<std::string> words = known_words(entries);
    if (std::ranges::find(words, word) == words.end())
        throw InputError({.file = option, .line = 0, .key = {}, .value = word}, "is not varied by this study",
                         fmt::format("valid: {}", fmt::join(words, ", ")));
}

/// Whether the two words tell the same scenarios apart, as an angle and the key that sets it do.
bool say_the_same(const std::vector<StudyEntry>& entries, const std::string& a, const std::string& b) {
    std::set<std::pair<std::string, std::string>> pairs;
    for (const StudyEntry& entry : entries)
        if (entry.row->run_id) pairs.insert({value_of(entry, a), value_of(entry, b)});
    return pairs.size() == labels_of(entries, a).size() && pairs.size() == labels_of(entries, b).size();
}

/// The first word with some values, but not as many as a sampled one.
std::string chosen_word(const std::vector<StudyEntry>& entries, const std::string& except) {
    for (const std::string& word : known_words(entries)) {
        const std::size_t count = labels_of(entries, word).size();
        if (count < 2 || count > most_unasked) continue;
        if (word != except && (except.empty() || !say_the_same(entries, word, except))) return word;
    }
    return except == "section" ? "source_type" : "section";
}

}  // namespace

bool LabelOrder::operator()(const std::string& a, const std::string& b) const {
    const auto number = [](const std::string& text) {
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        return error == std::errc{} && end == text.data() + text.size()
                   ? value
                   : std::numeric_limits<double>::quiet_NaN();
    };
    const double x = number(a), y = number(b);
    if (std::isfinite(x) != std::isfinite(y)) return std::isfinite(x);
    if (std::isfinite(x) && x != y) return x < y;
    return a < b;
}

bool CellOrder::operator()(const std::pair<std::string, std::string>& a,
                           const std::pair<std::string, std::string>& b) const {
    if (a.first == b.first) return LabelOrder()(a.second, b.second);
    return LabelOrder()(a.first, b.first);
}

Json inputs_of(const StudyRow& row) {
    Json inputs = Json::parse(printable_json(row.scenario.inputs), nullptr, false);
    if (!inputs.is_object())
        throw InputError({fmt::format("scenario {}", row.scenario.index), 0, "inputs", ""},
                         "cannot be read as a JSON object",
                         "the database is damaged: take another copy of it");
    return inputs;
}

std::vector<StudyEntry> entries_of(const std::vector<StudyRow>& rows) {
    std::vector<StudyEntry> entries;
    for (const StudyRow& row : rows) {
        StudyEntry& entry = entries.emplace_back();
        entry.row = &row;
        const Json inputs = inputs_of(row);
        for (const auto& [key, value] : inputs.items()) {
            entry.inputs[key] = label_of(value);
            if (value.is_number()) entry.numbers[key] = value.get<double>();
        }
    }
    return entries;
}

StudyLabels labels_of(const std::vector<StudyEntry>& entries, const std::string& word) {
    StudyLabels labels;
    for (const StudyEntry& entry : entries)
        if (entry.row->run_id) labels.insert(value_of(entry, word));
    return labels;
}

StudyLayout layout_of(const std::vector<StudyEntry>& entries, const RunOutTableOptions& options) {
    StudyLayout layout{options.rows, options.columns};
    if (!layout.rows.empty()) check_word("--rows", layout.rows, entries);
    if (!layout.columns.empty()) check_word("--columns", layout.columns, entries);
    if (layout.rows.empty()) layout.rows = chosen_word(entries, layout.columns);
    if (layout.columns.empty()) layout.columns = chosen_word(entries, layout.rows);
    if (labels_of(entries, layout.columns).size() > most_columns)
        throw InputError({.file = "--columns", .line = 0, .key = {}, .value = layout.columns},
                         fmt::format("has more than {} values", most_columns), "choose what has fewer");
    return layout;
}

double StudyCell::reached(double probability) const {
    std::vector<ReachSample> all;
    for (const StudyRow* run : runs) all.push_back({std::isfinite(run->run_out_m) ? run->run_out_m : 0.0, 1});
    return distance_reached(all, probability).distance_m;
}

StudyCells cells_of(const std::vector<StudyEntry>& entries, const StudyLayout& layout) {
    StudyCells cells;
    for (const StudyEntry& entry : entries)
        if (entry.row->is_result)
            cells[{value_of(entry, layout.rows), value_of(entry, layout.columns)}].runs.push_back(entry.row);
    return cells;
}

}  // namespace runout
