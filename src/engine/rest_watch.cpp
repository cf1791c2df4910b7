#include "engine/rest_watch.h"

#include <algorithm>
#include <cmath>

namespace runout {
namespace {

constexpr double rest_energy = 1e-5;  // energy of the mean motion at rest, share of g sqrt(S)
constexpr double rest_window = 0.5;   // over which the motion is averaged, in sqrt(sqrt(S)/g)
constexpr int rest_windows = 4;       // in a row

}  // namespace

RestWatch::RestWatch(double gravity, double length, double grain_way)
    : rest_energy_(rest_energy * gravity * length),
      window_(rest_window * std::sqrt(length / gravity)),
      grain_way_(grain_way) {}

void RestWatch::start(const Soil& soil, double time) {
    mark_.resize(static_cast<std::size_t>(soil.count));
    for (int i = 0; i < soil.count; ++i) mark_[soil.id[i]] = {soil.x[i], soil.y[i]};
    mark_time_ = time;
    resting_windows_ = 0;
}

void RestWatch::observe(const Soil& soil, double time) {
    if (time - mark_time_ >= window_) close_window(soil, time);
}

void RestWatch::close_window(const Soil& soil, double time) {
    const double duration = time - mark_time_;
    double moved2 = 0.0;
    double furthest2 = 0.0;
    for (int i = 0; i < soil.count; ++i) {
        Vec2& mark = mark_[soil.id[i]];
        const Vec2 now{soil.x[i], soil.y[i]};
        const double way2 = (now - mark).squaredNorm();
        moved2 += way2;
        furthest2 = std::max(furthest2, way2);
        mark = now;
    }
    const double energy = 0.5 * moved2 / (soil.count * duration * duration);  // per mass
    const bool mass_rests = energy < rest_energy_;
    resting_windows_ = mass_rests && furthest2 < grain_way_ * grain_way_ ? resting_windows_ + 1 : 0;
    if (!mass_rests) last_motion_ = time;
    mark_time_ = time;
}

bool RestWatch::at_rest() const {
    return resting_windows_ >= rest_windows;
}

double RestWatch::progress() const {
    return static_cast<double>(resting_windows_) / rest_windows;
}

}  // namespace runout
