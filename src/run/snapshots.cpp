#include "run/snapshots.h"

namespace runout {
namespace {

Snapshot snapshot_of(const StateView& state) {
    Snapshot kept;
    kept.time_s = state.time;
    for (auto* field : {&kept.x_m, &kept.y_m, &kept.vx_m_s, &kept.vy_m_s, &kept.pressure_pa}) {
        field->resize(state.x.size());
    }
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        const auto place = static_cast<std::size_t>(state.id[i]);
        kept.x_m[place] = static_cast<float>(state.x[i]);
        kept.y_m[place] = static_cast<float>(state.y[i]);
        kept.vx_m_s[place] = static_cast<float>(state.vx[i]);
        kept.vy_m_s[place] = static_cast<float>(state.vy[i]);
        kept.pressure_pa[place] = static_cast<float>(state.pressure[i]);
    }
    return kept;
}

}  // namespace

void SnapshotRecorder::sample(const Simulation& simulation) {
    if (!simulation.released() || snapshots_.size() == times_.size()) return;
    while (snapshots_.size() < times_.size() && simulation.time() >= times_[snapshots_.size()]) {
        snapshots_.push_back(snapshot_of(simulation.state()));
    }
}

}  // namespace runout
