#include "engine/watch/rest_watch.h"

#include <algorithm>
#include <cmath>

namespace runout {
namespace {

constexpr double rest_energy = 1e-5;  // energy of the mean motion at rest, fraction of g sqrt(S)
constexpr double rest_window = 0.5;   // between two looks, in sqrt(sqrt(S)/g)

/// What counts as rest: every particle within `way` spacings of its place for so many windows.
struct Rule {
    double way;
    double windows;
};
constexpr std::array<Rule, 3> rules = {{{0.1, 6}, {0.3, 16}, {1.0, 40}}};  // still, trembling, rocking

}  // namespace

RestWatch::RestWatch(double gravity, double length, double spacing)
    : rest_energy_(rest_energy * gravity * length), window_(rest_window * std::sqrt(length / gravity)) {
    for (std::size_t k = 0; k < rules.size(); ++k)
        stays_[k] = {rules[k].way * spacing, rules[k].windows * window_, {}, 0.0};
}

void RestWatch::Mark::take(const Soil& soil, double now) {
    time = now;
    place.resize(static_cast<std::size_t>(soil.count));
    for (int i = 0; i < soil.count; ++i) place[soil.id[i]] = {soil.x[i], soil.y[i]};
}

void RestWatch::start(const Soil& soil, double time) {
    opened_.take(soil, time);
    for (Stay& stay : stays_) {
        stay.since = opened_;
        stay.rested = 0.0;
    }
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
    for (Stay& stay : stays_) {
        const bool kept = furthest_since(stay.since, soil) < stay.way;
        if (!kept) stay.since.take(soil, time);
        const bool rests = kept && energy_since(stay.since, soil, time) < rest_energy_;
        stay.rested = rests ? time - stay.since.time : 0.0;
    }
    opened_.take(soil, time);
}

double RestWatch::motion_ended() const {
    for (const Stay& stay : stays_) {
        if (stay.rested >= stay.enough) return std::min(last_motion_, stay.since.time);
    }
    return last_motion_;
}

double RestWatch::progress() const {
    double fraction = 0.0;
    for (const Stay& stay : stays_) fraction = std::max(fraction, stay.rested / stay.enough);
    return std::min(1.0, fraction);
}

}  // namespace runout
