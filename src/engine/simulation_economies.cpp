// What a step leaves out where it is not needed; see docs/effects.md.

#include <algorithm>

#include "engine/pairs/operators.h"
#include "engine/simulation.h"
#include "engine/threads/node_array.h"

namespace runout {
namespace {

constexpr double no_pressure = 1e-6;     // of rho g sqrt(S)
constexpr double no_compression = 1e-3;  // density above rho_0, or gained in sqrt(sqrt(S)/g)

}  // namespace

/// Nothing touches the bed, bears pressure or is being compressed: friction and pressure are then both
/// nothing. Cohesive soil holds together by itself.
bool Simulation::in_free_flight() {
    const double weight = discretisation_.density * run_.gravity * length_scale_;
    if (!neighbours_.active.empty() || highest_pressure_ > no_pressure * weight) return false;
    if (friction_.yield().cohesive()) return false;
    soil_velocities(neighbours_, soil_, flight_velocity_);
    std::vector<double>& divergence = predicted_vx_;  // in a place that is not in use yet
    set_all(divergence, neighbours_.nodes, 0.0);
    for (const PairBlock& block : neighbours_.blocks)
        pair_kernels().velocity_divergence(pair_rows(block, neighbours_), flight_velocity_.data(),
                                           divergence.data());
    for (int i = 0; i < soil_.count; ++i)
        if (neighbours_.density[i] - 1.0 > no_compression || -divergence[i] * time_scale_ > no_compression)
            return false;
    return true;
}

/// As `resist`, where nothing does.
PressureSolve Simulation::fly(double dt) {
    const Vec2 gain = dt * body_acceleration();
    set_all(predicted_vx_, neighbours_.nodes, 0.0);
    set_all(predicted_vy_, neighbours_.nodes, 0.0);
    for (int i = 0; i < soil_.count; ++i) {
        predicted_vx_[i] = soil_.vx[i] + gain.x();
        predicted_vy_[i] = soil_.vy[i] + gain.y();
    }
    for (auto* field : {&soil_.pressure, &soil_.sxx, &soil_.sxy, &force_x_, &force_y_})
        std::fill(field->begin(), field->end(), 0.0);
    work_.flying_particle_steps += soil_.count;
    return {.converged = true};
}

/// What sleeps has no velocity and no force; the trembling that it fell asleep with is booked.
void Simulation::let_sleep(int resting) {
    work_.sleeping_particle_steps += resting;
    double trembling = 0.0;
    for (int i = 0; i < soil_.count; ++i) {
        if (!neighbours_.rests(i)) continue;
        trembling += 0.5 * (soil_.vx[i] * soil_.vx[i] + soil_.vy[i] * soil_.vy[i]);
        soil_.vx[i] = soil_.vy[i] = 0.0;
        neighbours_.density[i] = sleep_->density(soil_.id[i]);
        force_x_[i] = force_y_[i] = 0.0;
    }
    numerical_work_ += discretisation_.mass() * trembling;
}

/// Nothing sleeps while the ground shakes.
void Simulation::watch_sleep() {
    if (!ground_motion_ || time_ >= ground_motion_->ends())
        sleep_->observe(soil_, neighbours_.density, time_);
}

}  // namespace runout
