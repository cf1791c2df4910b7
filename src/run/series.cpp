#include "run/series.h"

#include <algorithm>
#include <limits>

#include "measures/deposit.h"

namespace runout {

void SeriesRecorder::sample(const Simulation& simulation, const ReachRecorder& reach) {
    if (!rows_.empty() && simulation.time() <= rows_.back().time_s) return;
    due_ += interval_;
    const StateView state = simulation.state();
    const EnergyBudget energy = simulation.energy();
    const double mass = state.discretisation->mass() * static_cast<double>(state.x.size());
    const double mass_point = mass_front(state, 0.005);
    const double front =
        reach.front() > ThicknessField::nowhere ? reach.front() : std::numeric_limits<double>::quiet_NaN();
    if (!rows_.empty() && simulation.time() > rows_.back().time_s + 0.5 * interval_) {
        peak_speed_ = std::max(peak_speed_, (mass_point - rows_.back().front_mass_995_m) /
                                                (simulation.time() - rows_.back().time_s));
    }
    rows_.push_back(
        {simulation.time(), front, mass_point, energy.kinetic, energy.potential, energy.friction_work, mass});
}

}  // namespace runout
