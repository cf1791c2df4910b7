#include "report/text/estimate_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/units.h"

namespace runout {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array all_variables = {ChartVariable::slope_angle, ChartVariable::drop_height,
                                      ChartVariable::front_area, ChartVariable::friction_angle};

double of(const ChartPlace& place, ChartVariable variable) {
    return place[static_cast<std::size_t>(variable)];
}

struct Range {
    double low, high;
};

Range resolutions(const RunOutChart& chart) {
    const auto [low, high] = std::ranges::minmax(chart.points().points, {}, &ChartPoint::resolution);
    return {low.resolution, high.resolution};
}

/// "60 deg", or "8 to 12".
std::string range_text(Range range, const char* unit) {
    const std::string low = fmt::format("{:.3g}", range.low), high = fmt::format("{:.3g}", range.high);
    return (low == high ? low : low + " to " + high) + unit;
}

std::string place_text(const ChartPlace& place) {
    std::vector<std::string> parts;
    for (const ChartVariable variable : all_variables)
        parts.push_back(
            fmt::format("{} {:.4g}{}", text_of(variable).name, of(place, variable), text_of(variable).unit));
    return fmt::format("{}", fmt::join(parts, ", "));
}

struct Group {
    const char* key;
    const char* text;
    std::size_t count;
};

/// Runs that the chart is not made of.
std::array<Group, 6> groups_left_out(const ChartPoints& points) {
    return {{{"standing", "of sources that stand", points.standing},
             {"without_result", "without a result", points.without_result},
             {"former_front", "with the former definition of the front", points.former_fronts},
             {"other_effects", "with other effects", points.other_effects},
             {"other_discontinuity_angle", "with another discontinuity angle", points.other_planes},
             {"coarser", "coarser than another of the same question", points.coarser}}};
}

std::string left_out_text(const ChartPoints& points) {
    std::vector<std::string> parts;
    for (const Group& group : groups_left_out(points))
        if (group.count > 0) parts.push_back(fmt::format("{} {}", group.count, group.text));
    return parts.empty() ? "" : fmt::format("Left out: {}.\n", fmt::join(parts, ", "));
}

double reach_angle_deg(const Estimate& estimate, const EstimateScale& scale, double run_out) {
    const double length = std::sqrt(scale.source_area_m2);
    const double height = of(estimate.place, ChartVariable::drop_height) * length;
    const double behind = scale.head_behind_toe_m.value_or(
        height / std::tan(radians(of(estimate.place, ChartVariable::slope_angle))));
    return degrees(std::atan2(height, run_out * length + behind));
}

std::string scaled_text(const Estimate& estimate, const EstimateScale& scale) {
    const double length = std::sqrt(scale.source_area_m2);
    const double low = estimate.run_out - estimate.half_width_95;
    const double high = estimate.run_out + estimate.half_width_95;
    return fmt::format(
        "  {:.4g} m past the toe (95 %: {:.4g} to {:.4g} m), reach angle {:.1f} deg ({:.1f} to {:.1f} deg), "
        "for a source of {:.4g} m2\n",
        estimate.run_out * length, low * length, high * length,
        reach_angle_deg(estimate, scale, estimate.run_out), reach_angle_deg(estimate, scale, high),
        reach_angle_deg(estimate, scale, low), scale.source_area_m2);
}

std::string surface_text(const RunOutChart& chart) {
    std::vector<std::string> varying, fixed;
    for (const ChartVariable variable : all_variables) {
        const std::string range =
            range_text({chart.lowest(variable), chart.highest(variable)}, text_of(variable).unit);
        (chart.varies(variable) ? varying : fixed)
            .push_back(fmt::format("{} {}", text_of(variable).name, range));
    }
    std::string text = fmt::format(
        "From {} settled runs, sqrt(S)/dl {}: a polynomial of degree {} with {} terms in {}.\n",
        chart.points().points.size(), range_text(resolutions(chart), ""), chart.surface().degree(),
        chart.surface().terms(), varying.empty() ? "nothing" : fmt::format("{}", fmt::join(varying, ", ")));
    if (!fixed.empty())
        text += fmt::format("The same in all runs, and no variable: {}.\n", fmt::join(fixed, ", "));
    return text + left_out_text(chart.points());
}

std::string error_text(const RunOutChart& chart, const Estimate& estimate) {
    std::string text =
        fmt::format("Each run left out in turn is missed by {:.2g} (rms)", chart.left_out_error());
    for (const ChartVariable variable : estimate.between_values_of)
        text += fmt::format(
            "; the {} lies between values of the runs, so all runs with one value were left "
            "out together",
            text_of(variable).name);
    return text +
           ". The interval is for one run at the resolution of these: the numerical error that they "
           "have in common is not in it.\n";
}

Json interval(double middle, double half_width) {
    return Json::array({middle - half_width, middle + half_width});
}

Json place_json(const ChartPlace& place) {
    Json object = Json::object();
    for (const ChartVariable variable : all_variables) object[text_of(variable).key] = of(place, variable);
    return object;
}

}  // namespace

