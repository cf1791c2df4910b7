#include "measures/barrier.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/effects/barrier.h"

namespace runout {
namespace {

constexpr double near_spacings = 4.0;  // soil that climbs the face is no further from it

}  // namespace

BarrierRecorder::BarrierRecorder(const Scene& scene, double interval, double front_thickness)
    : barrier_(*scene.effects.barrier),
      density_(scene.material.density),
      front_thickness_(front_thickness),
      interval_(interval),
      due_(interval) {
    const Polyline outline = barrier_outline(scene.source.bed, barrier_);
    foot_y_ = outline.front().y();
    back_x_ = outline.back().x();
    record_.arrival_time_s = std::numeric_limits<double>::quiet_NaN();
}

/// Speed and thickness of what is about to meet the barrier, in a strip of half its height before its foot;
/// the design load is the greatest alpha rho v^2 h of what passes there before the barrier holds it up.
void BarrierRecorder::read_approach(const StateView& state) {
    const double dl = state.discretisation->spacing;
    const double width = std::max(0.5 * barrier_.height, 2.0 * dl);
    int count = 0;
    double speed = 0.0;
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        if (state.x[i] > barrier_.x || state.x[i] < barrier_.x - width || !state.is_debris(i)) continue;
        ++count;
        speed += std::max(0.0, state.vx[i]);
    }
    const double thickness = count * state.discretisation->volume() / width;
    if (count == 0) return;
    speed /= count;
    if (std::isnan(record_.arrival_time_s) && thickness >= front_thickness_)
        record_.arrival_time_s = state.time;
    const double load = barrier_.load_coefficient * density_ * speed * speed * thickness;
    if (load <= record_.design_force_n_m) return;
    record_.design_force_n_m = load;
    record_.approach_speed_m_s = speed;
    record_.approach_thickness_m = thickness;
}

void BarrierRecorder::sample(const Simulation& simulation, bool always) {
    if (!simulation.released()) return;
    const StateView state = simulation.state();
    const BarrierForce& now = *simulation.barrier_force();
    read_approach(state);
    double overtopped = 0.0;
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        if (state.x[i] > back_x_) overtopped += state.discretisation->volume();
        const bool at_face = state.x[i] > barrier_.x - near_spacings * state.discretisation->spacing &&
                             state.x[i] <= back_x_ && state.density[i] > body_density;
        if (at_face)
            record_.run_up_m =
                std::max(record_.run_up_m, state.y[i] + 0.5 * state.discretisation->spacing - foot_y_);
    }
    record_.overtopped_area_m2 = overtopped;
    if (state.time < due_ && !always) return;
    if (state.time <= last_time_) return;
    due_ += interval_;
    const Vec2 mean = (now.impulse - last_impulse_) / (state.time - last_time_);
    last_impulse_ = now.impulse;
    last_time_ = state.time;
    record_.rows.push_back({state.time, mean.x(), mean.y(), now.moment, now.impulse.x()});
    if (mean.x() > record_.greatest_force_n_m) {
        record_.greatest_force_n_m = mean.x();
        record_.greatest_force_time_s = state.time;
    }
    record_.greatest_moment_n = std::max(record_.greatest_moment_n, now.moment);
    record_.impulse_n_s_m = now.impulse.x();
    record_.last_force_n_m = mean.x();
}

}  // namespace runout
