#include "estimate/run_out_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "estimate/convex_hull.h"

namespace runout {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// A variable with few values, each in many runs, was laid out as a grid.
constexpr std::size_t most_grid_values = 12;
constexpr std::size_t least_runs_a_value = 5;

constexpr double hull_tolerance = 1e-6;  // of half the range of a variable

constexpr std::array all_variables = {ChartVariable::slope_angle, ChartVariable::drop_height,
                                      ChartVariable::front_area, ChartVariable::friction_angle};

double of(const ChartPlace& place, ChartVariable variable) {
    return place[static_cast<std::size_t>(variable)];
}

std::string said(ChartVariable variable, double value) {
    return fmt::format("{:.4g}{}", value, text_of(variable).unit);
}

void check_count(const ChartPoints& points, const std::string& origin) {
    if (points.points.size() >= RunOutChart::fewest_runs) return;
    throw InputError(
        {.file = origin, .line = 0, .key = {}, .value = {}},
        fmt::format("holds {} settled run{} that may be used", points.points.size(),
                    points.points.size() == 1 ? "" : "s"),
        fmt::format("a chart needs {}; make them with `runout sweep`", RunOutChart::fewest_runs));
}

}  // namespace

double error_quantile(std::vector<double> errors, double share) {
    for (double& error : errors) error = std::abs(error);
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(errors.size() + 1)));
    if (rank > errors.size()) return std::numeric_limits<double>::infinity();
    const auto place = errors.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::ranges::nth_element(errors, place);
    return *place;
}

RunOutChart::RunOutChart(ChartPoints points, std::string origin)
    : points_((check_count(points, origin), std::move(points))),
      origin_(std::move(origin)),
      axes_{axis_of(all_variables[0]), axis_of(all_variables[1]), axis_of(all_variables[2]),
            axis_of(all_variables[3])},
      data_(surface_data()),
      surface_(best_polynomial(data_, highest_powers())) {}

RunOutChart::Axis RunOutChart::axis_of(ChartVariable variable) const {
    std::vector<double> sorted;
    for (const ChartPoint& point : points_.points) sorted.push_back(of(point.place, variable));
    std::ranges::sort(sorted);
    Axis axis{.low = sorted.front(), .high = sorted.back(), .values = {}};
    for (const double value : sorted)
        if (axis.values.empty() || value - axis.values.back() > text_of(variable).least_difference)
            axis.values.push_back(value);
    axis.highest_power = static_cast<int>(std::min<std::size_t>(axis.values.size() - 1, highest_degree));
    const bool grid = axis.values.size() <= most_grid_values &&
                      axis.values.size() * least_runs_a_value <= points_.points.size();
    if (!grid) axis.values.clear();
    return axis;
}

bool RunOutChart::varies(ChartVariable variable) const {
    return axis(variable).highest_power > 0;
}

std::vector<ChartVariable> RunOutChart::varying() const {
    std::vector<ChartVariable> found;
    for (const ChartVariable variable : all_variables)
        if (varies(variable)) found.push_back(variable);
    return found;
}

VectorXd RunOutChart::scaled(const ChartPlace& place) const {
    const std::vector<ChartVariable> variables = varying();
    VectorXd coordinates(static_cast<Index>(variables.size()));
    for (std::size_t k = 0; k < variables.size(); ++k) {
        const Axis& along = axis(variables[k]);
        coordinates[static_cast<Index>(k)] =
            2 * (of(place, variables[k]) - along.low) / (along.high - along.low) - 1;
    }
    return coordinates;
}

SurfaceData RunOutChart::surface_data() const {
    const auto count = static_cast<Index>(points_.points.size());
    SurfaceData data{{count, static_cast<Index>(varying().size())}, VectorXd(count)};
    for (Index i = 0; i < count; ++i) {
        const ChartPoint& point = points_.points[static_cast<std::size_t>(i)];
        data.at.row(i) = scaled(point.place).transpose();
        data.values[i] = point.run_out;
    }
    return data;
}

std::vector<int> RunOutChart::highest_powers() const {
    std::vector<int> powers;
    for (const ChartVariable variable : varying()) powers.push_back(axis(variable).highest_power);
    return powers;
}

double RunOutChart::left_out_error() const {
    return std::sqrt(surface_.left_out_errors().squaredNorm() / static_cast<double>(points_.points.size()));
}

// ---- questions

InputPlace RunOutChart::input_place(ChartVariable variable, double value) const {
    return {.file = origin_, .line = 0, .key = text_of(variable).name, .value = fmt::format("{:.4g}", value)};
}

