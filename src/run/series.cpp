#include "run/series.h"

#include <algorithm>

#include "measures/deposit.h"

namespace runout {

void SeriesRecorder::sample(const Simulation& simulation, bool always) {
    if (!always && simulation.time() < due_) return;
    if (!rows_.empty() && simulation.time() <= rows_.back().time_s) return;
    due_ += interval_;
    const StateView state = simulation.state();
    const EnergyBudget energy = simulation.energy();
    const double mass = state.discretisation->mass() * static_cast<double>(state.x.size());
    const double front = distance_along_bed(*state.ground, mass_front(state, 0.005));
    if (!rows_.empty() && simulation.time() > rows_.back().time_s + 0.5 * interval_) {
        peak_speed_ =
            std::max(peak_speed_, (front - rows_.back().front_m) / (simulation.time() - rows_.back().time_s));
    }
    rows_.push_back({simulation.time(), front, energy.kinetic, energy.potential, energy.friction_work, mass});
}

}  // namespace runout
