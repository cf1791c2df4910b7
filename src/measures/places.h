#pragma once

#include <vector>

#include "measures/measures.h"
#include "measures/reach.h"
#include "scene/place.h"

namespace runout {

/// What passes fixed places, of the same soil that the front is read of; stored at equal steps of simulated
/// time. A place is reached when the front is at or beyond it.
class PlaceRecorder {
  public:
    /// `interval`: between stored rows, s. `density`: of the soil, kg/m3.
    PlaceRecorder(const std::vector<Place>& places, double interval, double density);

    void sample(const ReachRecorder& reach, const StateView& state, bool always = false);

    /// `to_chainage`: x -> chainage as in the section file.
    template <class ToChainage>
    [[nodiscard]] std::vector<PlaceRecord> records(const ToChainage& to_chainage) const {
        std::vector<PlaceRecord> records = records_;
        for (std::size_t i = 0; i < records.size(); ++i) records[i].chainage_m = to_chainage(places_[i].x);
        return records;
    }

  private:
    [[nodiscard]] PlaceRow read(const ThicknessField& soil, const StateView& state, std::size_t place) const;
    void take(const ThicknessField& soil, double gravity, double x, PlaceRecord& record) const;
    void take_all(const ThicknessField& soil, double gravity, const Place& place, PlaceRecord& record) const;

    std::vector<Place> places_;
    double interval_, density_;
    double due_ = 0;
    std::vector<double> beyond_at_start_;  ///< m2
    std::vector<PlaceRecord> records_;
};

}  // namespace runout