std::string estimate_text(const RunOutChart& chart, const Estimate& estimate,
                          const std::optional<EstimateScale>& scale) {
    const double run_out = estimate.run_out;
    std::string text =
        fmt::format("L/sqrt(S) = {:.3f} (68 %: {:.3f} to {:.3f}; 95 %: {:.3f} to {:.3f})\n", run_out,
                    run_out - estimate.half_width_68, run_out + estimate.half_width_68,
                    run_out - estimate.half_width_95, run_out + estimate.half_width_95);
    if (scale) text += scaled_text(estimate, *scale);
    text += fmt::format("at {}\n\n", place_text(estimate.place));
    text += surface_text(chart) + error_text(chart, estimate);
    return text + fmt::format("Nearest run: {}, L/sqrt(S) = {:.3f} at {}.\n", estimate.nearest.run_id,
                              estimate.nearest.run_out, place_text(estimate.nearest.place));
}

std::string estimate_json(const RunOutChart& chart, const Estimate& estimate,
                          const std::optional<EstimateScale>& scale) {
    const double run_out = estimate.run_out;
    Json object = {{"run_out_normalised", run_out},
                   {"interval_68", interval(run_out, estimate.half_width_68)},
                   {"interval_95", interval(run_out, estimate.half_width_95)},
                   {"source_area_m2", nullptr},
                   {"run_out_m", nullptr},
                   {"run_out_interval_95_m", nullptr},
                   {"reach_angle_deg", nullptr}};
    if (scale) {
        const double length = std::sqrt(scale->source_area_m2);
        object["source_area_m2"] = scale->source_area_m2;
        object["run_out_m"] = run_out * length;
        object["run_out_interval_95_m"] = interval(run_out * length, estimate.half_width_95 * length);
        object["reach_angle_deg"] = reach_angle_deg(estimate, *scale, run_out);
    }
    object["at"] = place_json(estimate.place);
    object["varied"] = Json::object();
    for (const ChartVariable variable : chart.varying())
        object["varied"][text_of(variable).key] = {chart.lowest(variable), chart.highest(variable)};
    object["between_values_of"] = Json::array();
    for (const ChartVariable variable : estimate.between_values_of)
        object["between_values_of"].push_back(text_of(variable).key);
    object["runs"] = chart.points().points.size();
    object["left_out"] = Json::object();
    for (const Group& group : groups_left_out(chart.points())) object["left_out"][group.key] = group.count;
    object["resolution"] = {resolutions(chart).low, resolutions(chart).high};
    object["degree"] = chart.surface().degree();
    object["terms"] = chart.surface().terms();
    object["left_out_error_rms"] = chart.left_out_error();
    object["nearest_run"] = {{"run_id", estimate.nearest.run_id},
                             {"run_out_normalised", estimate.nearest.run_out},
                             {"at", place_json(estimate.nearest.place)}};
    return object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string held_out_text(const HeldOutCheck& check) {
    const auto percent = [&](std::size_t count) {
        return 100 * static_cast<double>(count) / static_cast<double>(check.estimated);
    };
    return fmt::format(
        "Every fifth run held out, in five turns: {} estimated from the others, {} refused as outside of "
        "them.\n"
        "Missed by {:.3f} (rms of L/sqrt(S)); leaving one run out at a time says {:.3f}.\n"
        "{:.0f} % lie within their interval of 68 %, {:.0f} % within that of 95 %.\n",
        check.estimated, check.refused, check.error_rms, check.left_out_error_rms, percent(check.within_68),
        percent(check.within_95));
}

std::string held_out_json(const HeldOutCheck& check) {
    const Json object = {{"estimated", check.estimated}, {"refused", check.refused},
                         {"within_68", check.within_68}, {"within_95", check.within_95},
                         {"error_rms", check.error_rms}, {"left_out_error_rms", check.left_out_error_rms}};
    return object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace runout
