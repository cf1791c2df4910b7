#include "accuracy/survey.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

#include "accuracy/study.h"
#include "accuracy/survey_csv.h"
#include "core/csv_cell.h"
#include "core/input_error.h"
#include "core/machine.h"
#include "core/version.h"

namespace runout {
namespace {

/// A number of a rung and its column in the file.
struct Column {
    const char* name;
    double& (*value)(RungSummary&);
};

constexpr std::array<Column, 15> columns = {{
    {"resolution", [](RungSummary& r) -> double& { return r.resolution; }},
    {"particle_spacing_m", [](RungSummary& r) -> double& { return r.spacing_m; }},
    {"run_out_m", [](RungSummary& r) -> double& { return r.values[0].mean; }},
    {"run_out_scatter_m", [](RungSummary& r) -> double& { return r.values[0].scatter; }},
    {"reach_angle_deg", [](RungSummary& r) -> double& { return r.values[1].mean; }},
    {"reach_angle_scatter_deg", [](RungSummary& r) -> double& { return r.values[1].scatter; }},
    {"deposit_height_m", [](RungSummary& r) -> double& { return r.values[2].mean; }},
    {"deposit_height_scatter_m", [](RungSummary& r) -> double& { return r.values[2].scatter; }},
    {"particles", [](RungSummary& r) -> double& { return r.cost.particles; }},
    {"steps", [](RungSummary& r) -> double& { return r.cost.steps; }},
    {"pressure_iterations", [](RungSummary& r) -> double& { return r.cost.pressure_iterations; }},
    {"cpu_s", [](RungSummary& r) -> double& { return r.cost.cpu_s; }},
    {"wall_s", [](RungSummary& r) -> double& { return r.wall_s; }},
    {"peak_memory_mb", [](RungSummary& r) -> double& { return r.cost.peak_memory_mb; }},
    {"cost_resolution", [](RungSummary& r) -> double& { return r.cost.resolution; }},
}};

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
    return fields;
}

double number_of(const std::string& text, const InputPlace& place) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        throw InputError(place, "is not a number", "make the file with runout accuracy --survey");
    return value;
}

RungSummary rung_of(const std::vector<std::string>& fields, InputPlace place) {
    if (fields.size() != columns.size() + 2)
        throw InputError(place, fmt::format("has {} fields", fields.size()),
                         fmt::format("valid: {}", columns.size() + 2));
    RungSummary rung;
    place.key = "lattices";
    place.value = fields[1];
    rung.results = static_cast<int>(number_of(fields[1], place));
    for (std::size_t i = 0; i < columns.size(); ++i) {
        place.key = columns[i].name;
        place.value = fields[i + 2];
        columns[i].value(rung) = number_of(fields[i + 2], place);
    }
    for (RungValue& value : rung.values) {
        value.spacing = rung.spacing_m;
        value.lattices = rung.results;
    }
    return rung;
}

constexpr std::size_t least_rungs = 3;

/// Those with a scatter and a reach angle.
std::vector<RungSummary> whole_rungs(const Ladder& ladder) {
    std::vector<RungSummary> rungs;
    for (const RungSummary& rung : ladder.rungs)
        if (rung.results > 1 && std::isfinite(rung.values[1].mean)) rungs.push_back(rung);
    return rungs;
}

}  // namespace

std::vector<SurveyedScene> parse_survey(const std::string& text, const std::string& path) {
    std::vector<SurveyedScene> survey;
    std::istringstream stream(text);
    InputPlace place{.file = path, .line = 0, .key = {}, .value = {}};
    bool in_header = true;
    for (std::string line; std::getline(stream, line);) {
        ++place.line;
        if (line.empty() || line.front() == '#') continue;
        if (std::exchange(in_header, false)) continue;
        const std::vector<std::string> fields = fields_of(line);
        const RungSummary rung = rung_of(fields, place);
        if (survey.empty() || survey.back().name != fields.front()) survey.push_back({fields.front(), {}});
        survey.back().rungs.push_back(rung);
    }
    return survey;
}

const std::vector<SurveyedScene>& shipped_survey() {
    static const std::vector<SurveyedScene> survey = parse_survey(survey_csv, "src/accuracy/ladders.csv");
    return survey;
}

std::vector<SurveyedScene> without(const std::vector<SurveyedScene>& survey, const std::string& name) {
    std::vector<SurveyedScene> rest = survey;
    std::erase_if(rest, [&](const SurveyedScene& scene) { return scene.name == name; });
    return rest;
}

std::string survey_text(const Store& store) {
    std::string text = fmt::format(
        "# What refinement changes and costs: means over lattices. Made by\n"
        "#   runout accuracy CASE --db DB   or   runout accuracy --slopes N --seed S --db DB\n"
        "# and   runout accuracy --db DB --survey FILE   with Runout {} (revision {}) on {}, one thread.\n"
        "scene,lattices",
        program_version(), program_revision(), machine_description());
    for (const Column& column : columns) text += fmt::format(",{}", column.name);
    text += "\n";
    for (const AccuracyStudy& study : read_studies(store)) {
        const std::vector<RungSummary> rungs = whole_rungs(study.ladder);
        if (rungs.size() < least_rungs || !(rungs.back().values[0].mean > 0)) continue;
        for (RungSummary rung : rungs) {
            text += fmt::format("{},{}", csv_cell(study.name), rung.results);
            for (const Column& column : columns) text += fmt::format(",{:.6g}", column.value(rung));
            text += "\n";
        }
    }
    return text;
}

std::vector<CostSample> costs_of(const std::vector<SurveyedScene>& survey) {
    std::vector<CostSample> samples;
    for (const SurveyedScene& scene : survey)
        for (const RungSummary& rung : scene.rungs) samples.push_back(rung.cost);
    return samples;
}

}  // namespace runout
