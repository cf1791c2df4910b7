#include "report/text/back_analysis_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "report/page/html.h"

namespace runout {
namespace {

constexpr const char* what_is_left_out =
    "The model is a dry, plane-strain slice of a failure that was wet and three-dimensional. Water in the "
    "soil, which set it going and kept its strength low, is only as far in these numbers as the friction "
    "angle stands "
    "for it, and sideways spreading not at all. That the observed value lies within the range shows that the "
    "inputs "
    "can be chosen so, not that the model predicts it.";

std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{:.3g}", value + 0.0) : "";
}

std::string span(double low, double high) {
    if (!std::isfinite(low) && !std::isfinite(high)) return "not known";
    if (low == high || !std::isfinite(high)) return number(low);
    if (!std::isfinite(low)) return "up to " + number(high);
    return number(low) + " to " + number(high);
}

std::string with_unit(const std::string& column) {
    const ColumnWords words = column_words(column);
    return words.unit.empty() ? words.words : words.words + ", " + words.unit;
}

const Observation* observed(const BackAnalysis& analysis, const std::string& quantity) {
    const auto found = std::ranges::find(analysis.observed, quantity, &Observation::quantity);
    return found == analysis.observed.end() ? nullptr : &*found;
}

std::string origin(const Observation& seen) {
    return seen.firmness.empty() ? seen.source : fmt::format("{} ({})", seen.source, seen.firmness);
}

std::string model_row(const BackAnalysis& analysis, const std::vector<StoredRun>& runs,
                      const MeasureField& field) {
    const ModelRange range = model_range(runs, field.value);
    const Observation* seen = observed(analysis, field.name);
    return fmt::format("| {} | {} | {} | {} |\n", with_unit(field.name),
                       std::isfinite(range.low) ? span(range.low, range.high) : "-",
                       seen != nullptr ? span(seen->low, seen->high) : "not known",
                       seen != nullptr ? origin(*seen) : "");
}

bool is_measure(const std::string& quantity) {
    return std::ranges::any_of(measure_fields(),
                               [&](const MeasureField& field) { return quantity == field.name; });
}

bool is_shown(const BackAnalysis& analysis, const std::string& name) {
    return name == "run_out_m" || name == "run_out_normalised" || name == "reach_angle_deg" ||
           observed(analysis, name) != nullptr;
}

}  // namespace

std::string back_analysis_text(const BackAnalysis& analysis, const std::vector<StoredRun>& runs) {
    std::string text = fmt::format(
        "{}: what was varied\n\n| input | values | source | firmness |\n|---|---|---|---|\n", analysis.name);
    for (const InputRange& range : analysis.ranges)
        text += fmt::format("| {} | {} | {} | {} |\n", range.key, fmt::join(range.values, ", "), range.source,
                            range.firmness);
    const ModelRange all = model_range(runs, &Measures::run_out_m);
    text += fmt::format(
        "\n{} combinations: {} ran out, in {} the source stands, {} ended without a result.\n\n"
        "| quantity | model | observed | source of the observation |\n|---|---|---|---|\n",
        all.runs, all.runs - all.stable - all.failed, all.stable, all.failed);
    for (const MeasureField& field : measure_fields())
        if (is_shown(analysis, field.name)) text += model_row(analysis, runs, field);
    for (const Observation& seen : analysis.observed)
        if (!is_measure(seen.quantity))
            text += fmt::format("| {} | - | {} | {} |\n", with_unit(seen.quantity), span(seen.low, seen.high),
                                origin(seen));
    return text + "\n" + what_is_left_out + "\n";
}

}  // namespace runout
