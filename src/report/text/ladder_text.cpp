#include "report/text/ladder_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

namespace runout {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// "1.234 +-0.012": the scatter of one lattice beside the mean.
std::string with_scatter(const RungValue& value, int digits) {
    if (value.lattices < 1 || !std::isfinite(value.mean)) return "-";
    if (value.lattices < 2) return fmt::format("{:.{}g}", value.mean, digits);
    return fmt::format("{:.{}g} +-{:.2g}", value.mean, digits, value.scatter);
}

std::string change(const RungValue& value, const RungSummary* before) {
    if (before == nullptr || before->results == 0) return "-";
    const double old = before->values[0].mean;
    if (!std::isfinite(old) || !(std::abs(value.mean) > 0)) return "-";
    return fmt::format("{:+.1f} %", 100.0 * (value.mean - old) / std::abs(value.mean));
}

constexpr const char* row_format =
    "{:>10} {:>9} {:>9} {:>7} {:>8} {:>8} {:>8} {:>6}  {:>16} {:>15} {:>16} {:>8}\n";

double iterations_per_step(const CostSample& cost) {
    return cost.steps > 0 ? cost.pressure_iterations / cost.steps : 0.0;
}

/// Against the finest rung, in percent of the run-out (or of sqrt(S) where that is more).
std::string difference_lines(const Ladder& ladder) {
    const Reference reference = reference_of(ladder);
    std::string text = fmt::format("{:>10} {:>22} {:>28}\n", "sqrt(S)/dl", "off the finest rung, %",
                                   "error bar of one run (95 %)");
    for (const RungSummary& rung : ladder.rungs) {
        if (rung.results == 0) continue;
        const double bar = error_bar(ladder.convergence[0], rung.spacing_m);
        text += fmt::format("{:>10g} {:>22.2f} {:>28}\n", rung.resolution,
                            100.0 * (rung.values[0].mean - reference.run_out_m) / reference.scale_m,
                            std::isfinite(bar)
                                ? fmt::format("+-{:.3g} m ({:.1f} %)", bar, 100.0 * bar / reference.scale_m)
                                : "-");
    }
    return text;
}

std::string verdict_lines(const Ladder& ladder) {
    std::string text;
    for (std::size_t q = 0; q < ladder_quantities.size(); ++q) {
        const Convergence& c = ladder.convergence[q];
        text += fmt::format("{}: {}; {}.\n", ladder_quantities[q].title, to_string(c.verdict),
                            meaning(c.verdict));
        if (!c.fit) continue;
        text += c.finest_three
                    ? fmt::format(
                          "    three finest rungs: order {:.2f}, Richardson value {:.4g}, GCI {:.2g} %\n",
                          c.finest_three->order, c.finest_three->extrapolated, 100.0 * c.finest_three->gci)
                    : std::string("    three finest rungs: no order, they do not move one way\n");
        text += fmt::format(
            "    least squares over the finest rungs: {}, value {:.4g}; one lattice scatters by {:.2g}\n",
            std::isfinite(c.fit->observed_order) ? fmt::format("order {:.2f}", c.fit->observed_order)
                                                 : std::string("no order"),
            c.fit->value, c.scatter);
        text += fmt::format("    one run on the finest rung: {:.4g} +-{:.2g} (95 %)\n", c.finest_value,
                            c.uncertainty);
    }
    return text;
}

std::string price_text(const Price& price) {
    const std::string cost =
        fmt::format("{} of CPU time, sqrt(S)/dl = {:g}{}", short_duration(price.cost.cpu_s), price.resolution,
                    price.beyond_ladder ? ", extrapolated" : "");
    if (price.met) return "costs " + cost;
    return fmt::format("cannot be had; the best is {:.2g} % for {}",
                       100.0 * price.error_m * price.target_share / price.target_m, cost);
}

std::string price_lines(std::span<const Price> prices) {
    std::string text;
    for (const Price& price : prices)
        text += fmt::format("  {:>4.3g} % {}\n", 100.0 * price.target_share, price_text(price));
    return text;
}

Vec2 in_percent(const MethodPoint& point) {
    return {point.cpu_s, 100.0 * point.error};
}

/// The point of the ladder with the resolution of `point`: there the knob has the scene's own setting, and
/// its line passes. Null for the ladder itself and for a scheme with a ladder of its own.
const MethodPoint* own_setting(const std::vector<MethodPoint>& points, const MethodPoint& point) {
    if (point.series == "spacing" || point.series == "run.friction") return nullptr;
    const auto found = std::ranges::find_if(points, [&](const MethodPoint& other) {
        return other.series == "spacing" && other.resolution == point.resolution;
    });
    return found == points.end() || !std::isfinite(found->error) ? nullptr : &*found;
}

Json json_of(const RungSummary& rung) {
    Json object = {{"resolution", rung.resolution},
                   {"particle_spacing_m", rung.spacing_m},
                   {"results", rung.results},
                   {"failed", rung.failed},
                   {"failure", rung.failure},
                   {"particles", rung.cost.particles},
                   {"steps", rung.cost.steps},
                   {"pressure_iterations_per_step", iterations_per_step(rung.cost)},
                   {"wall_s", rung.wall_s},
                   {"cpu_s", rung.cost.cpu_s},
                   {"peak_memory_mb", rung.cost.peak_memory_mb}};
    for (std::size_t q = 0; q < ladder_quantities.size(); ++q) {
        const bool has = rung.results > 0;
        object[ladder_quantities[q].name] = has ? number(rung.values[q].mean) : Json(nullptr);
        object[std::string(ladder_quantities[q].name) + "_scatter"] =
            has ? number(rung.values[q].scatter) : Json(nullptr);
    }
    return object;
}

Json json_of(const Convergence& c, const char* quantity) {
    Json object = {{"quantity", quantity},
                   {"verdict", to_string(c.verdict)},
                   {"finest_value", number(c.finest_value)},
                   {"uncertainty", number(c.uncertainty)},
                   {"lattice_scatter", number(c.scatter)}};
    object["observed_order"] = c.finest_three ? number(c.finest_three->order) : Json(nullptr);
    object["richardson_value"] = c.finest_three ? number(c.finest_three->extrapolated) : Json(nullptr);
    object["grid_convergence_index"] = c.finest_three ? number(c.finest_three->gci) : Json(nullptr);
    object["fitted_order"] = c.fit ? number(c.fit->observed_order) : Json(nullptr);
    object["fitted_value"] = c.fit ? number(c.fit->value) : Json(nullptr);
    return object;
}

Json json_of(const Price& price) {
    return {{"target_m", price.target_m},
            {"target_share", price.target_share},
            {"met", price.met},
            {"resolution", price.resolution},
            {"run_out_error_m", price.error_m},
            {"reach_angle_error_deg", number(price.reach_angle_error_deg)},
            {"expected_cpu_s", price.cost.cpu_s},
            {"beyond_ladder", price.beyond_ladder}};
}

Json json_of(const MethodPoint& point) {
    return {{"series", point.series},
            {"setting", point.setting},
            {"resolution", point.resolution},
            {"cpu_s", point.cpu_s},
            {"wall_s", point.wall_s},
            {"run_out_m", number(point.run_out_m)},
            {"error_share", number(point.error)},
            {"failure", point.failure}};
}

}  // namespace

