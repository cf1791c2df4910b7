#include "engine/watch/invariants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace runout {
namespace {

struct Rule {
    const char* name;
    double limit;
    const char* meaning;
};

// Why the limits stand where they do: docs/stability.md.
constexpr std::array<Rule, static_cast<int>(Invariant::count)> rules = {{
    {"particles", 0.0, "particles lost or doubled"},
    {"penetration", 0.5, "depth of a particle in the bed, in spacings"},
    {"speed", 4.0, "greatest speed / sqrt(2 g H)"},
    {"energy_rise", 0.05, "rise of the mechanical energy / (M g H)"},
    {"energy_balance", 1e-6, "energy lost that no work accounts for / (M g H)"},
    {"density", 0.5, "excess of the densest particle over rho_0"},
    {"volume", 0.02, "area lost to excess of density / area"},
    {"pressure", 0.0, "tension beyond the cut-off / (rho g H)"},
    {"residual", 1.0, "steps in a row whose pressure solve missed its tolerance / 20"},
    {"wall_guard", 1e-3, "particles driven into the bed / particles, a step"},
    {"time_step", 1.0, "floor of the time step / time step"},
}};

constexpr double tolerated_misses = 20;     // pressure solves in a row that missed their tolerance
constexpr double unhurried_nearness = 0.5;  // of a limit; up to here steps are not shortened
constexpr double guard_grace = 10.0;        // particle-steps driven in before their fraction is judged

// Of the Courant step at the speed of free fall. Far shorter than any sound run takes; a run whose steps
// shrink without end is ended here.
constexpr double step_floor = 1e-3;

const Rule& rule(Invariant invariant) {
    return rules[static_cast<std::size_t>(invariant)];
}

}  // namespace

const char* to_string(Invariant invariant) {
    return rule(invariant).name;
}

const char* meaning_of(Invariant invariant) {
    return rule(invariant).meaning;
}

InvariantWatch::InvariantWatch(const InvariantScales& scales) : scales_(scales) {
    for (std::size_t k = 0; k < rules.size(); ++k) readings_[k].limit = rules[k].limit;
}

void InvariantWatch::restart(double height) {
    scales_.height = height;
    started_ = false;
}

void InvariantWatch::note(Invariant invariant, double value, double x) {
    InvariantReading& reading = readings_[static_cast<std::size_t>(invariant)];
    const bool sound = value <= reading.limit;  // false for NaN
    if (value > reading.worst || std::isnan(value)) reading = {value, reading.limit, time_, x};
    if (sound || violation_) return;
    violation_ = fmt::format("{} at t = {:.4g} s, x = {:.4g} m: {} is {:.3g}, at most {:.3g}",
                             to_string(invariant), time_, x, meaning_of(invariant), value, reading.limit);
}

void InvariantWatch::note_energy(double mechanical, double fastest_x, const StepFacts& step) {
    const double energy = mechanical - step.work_supplied;
    if (!started_) {
        start_energy_ = energy;
        least_energy_ = energy;
        start_work_ = step.work_done;
        started_ = true;
    }
    const double unit = scales_.gravity * scales_.height;
    note(Invariant::energy_rise, (energy - least_energy_) / unit, fastest_x);
    least_energy_ = std::min(least_energy_, energy);
    const double unaccounted = start_energy_ - energy - (step.work_done - start_work_);
    note(Invariant::energy_balance, std::abs(unaccounted) / unit, fastest_x);
}

SoilSurvey survey(const Soil& soil, const std::vector<double>& density, double gravity, int first, int last) {
    SoilSurvey s;
    s.count = last - first;
    int fastest = first;
    int densest = first;
    int tensest = first;
    for (int i = first; i < last; ++i) {
        const double v2 = soil.vx[i] * soil.vx[i] + soil.vy[i] * soil.vy[i];
        s.energy += 0.5 * v2 + gravity * soil.y[i];
        if (!(v2 <= s.speed2) && !std::isnan(s.speed2)) {
            s.speed2 = v2;
            fastest = i;
        }
        if (density[i] > 1.0) s.excess += density[i] - 1.0;
        if (density[i] > density[densest]) densest = i;
        if (!(-soil.pressure[i] <= s.tension) && !std::isnan(s.tension)) {
            s.tension = -soil.pressure[i];
            tensest = i;
        }
        s.numbers += soil.id[i];
        s.first_x = std::min(s.first_x, soil.x[i]);
        s.last_x = std::max(s.last_x, soil.x[i]);
    }
    if (s.count == 0) return s;
    s.fastest_x = soil.x[fastest];
    s.density = density[densest];
    s.densest_x = soil.x[densest];
    s.tension_x = soil.x[tensest];
    return s;
}

SoilSurvey& SoilSurvey::operator+=(const SoilSurvey& next) {
    const bool none = count == 0;
    if (none || (!(next.speed2 <= speed2) && !std::isnan(speed2))) {
        speed2 = next.speed2;
        fastest_x = next.fastest_x;
    }
    if (none || next.density > density) {
        density = next.density;
        densest_x = next.densest_x;
    }
    if (none || (!(next.tension <= tension) && !std::isnan(tension))) {
        tension = next.tension;
        tension_x = next.tension_x;
    }
    count += next.count;
    energy += next.energy;
    excess += next.excess;
    numbers += next.numbers;
    first_x = std::min(first_x, next.first_x);
    last_x = std::max(last_x, next.last_x);
    return *this;
}

void InvariantWatch::observe(const SoilSurvey& soil, const StepFacts& step) {
    time_ = step.time;
    ++steps_;
    const auto count = static_cast<double>(soil.count);
    const double x = soil.fastest_x;
    const double available = scales_.gravity * scales_.height + std::max(0.0, step.work_supplied);
    note(Invariant::speed, std::sqrt(soil.speed2 / (2.0 * available)), x);
    note(Invariant::particles,
         static_cast<double>(std::abs(soil.numbers - soil.count * (soil.count - 1) / 2)), x);
    note(Invariant::penetration, step.greatest_depth / scales_.spacing, step.depth_x);
    note_energy(soil.energy / count, x, step);
    note(Invariant::density, soil.density - 1.0, soil.densest_x);
    // A mass about as thin as a spacing starts crowded, which is no loss of area. So crowding counts from the
    // least so far.
    const double crowding = soil.excess / count;
    least_crowding_ = steps_ == 1 ? crowding : std::min(least_crowding_, crowding);
    note(Invariant::volume, crowding - least_crowding_, soil.densest_x);
    note(Invariant::pressure,
         (soil.tension - scales_.tension) / (scales_.density * scales_.gravity * scales_.height),
         soil.tension_x);
    note(Invariant::residual, step.unconverged / tolerated_misses, x);
    driven_in_ += static_cast<double>(step.driven_in) / count;
    const double grace = guard_grace / count;
    note(Invariant::bed_guard, std::max(0.0, driven_in_ - grace) / static_cast<double>(steps_), step.depth_x);
    const double natural =
        scales_.courant * scales_.spacing / std::sqrt(2.0 * scales_.gravity * scales_.height);
    note(Invariant::time_step, step_floor * natural / step.dt, x);
}

double InvariantWatch::pace() const {
    double nearness = 0.0;
    for (const Invariant cause : {Invariant::bed_guard, Invariant::volume}) {
        const InvariantReading& reading = readings_[static_cast<std::size_t>(cause)];
        nearness = std::max(nearness, reading.worst / reading.limit);
    }
    const double fraction = unhurried_nearness / std::max(unhurried_nearness, nearness);
    return fraction * fraction;
}

}  // namespace runout
