#include "validation/back_analysis.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>

#include "core/input_error.h"
#include "core/text_file.h"
#include "scene/parameters.h"
#include "study/scenarios.h"

namespace runout {
namespace {

constexpr std::size_t most_combinations = 1000;
constexpr std::array firmness_words = {"found", "derived", "second-hand", "assumed"};
constexpr double none = std::numeric_limits<double>::quiet_NaN();

using Fields = std::vector<std::string>;

struct Line {
    InputPlace place;
    Fields fields;
};

Fields split(const std::string& text, char mark) {
    Fields fields(1);
    for (const char letter : text) {
        if (letter == mark)
            fields.emplace_back();
        else if (letter != '\r')
            fields.back() += letter;
    }
    return fields;
}

/// Lines of a CSV with just these columns; # starts a comment line. No quotes: a field holds no comma.
std::vector<Line> read_lines(const std::string& path, const Fields& columns) {
    std::istringstream file(
        read_text_file(path, "a back-analysis has case.toml, ranges.csv and observed.csv"));
    InputPlace place{.file = path, .line = 0, .key = {}, .value = {}};
    const std::string header = fmt::format("{}", fmt::join(columns, ","));
    std::vector<Line> lines;
    bool in_header = true;
    for (std::string text; std::getline(file, text);) {
        ++place.line;
        if (text.empty() || text == "\r" || text.front() == '#') continue;
        Fields fields = split(text, ',');
        if (in_header && fields != columns)
            throw InputError(place, "has other columns", "the first line must be " + header);
        if (!in_header) {
            if (fields.size() != columns.size())
                throw InputError(place, fmt::format("has {} fields", fields.size()),
                                 fmt::format("give {}: {}", columns.size(), header));
            lines.push_back({place, std::move(fields)});
        }
        in_header = false;
    }
    if (in_header) throw InputError(place, "is empty", "the first line must be " + header);
    return lines;
}

void check_firmness(const Line& line, const std::string& word) {
    if (std::ranges::find(firmness_words, word) != firmness_words.end()) return;
    InputPlace place = line.place;
    place.key = "firmness";
    place.value = word;
    throw InputError(place, "is not known", fmt::format("valid: {}", fmt::join(firmness_words, ", ")));
}

InputRange range_of(const Line& line) {
    InputRange range{line.fields[0], split(line.fields[1], '|'), line.fields[2], line.fields[3]};
    InputPlace place = line.place;
    place.key = range.key;
    place.value = line.fields[1];
    static_cast<void>(known_parameter(place));
    if (std::ranges::find(range.values, "") != range.values.end())
        throw InputError(place, "has an empty value", "separate values with |, such as 22|29");
    check_firmness(line, range.firmness);
    return range;
}

double number_or_none(const Line& line, std::size_t column) {
    const std::string& text = line.fields[column];
    if (text.empty()) return none;
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && end == text.data() + text.size()) return value;
    InputPlace place = line.place;
    place.key = column == 1 ? "low" : "high";
    place.value = text;
    throw InputError(place, "is not a number", "give a number, or nothing where it is not known");
}

Observation observation_of(const Line& line) {
    Observation seen{line.fields[0], number_or_none(line, 1), number_or_none(line, 2), line.fields[3],
                     line.fields[4]};
    const bool is_known = std::isfinite(seen.low) || std::isfinite(seen.high);
    if (is_known || !seen.firmness.empty()) check_firmness(line, seen.firmness);
    return seen;
}

/// The runs with one more key varied.
std::vector<PlannedRun> varied(const std::vector<PlannedRun>& runs, const InputRange& range) {
    std::vector<PlannedRun> more;
    for (const PlannedRun& run : runs)
        for (const std::string& value : range.values) {
            PlannedRun& next = more.emplace_back(run);
            next.set.emplace_back(range.key, value);
            next.id = fmt::format("{}{}{}={}", run.id, run.id.empty() ? "" : " ",
                                  range.key.substr(range.key.find('.') + 1), value);
        }
    return more;
}

/// A back-analysis is a study of its own name, so that its runs can be shown together.
void store_study(const BackAnalysis& analysis, const std::vector<PlannedRun>& planned,
                 const std::vector<long>& run_ids, Store& store) {
    const std::string text = read_text_file(analysis.folder + "/ranges.csv", "");
    std::vector<StudyScenario> scenarios;
    for (std::size_t i = 0; i < run_ids.size(); ++i)
        scenarios.push_back(
            {static_cast<long>(i), store.run(run_ids[i]).scenario_hash, settings_json(planned[i].set), ""});
    store.set_study_scenarios(store.begin_study(analysis.name, text), scenarios);
}

}  // namespace

BackAnalysis read_back_analysis(const std::string& folder) {
    namespace fs = std::filesystem;
    BackAnalysis analysis{folder, fs::path(folder).lexically_normal().filename().string(), {}, {}};
    if (analysis.name.empty())
        analysis.name = fs::path(folder).lexically_normal().parent_path().filename().string();
    if (!fs::is_directory(folder))
        throw InputError(
            {.file = folder, .line = 0, .key = {}, .value = {}}, "is not a folder",
            "give one with case.toml, ranges.csv and observed.csv, such as cases/hong-kong/fei-tsui-road");
    for (const Line& line : read_lines(folder + "/ranges.csv", {"key", "values", "source", "firmness"}))
        analysis.ranges.push_back(range_of(line));
    for (const Line& line :
         read_lines(folder + "/observed.csv", {"quantity", "low", "high", "source", "firmness"}))
        analysis.observed.push_back(observation_of(line));
    return analysis;
}

std::vector<PlannedRun> combinations(const BackAnalysis& analysis) {
    std::vector<PlannedRun> runs = {{"", "case.toml", {}}};
    for (const InputRange& range : analysis.ranges) {
        runs = varied(runs, range);
        if (runs.size() > most_combinations)
            throw InputError({.file = analysis.folder + "/ranges.csv", .line = 0, .key = {}, .value = {}},
                             fmt::format("asks for more than {} combinations", most_combinations),
                             "give fewer values");
    }
    return runs;
}

std::vector<long> run_back_analysis(const BackAnalysis& analysis, Store& store, const SuiteOptions& options) {
    SuiteOptions here = options;
    here.cases_folder = analysis.folder;
    const std::vector<PlannedRun> planned = combinations(analysis);
    const std::vector<long> run_ids = run_planned(analysis.name, planned, store, here);
    if (!run_ids.empty()) store_study(analysis, planned, run_ids, store);
    return run_ids;
}

ModelRange model_range(const std::vector<StoredRun>& runs, double Measures::*value) {
    ModelRange range{0, 0, 0, none, none};
    for (const StoredRun& run : runs) {
        ++range.runs;
        if (run.status == RunStatus::stable) ++range.stable;
        if (!is_result(run.status)) ++range.failed;
        const double number = run.measures.*value;
        if (!is_result(run.status) || !std::isfinite(number)) continue;
        range.low = std::isnan(range.low) ? number : std::min(range.low, number);
        range.high = std::isnan(range.high) ? number : std::max(range.high, number);
    }
    return range;
}

}  // namespace runout