std::string short_duration(double seconds) {
    if (seconds < 100) return fmt::format("{:.2g} s", seconds);
    if (seconds < 5400) return fmt::format("{:.0f} min", std::max(2.0, seconds / 60));
    return fmt::format("{:.2g} h", seconds / 3600);
}

std::string rung_table_head() {
    return fmt::format(row_format, "sqrt(S)/dl", "dl", "particles", "steps", "it./step", "wall", "CPU",
                       "memory", "run-out", "reach angle", "deposit height", "change") +
           fmt::format(row_format, "-", "m", "-", "-", "-", "s", "s", "MB", "m", "deg", "m", "of L_inf");
}

std::string rung_table_line(const RungSummary& rung, const RungSummary* before) {
    if (rung.results == 0)
        return fmt::format("{:>10g} {:>9.3g} {:>9.0f} failed: {}\n", rung.resolution, rung.spacing_m,
                           rung.cost.particles, rung.failure);
    std::string line =
        fmt::format(row_format, fmt::format("{:g}", rung.resolution), fmt::format("{:.3g}", rung.spacing_m),
                    fmt::format("{:.0f}", rung.cost.particles), fmt::format("{:.0f}", rung.cost.steps),
                    fmt::format("{:.1f}", iterations_per_step(rung.cost)), fmt::format("{:.3g}", rung.wall_s),
                    fmt::format("{:.3g}", rung.cost.cpu_s), fmt::format("{:.0f}", rung.cost.peak_memory_mb),
                    with_scatter(rung.values[0], 4), with_scatter(rung.values[1], 4),
                    with_scatter(rung.values[2], 4), change(rung.values[0], before));
    if (rung.failed > 0)
        line += fmt::format("           {} of {} lattices failed: {}\n", rung.failed,
                            rung.failed + rung.results, rung.failure);
    return line;
}

