#pragma once

#include <vector>

#include "engine/state_view.h"
#include "measures/measures.h"
#include "scene/gauge.h"

namespace runout {

/// What passes fixed places: read off in every step, stored at equal steps of simulated time.
class GaugeRecorder {
  public:
    /// `interval`: between stored rows, s. `front_thickness`: that counts as arrival, m.
    GaugeRecorder(const std::vector<Gauge>& gauges, double interval, double front_thickness);

    void sample(const StateView& state, bool always = false);

    /// `to_chainage`: x -> chainage as in the section file.
    template <class ToChainage>
    [[nodiscard]] std::vector<GaugeRecord> records(const ToChainage& to_chainage) const {
        std::vector<GaugeRecord> records = records_;
        for (std::size_t i = 0; i < records.size(); ++i) records[i].chainage_m = to_chainage(gauges_[i].x);
        return records;
    }

  private:
    [[nodiscard]] GaugeRow read(const StateView& state, std::size_t gauge) const;

    std::vector<Gauge> gauges_;
    double interval_, front_thickness_;
    double due_ = 0;
    std::vector<double> beyond_at_start_;  ///< m2
    std::vector<GaugeRecord> records_;
};

}  // namespace runout
