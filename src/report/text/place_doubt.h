#pragma once

#include <cmath>

#include "store/store.h"

namespace runout {

/// How far a place lies beyond the farthest front of the run, m.
inline double beyond_front(const StoredRun& run, const PlaceRecord& place) {
    return std::abs(place.chainage_m - run.toe_chainage_m) - run.measures.farthest_front_m;
}

/// A place that the front did not reach, but does within the numerical error of the run-out: nobody should
/// take it for safe.
inline bool within_error(const StoredRun& run, const PlaceRecord& place) {
    return std::isnan(place.arrival_time_s) && beyond_front(run, place) <= run.appraisal.run_out_error_m;
}

}  // namespace runout
