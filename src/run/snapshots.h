#pragma once

#include <vector>

#include "engine/simulation.h"
#include "measures/measures.h"

namespace runout {

/// Keeps the particles at the first step that ends at or after each of some instants.
class SnapshotRecorder {
  public:
    /// `times`: s since release, rising.
    explicit SnapshotRecorder(std::vector<double> times) : times_(std::move(times)) {}

    void sample(const Simulation& simulation);

    [[nodiscard]] const std::vector<Snapshot>& snapshots() const { return snapshots_; }

  private:
    std::vector<double> times_;
    std::vector<Snapshot> snapshots_;
};

}  // namespace runout