ChartPlace RunOutChart::checked_place(const ChartPlace& asked) const {
    ChartPlace place = asked;
    for (const ChartVariable variable : all_variables) {
        double& value = place[static_cast<std::size_t>(variable)];
        const double low = lowest(variable), high = highest(variable);
        const double middle = (low + high) / 2;
        const double slack = text_of(variable).least_difference;
        if (std::isnan(value) && varies(variable))
            throw InputError({.file = origin_, .line = 0, .key = text_of(variable).name, .value = {}},
                             "is not given, and varies in the runs",
                             fmt::format("give {} to {}", said(variable, low), said(variable, high)));
        if (std::isnan(value)) value = middle;
        if (!varies(variable) && std::abs(value - middle) > slack + (high - low) / 2)
            throw InputError(input_place(variable, value),
                             fmt::format("cannot be estimated: all {} runs have {}", points_.points.size(),
                                         said(variable, middle)),
                             "run it, or make a study that varies it");
        if (varies(variable) && (value < low || value > high))
            throw InputError(input_place(variable, value),
                             fmt::format("lies outside the runs, which have {} to {}", said(variable, low),
                                         said(variable, high)),
                             "run it, or make a study that goes so far");
    }
    return place;
}

const ChartPoint& RunOutChart::nearest_point(const ChartPlace& place) const {
    Index nearest = 0;
    (data_.at.rowwise() - scaled(place).transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    return points_.points[static_cast<std::size_t>(nearest)];
}

void RunOutChart::check_inside(const ChartPlace& place) const {
    if (in_convex_hull(data_.at, scaled(place), hull_tolerance)) return;
    const ChartPoint& nearest = nearest_point(place);
    std::string asked, there;
    for (const ChartVariable variable : varying()) {
        const char* comma = asked.empty() ? "" : ", ";
        asked += fmt::format("{}{} {}", comma, text_of(variable).name, said(variable, of(place, variable)));
        there += fmt::format("{}{} {}", comma, text_of(variable).name,
                             said(variable, of(nearest.place, variable)));
    }
    throw InputError(
        {.file = origin_, .line = 0, .key = {}, .value = {}},
        fmt::format("has no runs around {}: the nearest, run {}, has {}", asked, nearest.run_id, there),
        "run it, or make a study that goes so far");
}

std::vector<ChartVariable> RunOutChart::between_values(const ChartPlace& place) const {
    std::vector<ChartVariable> between;
    for (const ChartVariable variable : varying()) {
        const auto& values = axis(variable).values;
        const bool on_one = std::ranges::any_of(values, [&](double value) {
            return std::abs(value - of(place, variable)) <= text_of(variable).least_difference;
        });
        if (values.empty() || on_one) continue;
        if (values.size() == 2)
            throw InputError(input_place(variable, of(place, variable)),
                             fmt::format("lies between {} and {}, and the runs have no other value",
                                         said(variable, values[0]), said(variable, values[1])),
                             "make a study with three values or more");
        between.push_back(variable);
    }
    return between;
}

/// Errors at the runs with one of the inner values, of the surface through the runs with all other values:
/// what there is to tell of a place between the values.
std::vector<double> RunOutChart::errors_without_values(ChartVariable variable) const {
    const auto& values = axis(variable).values;
    std::vector<int> powers = highest_powers();
    for (std::size_t k = 0; k < powers.size(); ++k)
        if (varying()[k] == variable)
            powers[k] = std::min<int>(powers[k], static_cast<int>(values.size()) - 2);
    std::vector<double> errors;
    for (std::size_t v = 1; v + 1 < values.size(); ++v) {
        std::vector<Index> kept, left_out;
        for (std::size_t i = 0; i < points_.points.size(); ++i) {
            const double away = of(points_.points[i].place, variable) - values[v];
            const bool is_there = away >= 0 && away <= text_of(variable).least_difference;
            (is_there ? left_out : kept).push_back(static_cast<Index>(i));
        }
        const SurfaceData rest{data_.at(kept, Eigen::all), data_.values(kept)};
        const PolynomialFit fit(rest, surface_.degree(), powers);
        for (const Index i : left_out)
            errors.push_back(data_.values[i] - fit.value(data_.at.row(i).transpose()));
    }
    return errors;
}

/// A left-out error has the variance s^2 / (1 - h_ii), that of a run at another place s^2 (1 + h): here those
/// of variance s^2.
std::vector<double> RunOutChart::even_errors() const {
    std::vector<double> errors;
    for (Index i = 0; i < surface_.leverages().size(); ++i) {
        const double error = surface_.left_out_errors()[i];
        errors.push_back(std::isfinite(error) ? error * std::sqrt(1 - surface_.leverages()[i]) : error);
    }
    return errors;
}

Estimate RunOutChart::estimate(const ChartQuestion& question) const {
    Estimate estimate;
    estimate.place = checked_place(question.place);
    check_inside(estimate.place);
    const VectorXd place = scaled(estimate.place);
    estimate.run_out = surface_.value(place);
    estimate.nearest = nearest_point(estimate.place);
    const double spread = std::sqrt(1 + surface_.leverage(place));
    const std::vector<double> errors = even_errors();
    estimate.half_width_68 = spread * error_quantile(errors, 0.68);
    estimate.half_width_95 = spread * error_quantile(errors, 0.95);
    estimate.between_values_of = between_values(estimate.place);
    for (const ChartVariable variable : estimate.between_values_of) {
        const std::vector<double> between = errors_without_values(variable);
        estimate.half_width_68 = std::max(estimate.half_width_68, error_quantile(between, 0.68));
        estimate.half_width_95 = std::max(estimate.half_width_95, error_quantile(between, 0.95));
    }
    return estimate;
}

}  // namespace runout
