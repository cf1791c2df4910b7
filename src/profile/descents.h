#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry.h"

namespace runout {

/// A stretch of ground that comes down: indices of its upper and its lower end.
struct Descent {
    std::size_t crest = 0;
    std::size_t toe = 0;

    bool operator==(const Descent&) const = default;
};

/// Drop from crest to toe, m.
double drop_of(const Polyline& ground, const Descent& descent);

/// Horizontal length from crest to toe, m.
double run_of(const Polyline& ground, const Descent& descent);

/// Difference of elevation that the ground as a whole has, m: from its highest point down to the level that
/// all but a hundredth of its length (or an end of it) stays above, so that a crack or a drain does not
/// count. The ground goes from left to right without overhang.
double relief_of(const Polyline& ground);

/// The same points, with those in cracks, drains and ditches (no wider than a tenth of the relief, and deeper
/// than a fiftieth) raised to the level of the lower rim.
Polyline without_holes(const Polyline& ground, double relief);

/// All descents steeper than `slope` (fall over length), those that belong together as one. With y + slope x
/// in place of the elevation, a descent falls and what is flatter rises. A descent ends where nothing lower
/// (in that sense) comes within a fourteenth of `scale`. Two of them belong together when what lies between
/// is a berm: at most 0.6 times as long as the lower of the two is high, without a rise between. A small one
/// at an end, less than half as high as the highest, must be nearer than a tenth of the height of the rest.
/// From left to right, downhill to the right.
std::vector<Descent> descents(const Polyline& ground, double slope, double scale);

/// The longest level stretch between two parts of a descent over the height of the lower part, and where it
/// is.
struct Berm {
    double share = 0;  ///< 0: there is none
    Descent between;   ///< crest: where it begins, toe: where it ends
};
Berm widest_berm(const Polyline& ground, double slope, double scale, const Descent& whole);

}  // namespace runout
