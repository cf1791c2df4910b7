#include "report/compare/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"

namespace runout {
namespace {

/// The run-out surface, from the toe on.
Polyline apron_of(const SectionGeometry& geometry) {
    const Polyline& ground = geometry.profile.ground;
    const std::size_t toe = std::min(geometry.profile.toe, ground.size());
    return {ground.begin() + static_cast<std::ptrdiff_t>(toe), ground.end()};
}

/// The point of a line at some length from its start, or its end.
Vec2 point_along(const Polyline& line, double length) {
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double step = (line[i] - line[i - 1]).norm();
        if (step >= length && step > 0) return line[i - 1] + (line[i] - line[i - 1]) * (length / step);
        length -= step;
    }
    return line.empty() ? Vec2(0, 0) : line.back();
}

/// Where the run's front came to rest; before database 10 the run-out was a length along the ground.
Vec2 margin_of(const RunData& run) {
    const Polyline apron = apron_of(run.geometry);
    const double run_out = run.run.measures.run_out_m;
    if (run.run.front_definition != current_front_definition) return point_along(apron, run_out);
    for (std::size_t i = 1; i < apron.size(); ++i) {
        const Vec2 step = apron[i] - apron[i - 1];
        if (step.x() > 0 && apron[i].x() >= run_out)
            return apron[i - 1] + step * ((run_out - apron[i - 1].x()) / step.x());
    }
    return apron.empty() ? Vec2(0, 0) : apron.back();
}

}  // namespace

double run_out_at(const SectionGeometry& geometry, double ratio) {
    const Vec2& head = geometry.head;
    const Polyline apron = apron_of(geometry);
    const auto above = [&](const Vec2& point) {
        return head.y() - ratio * (point.x() - head.x()) - point.y();
    };
    if (apron.empty() || above(apron.front()) <= 0) return 0;
    for (std::size_t i = 1; i < apron.size(); ++i) {
        const double before = above(apron[i - 1]), after = above(apron[i]);
        if (after <= 0)
            return apron[i - 1].x() + (apron[i].x() - apron[i - 1].x()) * before / (before - after);
    }
    return std::numeric_limits<double>::quiet_NaN();
}

std::string comparison_refusal(const RunData& run) {
    if (!is_result(run.run.status))
        return fmt::format("it ended as {} and is no result", to_string(run.run.status));
    if (run.run.status == RunStatus::stable) return "the source stands, and nothing ran out";
    if (!(run.run.measures.run_out_m > 0)) return "its debris does not pass the toe of the cut";
    return {};
}

Comparison compare_run(const RunData& run, double width) {
    Comparison comparison;
    const Measures& measures = run.run.measures;
    const Vec2 margin = margin_of(run);
    comparison.width = width;
    comparison.run_out_m = margin.x();
    comparison.angle_deg = measures.reach_angle_deg;
    comparison.slide.drop = run.geometry.head.y() - margin.y();
    comparison.travel_length = margin.x() - run.geometry.head.x();
    comparison.slide.slope_angle = radians(run.run.slope_angle_deg);
    comparison.slide.volume = measures.source_area_m2 * width;
    comparison.slide.apron_angle = margin.x() > 0 ? std::atan2(-margin.y(), margin.x()) : 0.0;
    comparison.estimates = travel_estimates(comparison.slide);
    for (const TravelEstimate& estimate : comparison.estimates) {
        auto& run_outs = comparison.run_outs.emplace_back();
        for (const TravelLine& line : estimate.lines)
            run_outs.push_back(run_out_at(run.geometry, line.ratio));
    }
    return comparison;
}

PairStatistics pair_statistics(const std::string& group) {
    PairStatistics statistics;
    double sum = 0, logs = 0, squares = 0;
    for (const TravelPair& pair : travel_pairs()) {
        if (pair.group != group) continue;
        const bool first = statistics.count++ == 0;
        const auto take = [&](double& least, double& greatest, double value) {
            least = first ? value : std::min(least, value);
            greatest = first ? value : std::max(greatest, value);
        };
        take(statistics.least_angle_deg, statistics.greatest_angle_deg, pair.angle_deg);
        take(statistics.least_volume, statistics.greatest_volume, pair.volume);
        const double log_ratio = std::log10(std::tan(radians(pair.angle_deg)));
        sum += pair.angle_deg;
        logs += log_ratio;
        squares += log_ratio * log_ratio;
    }
    const double n = statistics.count;
    if (n < 2) return statistics;
    statistics.mean_angle_deg = sum / n;
    statistics.scatter = std::sqrt(std::max(0.0, squares - logs * logs / n) / (n - 1));
    return statistics;
}

}  // namespace runout