std::string ladder_summary(const Ladder& ladder, std::span<const Price> prices) {
    std::string text = fmt::format("The ladder ended because {}.\n\n", ladder.ended);
    text += difference_lines(ladder) + "\n" + verdict_lines(ladder);
    if (prices.empty()) return text;
    text += "\nWhat accuracy of the run-out costs on this scene and machine (one run, one thread):\n";
    text += price_lines(prices);
    if (const auto price = price_of(ladder, ladder.target))
        text += fmt::format("The target, {}, {}.\n", ladder.target.text(), price_text(*price));
    return text;
}

std::string method_table_head() {
    return fmt::format("{:<24} {:>16} {:>10} {:>9} {:>10} {:>10}\n", "knob", "setting", "sqrt(S)/dl",
                       "CPU, s", "run-out, m", "error, %");
}

std::string method_table_line(const MethodPoint& point) {
    const std::string start = fmt::format("{:<24} {:>16} {:>10g} {:>9.3g} ", point.series, point.setting,
                                          point.resolution, point.cpu_s);
    if (!point.failure.empty()) return start + "failed: " + point.failure + "\n";
    return start + fmt::format("{:>10.4g} {:>10.2f}\n", point.run_out_m, 100.0 * point.error);
}

Figure work_precision_figure(const std::string& name, const std::string& title,
                             const std::vector<MethodPoint>& points) {
    Figure figure;
    figure.name = name;
    figure.title = title;
    figure.x_label = "CPU time of one run, s";
    figure.y_label = "error of the run-out, %";
    figure.logarithmic_x = true;
    figure.logarithmic_y = true;
    std::vector<std::string> order;
    std::map<std::string, std::vector<Vec2>> curves;
    for (const MethodPoint& point : points) {
        if (!std::isfinite(point.error)) continue;
        std::vector<Vec2>& curve = curves[point.series];
        if (curve.empty()) {
            order.push_back(point.series);
            if (const MethodPoint* own = own_setting(points, point)) curve.push_back(in_percent(*own));
        }
        curve.push_back(in_percent(point));
    }
    for (const std::string& series : order) {
        std::vector<Vec2>& curve = curves[series];
        // The finest rung is what the others are held against: its error is its scatter alone.
        if (series == "spacing" && curve.size() > 1) curve.pop_back();
        std::ranges::stable_sort(curve, {}, [](const Vec2& at) { return at.x(); });
        figure.curves.push_back({.label = series, .style = Curve::Style::line, .points = curve});
    }
    return figure;
}

std::string ladder_json(const std::string& name, const Ladder& ladder, std::span<const Price> prices,
                        std::span<const MethodPoint> points) {
    Json object = {{"name", name}, {"target", ladder.target.text()}, {"ended", ladder.ended}};
    object["verdict"] = to_string(ladder.convergence[0].verdict);
    for (const RungSummary& rung : ladder.rungs) object["rungs"].push_back(json_of(rung));
    for (std::size_t q = 0; q < ladder_quantities.size(); ++q)
        object["quantities"].push_back(json_of(ladder.convergence[q], ladder_quantities[q].name));
    object["prices"] = Json::array();
    for (const Price& price : prices) object["prices"].push_back(json_of(price));
    object["methods"] = Json::array();
    for (const MethodPoint& point : points) object["methods"].push_back(json_of(point));
    return object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace runout
