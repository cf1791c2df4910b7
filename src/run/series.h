#pragma once

#include <vector>

#include "engine/simulation.h"
#include "measures/measures.h"

namespace runout {

/// Samples front, energies and mass at equal steps of simulated time.
class SeriesRecorder {
  public:
    /// `interval`: between samples, s.
    explicit SeriesRecorder(double interval) : interval_(interval) {}

    /// Takes a sample if one is due; `always` takes it anyway (start and end of the run).
    void sample(const Simulation& simulation, bool always = false);

    [[nodiscard]] const std::vector<SeriesRow>& rows() const { return rows_; }
    /// Greatest mean speed of the front between samples, m/s.
    [[nodiscard]] double peak_front_speed() const { return peak_speed_; }

  private:
    double interval_;
    double due_ = 0;
    double peak_speed_ = 0;
    std::vector<SeriesRow> rows_;
};

}  // namespace runout
