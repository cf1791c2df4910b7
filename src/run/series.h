#pragma once

#include <vector>

#include "engine/simulation.h"
#include "measures/measures.h"
#include "measures/reach.h"

namespace runout {

/// Samples front, energies and mass at equal steps of simulated time.
class SeriesRecorder {
  public:
    /// `interval`: between samples, s.
    explicit SeriesRecorder(double interval) : interval_(interval) {}

    [[nodiscard]] bool is_due(const Simulation& simulation) const { return simulation.time() >= due_; }
    /// Takes a sample; `reach` has looked at this instant.
    void sample(const Simulation& simulation, const ReachRecorder& reach);

    [[nodiscard]] const std::vector<SeriesRow>& rows() const { return rows_; }
    /// Greatest mean speed of the 99.5 % mass point between samples, m/s.
    [[nodiscard]] double peak_mass_point_speed() const { return peak_speed_; }

  private:
    double interval_;
    double due_ = 0;
    double peak_speed_ = 0;
    std::vector<SeriesRow> rows_;
};

}  // namespace runout
