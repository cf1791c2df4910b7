#include "run/creep_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/friction/yield_strength.h"
#include "measures/front_rule.h"

namespace runout {
namespace {

constexpr double none_yet = std::numeric_limits<double>::lowest();
constexpr double crept_spacings = 0.1;  // in a window; less is not called creep

bool strength_or_load_changes(const Effects& effects) {
    return effects.pore_pressure || effects.shaking || effects.release;
}

/// Where the friction of the bed may change between two x, with both of them.
std::vector<double> places_to_look(const Effects& effects, double from, double to) {
    std::vector<double> places = {from, to};
    if (!effects.base_friction) return places;
    for (const FrictionRange& range : effects.base_friction->ranges)
        for (const double end : {range.from, range.to})
            if (end > from && end < to) places.push_back(end);
    return places;
}

}  // namespace

CreepWatch::CreepWatch(const Scene& scene, const Simulation& simulation)
    : scene_(scene),
      watches_(!strength_or_load_changes(scene.effects)),
      window_(window_time_scales * simulation.time_scale()),
      loss_before_(none_yet) {
    if (watches_) open_window(simulation);
}

void CreepWatch::look(const Simulation& simulation, const ReachRecorder& reach) {
    if (!watches_ || simulation.time() - opened_ < window_) return;
    judge(simulation, reach.front());
    open_window(simulation);
}

void CreepWatch::open_window(const Simulation& simulation) {
    const StateView state = simulation.state();
    opened_ = simulation.time();
    potential_ = simulation.energy().potential;
    places_.resize(state.x.size());
    for (std::size_t i = 0; i < state.x.size(); ++i)
        places_[static_cast<std::size_t>(state.id[i])] = {state.x[i], state.y[i]};
}

/// Least of mu cos(beta) - sin(beta) of the bed between two x, whose ends count.
double CreepWatch::resistance(const StateView& state, double from, double to) const {
    double least = std::numeric_limits<double>::infinity();
    for (int s = 0; s < state.bed->segments(); ++s) {
        const Vec2 start = state.bed->start(s), end = state.bed->end(s);
        if (end.x() < from || start.x() > to) continue;
        const Vec2 along = (end - start).normalized();
        for (const double x :
             places_to_look(scene_.effects, std::max(start.x(), from), std::min(end.x(), to)))
            least = std::min(least,
                             base_strength_ratio(scene_.material, scene_.effects, x) * along.x() + along.y());
    }
    return least;
}

/// Of the soil, by more than `crept_spacings` since the window opened.
double CreepWatch::crept_share(const StateView& state) const {
    const double way = crept_spacings * state.discretisation->spacing;
    double crept = 0;
    for (std::size_t i = 0; i < state.x.size(); ++i)
        if ((Vec2{state.x[i], state.y[i]} - places_[static_cast<std::size_t>(state.id[i])]).norm() > way)
            crept += 1;
    return crept / static_cast<double>(state.x.size());
}

void CreepWatch::judge(const Simulation& simulation, double front) {
    const EnergyBudget energy = simulation.energy();
    const double loss = std::max(0.0, potential_ - energy.potential);
    const bool moved = simulation.motion_ended() > opened_;
    const bool grows = loss > loss_before_;
    loss_before_ = moved ? none_yet : loss;
    if (moved || grows || !(front > ThicknessField::nowhere)) return;

    const FrontRule rule = front_rule(scene_);
    const double duration = simulation.time() - opened_;
    const double time_left = std::max(0.0, simulation.time_limit() - simulation.time());
    const double energy_left = energy.kinetic + loss * time_left / duration;
    const double scale = std::max(front, std::sqrt(scene_.source.area));
    const StateView state = simulation.state();
    const double resists = resistance(state, front - rule.window, front + rule.window + share * scale);
    const double lump = 16.0 / 15.0 * rule.window * rule.threshold;
    const double way =
        energy_left / (scene_.material.density * scene_.run.gravity * lump * std::max(resists, 0.0));
    if (!(way < share * scale)) return;
    negligible_ = true;
    sentence_ = fmt::format(
        "Ended while {:.2g} % of the soil still crept (by more than {} spacings in {:.3g} s): the energy "
        "left "
        "until the time limit of {:.3g} s could move the least lump that counts as the front by {:.2g} m, "
        "less than {:.1f} % of the run-out.",
        100 * crept_share(state), crept_spacings, duration, simulation.time_limit(), way, 100 * share);
}

}  // namespace runout
