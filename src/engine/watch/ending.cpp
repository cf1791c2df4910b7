#include "engine/watch/ending.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace runout {
namespace {

constexpr double standing_spacings = 2.0;  // a lattice that finds its rest moves by up to one

double greatest_displacement(const Soil& soil, const std::vector<Vec2>& starts) {
    double moved2 = 0.0;
    for (int i = 0; i < soil.count; ++i)
        moved2 = std::max(moved2, (Vec2{soil.x[i], soil.y[i]} - starts[soil.id[i]]).squaredNorm());
    return std::sqrt(moved2);
}

}  // namespace

Ending::Ending(double gravity, double length, double spacing, double time_limit)
    : rest_(gravity, length, spacing), spacing_(spacing), time_limit_(time_limit) {}

void Ending::start(const Soil& soil, double time) {
    rest_.start(soil, time);
    stage_start_ = time;
}

void Ending::judge(const SoilSurvey& soil, const InvariantWatch& invariants, const BedLine& bed,
                   double time) {
    const InvariantReading& residual = invariants.readings()[static_cast<std::size_t>(Invariant::residual)];
    if (residual.worst > residual.limit) {
        return end(
            RunStatus::not_converged,
            fmt::format("the pressure equation missed its tolerance in 20 steps up to t = {:.4g} s", time));
    }
    if (invariants.violation()) return end(RunStatus::diverged, *invariants.violation());
    const bool uphill = soil.first_x < bed.points().front().x();
    if (uphill || soil.last_x > bed.points().back().x()) {
        return end(RunStatus::left_section,
                   fmt::format("soil passed the {} end of the section at t = {:.4g} s; lengthen the section",
                               uphill ? "uphill" : "distal", time));
    }
}

bool Ending::at_rest(const Soil& soil, double time) {
    if (status_ != RunStatus::running) return false;
    rest_.observe(soil, time);
    return rest_.at_rest();
}

void Ending::end_at_rest(const Soil& soil, const std::vector<Vec2>& starts) {
    const bool stood = greatest_displacement(soil, starts) < standing_spacings * spacing_;
    end(stood ? RunStatus::stable : RunStatus::settled);
}

void Ending::judge_time(double time) {
    if (status_ == RunStatus::running && time - stage_start_ >= time_limit_)
        end(RunStatus::time_limit, fmt::format("still moving at the time limit of {:.4g} s", time_limit_));
}

void Ending::end(RunStatus status, std::string detail) {
    status_ = status;
    detail_ = std::move(detail);
}

}  // namespace runout
