// How a run ends; see docs/stability.md.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/simulation.h"
#include "engine/threads/row_passes.h"

namespace runout {
namespace {

constexpr double standing_spacings = 2.0;  // a lattice that finds its rest moves by up to one

}  // namespace

/// Ends the run at rest, at the time limit, or with the name of what went wrong.
void Simulation::judge(StepFacts& facts) {
    facts.time = time_;
    const double mass = discretisation_.mass() * soil_.count;
    facts.work_done =
        (friction_work_ - pressure_work_ + guard_work_ + side_wall_work_ + numerical_work_) / mass;
    facts.work_supplied = shaking_work_ / mass;
    const SoilSurvey soil = sum_chunks(neighbours_.chunks, partial_survey_, [&](int chunk) {
        const RowRange rows = soil_rows(neighbours_, chunk);
        return survey(soil_, neighbours_.density, run_.gravity, rows.first, rows.last);
    });
    invariants_.observe(soil, facts);
    const InvariantReading& residual = invariants_.readings()[static_cast<std::size_t>(Invariant::residual)];
    if (residual.worst > residual.limit) {
        return end(
            RunStatus::not_converged,
            fmt::format("the pressure equation missed its tolerance in 20 steps up to t = {:.4g} s", time_));
    }
    if (invariants_.violation()) return end(RunStatus::diverged, *invariants_.violation());
    const bool uphill = soil.first_x < bed_.points().front().x();
    if (uphill || soil.last_x > bed_.points().back().x()) {
        return end(RunStatus::left_section,
                   fmt::format("soil passed the {} end of the section at t = {:.4g} s; lengthen the section",
                               uphill ? "uphill" : "distal", time_));
    }
    rest_.observe(soil_, time_);
    if (rest_.at_rest()) return end_at_rest();
    if (time_ - stage_start_ >= time_limit_) {
        end(RunStatus::time_limit, fmt::format("still moving at the time limit of {:.4g} s", time_limit_));
    }
}

void Simulation::end_at_rest() {
    if (ground_motion_ && time_ < ground_motion_->ends()) return;
    if (masses_released_ < release_.masses.size()) {  // nothing happens until then
        time_ = std::max(time_, release_.masses[masses_released_].time);
        return;
    }
    if (layers_released_ < release_.layers) {
        stage_ended_ = true;
        return;
    }
    end(greatest_displacement() < standing_spacings * discretisation_.spacing ? RunStatus::stable
                                                                              : RunStatus::settled);
}

double Simulation::greatest_displacement() const {
    double moved2 = 0.0;
    for (int i = 0; i < soil_.count; ++i) {
        moved2 = std::max(moved2, (Vec2{soil_.x[i], soil_.y[i]} - start_[soil_.id[i]]).squaredNorm());
    }
    return std::sqrt(moved2);
}

void Simulation::end(RunStatus status, std::string detail) {
    status_ = status;
    detail_ = std::move(detail);
}

}  // namespace runout
