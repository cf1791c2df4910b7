#pragma once

#include <vector>

#include "measures/measures.h"

namespace runout::slopes {

/// Time at which soil first lies on the level bed at y = 0, s: the lowest thousandth of it, three particles
/// at least, has come within one spacing of the bed. Between snapshots it goes on as fast as before. NaN if
/// it never does, or is there from the first snapshots on.
double first_on_bed(const std::vector<Snapshot>& snapshots, double spacing);

/// Time at which the 99.5 % mass point passes the toe, s; NaN if it does not.
double passes_toe(const std::vector<SeriesRow>& series);

/// Mean speed of the rear tenth of the soil over that of the foremost tenth, at the snapshot next to `time`.
double rear_speed_share(const std::vector<Snapshot>& snapshots, double time);

/// When which part of the mass comes to rest, s.
struct Sequence {
    double front = 0;          ///< 99.5 % mass point has gone 98 % of its way past the toe
    double toe = 0;            ///< soil within `box_length` before the toe is slow for good
    double slope = 0;          ///< soil still behind the toe is slow for good
    double moving_behind = 0;  ///< share of all soil that is behind the toe and not slow when the front stops
};

/// `slow`: mean speed (of a particle: its own) that counts as rest, m/s. A zone that holds less than 1 % of
/// the soil counts as at rest.
Sequence sequence_of(const std::vector<SeriesRow>& series, const std::vector<Snapshot>& snapshots,
                     double box_length, double slow);

}  // namespace runout::slopes
