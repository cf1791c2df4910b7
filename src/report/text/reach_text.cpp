#include "report/text/reach_text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/printable.h"
#include "report/text/place_doubt.h"
#include "report/text/table.h"

namespace runout {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array asked_probabilities = {0.5, 0.16, 0.02};

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

std::string text_of(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<ReachDistance> quantiles(const std::vector<ReachSample>& samples) {
    std::vector<ReachDistance> all;
    if (samples.empty()) return all;
    for (const double probability : asked_probabilities)
        all.push_back(distance_reached(samples, probability));
    return all;
}

std::string name_of(const ReachRow& row) {
    return fmt::format("run {} ({})", row.run_id,
                       printable(row.name.empty() ? row.section_origin : row.name));
}

std::string place_of(const ReachRow& row, double chainage_m) {
    return fmt::format("Chainage {:.6g} m, {:.4g} m {} the toe, in {}", chainage_m, std::abs(row.from_toe_m),
                       row.from_toe_m < 0 ? "before" : "past", name_of(row));
}

/// "0.25 (0.21 to 0.3)"
std::string with_errors(const ReachDistance& value) {
    const auto text = [](double v) { return std::isfinite(v) ? fmt::format("{:.3g}", v) : std::string("-"); };
    return fmt::format("{} ({} to {})", text(value.distance_m), text(value.low_m), text(value.high_m));
}

std::string quantile_line(const char* what, const char* unit, const std::vector<ReachDistance>& values) {
    std::string text = fmt::format("{}, {}, exceeded with", what, unit);
    for (const ReachDistance& value : values)
        text += fmt::format(" {:g} %: {};", 100 * value.probability, with_errors(value));
    text.back() = '\n';
    return text;
}

/// Empty where the place is not reached, or no class is exceeded.
std::string intensity_at(const ReachRow& row, const Intensities& classes) {
    if (!row.reached() || !row.has_envelope) return {};
    return intensity_of(classes.classes, row.greatest_thickness_m, row.greatest_speed_m_s);
}

Json quantile_json(const std::vector<ReachDistance>& values) {
    Json array = Json::array();
    for (const ReachDistance& value : values)
        array.push_back({{"probability", value.probability},
                         {"value", number(value.distance_m)},
                         {"low_95", number(value.low_m)},
                         {"high_95", number(value.high_m)}});
    return array;
}

}  // namespace

ReachSummary summary_of(const std::vector<ReachRow>& rows) {
    ReachSummary summary;
    std::vector<ReachSample> reached, thickness, speed;
    for (const ReachRow& row : rows) {
        if (!row.is_result) {
            ++summary.without_result;
            continue;
        }
        ++summary.runs;
        if (row.front_definition != current_front_definition) ++summary.former_fronts;
        if (place_doubt(row).within_error()) ++summary.within_error;
        reached.push_back({row.reached() ? 1.0 : 0.0, 1});
        if (!row.has_envelope) {
            ++summary.without_envelope;
            continue;
        }
        thickness.push_back({row.greatest_thickness_m, 1});
        speed.push_back({row.greatest_speed_m_s, 1});
    }
    if (!reached.empty()) summary.reached = probability_of_reaching(reached, 1.0);
    summary.thickness_m = quantiles(thickness);
    summary.speed_m_s = quantiles(speed);
    return summary;
}

std::string reach_text(const ReachRow& row, double chainage_m, const Intensities& classes) {
    std::string text = place_of(row, chainage_m);
    if (!row.is_result) return text + fmt::format(": no result, as the run ended as {}.\n", row.status);
    const PlaceDoubt doubt = place_doubt(row);
    text += ": " + doubt.sentence();
    if (row.reached() && std::isfinite(row.arrival_time_s))
        text += fmt::format("{}after {:.3g} s{}", doubt.within_error() ? "; " : " ", row.arrival_time_s,
                            row.arrival_is_bound ? " or later" : "");
    const double front = std::isfinite(row.farthest_front_m) ? row.farthest_front_m : row.run_out_m;
    if (!row.reached()) text += fmt::format("; the front comes {:.4g} m past the toe at most", front);
    text += ".\n";
    if (row.front_definition != current_front_definition) text += former_front_sentence() + "\n";
    if (!row.has_envelope)
        return text +
               "The run has no envelope (it is older than database 10): thickness and speed there are not "
               "known.\n";
    text += fmt::format(
        "Up to {:.3g} m thick and {:.3g} m/s where as thick as the front ({:.3g} m): kinetic head {:.3g} m, "
        "momentum flux {:.3g} kN/m.\n",
        row.greatest_thickness_m, row.greatest_speed_m_s, row.front_thickness_m, row.greatest_kinetic_head_m,
        1e-3 * row.greatest_momentum_flux_n_m);
    text += fmt::format("At the end {:.3g} m thick; {:.4g} m2 have passed.\n", row.final_thickness_m,
                        row.passed_area_m2);
    const std::string intensity = intensity_at(row, classes);
    return text + fmt::format("Intensity: {}. {}\n", intensity.empty() ? "none" : printable(intensity),
                              classes.origin);
}

std::string reach_text(const ReachSummary& summary, double chainage_m) {
    std::string text = fmt::format("Chainage {:.6g} m, {} results: ", chainage_m, summary.runs);
    if (summary.runs == 0) return text + "nothing can be said.\n";
    text += fmt::format("reached with a probability of {:.3g} +-{:.2g} (one standard error).\n",
                        summary.reached.value, summary.reached.standard_error);
    if (!summary.thickness_m.empty()) {
        text += quantile_line("Greatest thickness", "m", summary.thickness_m);
        text += quantile_line("Greatest speed", "m/s", summary.speed_m_s);
        text += "In brackets: 95 % of what other samples of as many scenarios would say.\n";
    }
    if (summary.within_error > 0)
        text +=
            fmt::format("In {} of them the place is within the error of the front.\n", summary.within_error);
    if (summary.without_result > 0)
        text += fmt::format("{} runs gave no result and are left out.\n", summary.without_result);
    if (summary.without_envelope > 0)
        text +=
            fmt::format("{} runs have no envelope (older than database 10): not in thickness and speed.\n",
                        summary.without_envelope);
    if (summary.former_fronts > 0)
        text += fmt::format("{} of them: {}\n", summary.former_fronts, former_front_sentence());
    return text;
}

std::string reach_json(const ReachRow& row, double chainage_m, const Intensities& classes) {
    Json object = {{"chainage_m", chainage_m},
                   {"from_toe_m", row.from_toe_m},
                   {"run_id", row.run_id},
                   {"name", row.name},
                   {"status", row.status},
                   {"front_definition", row.front_definition},
                   {"front_thickness_m", number(row.front_thickness_m)},
                   {"reached", row.is_result ? Json(row.reached()) : Json(nullptr)},
                   {"within_error", row.is_result ? Json(place_doubt(row).within_error()) : Json(nullptr)}};
    for (const EnvelopeColumn& column : envelope_columns())
        object[column.name] = row.is_result ? number(row.*column.value) : Json(nullptr);
    object["arrival_is_bound"] = row.arrival_is_bound;
    const std::string intensity = row.is_result ? intensity_at(row, classes) : "";
    object["intensity"] = intensity.empty() ? Json(nullptr) : Json(intensity);
    object["intensity_classes"] = classes.origin;
    return text_of(object);
}

std::string reach_json(const ReachSummary& summary, double chainage_m) {
    return text_of({{"chainage_m", chainage_m},
                    {"results", summary.runs},
                    {"without_result", summary.without_result},
                    {"without_envelope", summary.without_envelope},
                    {"former_fronts", summary.former_fronts},
                    {"results_within_error", summary.within_error},
                    {"probability_of_reaching", summary.runs > 0 ? number(summary.reached.value) : nullptr},
                    {"standard_error", summary.runs > 0 ? number(summary.reached.standard_error) : nullptr},
                    {"greatest_thickness_m", quantile_json(summary.thickness_m)},
                    {"greatest_speed_m_s", quantile_json(summary.speed_m_s)}});
}

}  // namespace runout
