#include "engine/rest_watch.h"

#include <algorithm>
#include <cmath>

namespace runout {
namespace {

constexpr double rest_energy = 1e-5;  // energy of the mean motion at rest, share of g sqrt(S)
constexpr double rest_window = 0.5;   // between two looks, in sqrt(sqrt(S)/g)
constexpr double rest_windows = 4;    // at rest before the run ends

}  // namespace

RestWatch::RestWatch(double gravity, double length, double grain_way)
    : rest_energy_(rest_energy * gravity * length),
      window_(rest_window * std::sqrt(length / gravity)),
      grain_way_(grain_way) {}

void RestWatch::Mark::take(const Soil& soil, double now) {
    time = now;
    place.resize(static_cast<std::size_t>(soil.count));
    for (int i = 0; i < soil.count; ++i) place[soil.id[i]] = {soil.x[i], soil.y[i]};
}

void RestWatch::start(const Soil& soil, double time) {
    opened_.take(soil, time);
    settled_ = opened_;
    rested_ = 0.0;
}

void RestWatch::observe(const Soil& soil, double time) {
    if (time - opened_.time >= window_) close_window(soil, time);
}

/// Of the mean motion since then, J/kg.
double RestWatch::energy_since(const Mark& mark, const Soil& soil, double time) const {
    const double duration = time - mark.time;
    double moved2 = 0.0;
    for (int i = 0; i < soil.count; ++i)
        moved2 += (Vec2{soil.x[i], soil.y[i]} - mark.place[soil.id[i]]).squaredNorm();
    return 0.5 * moved2 / (soil.count * duration * duration);
}

/// m.
double RestWatch::furthest_since(const Mark& mark, const Soil& soil) const {
    double furthest2 = 0.0;
    for (int i = 0; i < soil.count; ++i)
        furthest2 = std::max(furthest2, (Vec2{soil.x[i], soil.y[i]} - mark.place[soil.id[i]]).squaredNorm());
    return std::sqrt(furthest2);
}

void RestWatch::close_window(const Soil& soil, double time) {
    if (energy_since(opened_, soil, time) >= rest_energy_) last_motion_ = time;
    const bool kept = furthest_since(settled_, soil) < grain_way_;
    if (!kept) settled_.take(soil, time);
    rested_ = kept && energy_since(settled_, soil, time) < rest_energy_ ? time - settled_.time : 0.0;
    opened_.take(soil, time);
}

double RestWatch::motion_ended() const {
    return std::min(last_motion_, settled_.time);
}

double RestWatch::progress() const {
    return std::min(1.0, rested_ / (rest_windows * window_));
}

}  // namespace runout
