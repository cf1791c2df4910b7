#pragma once

#include "core/geometry.h"
#include "measures/measures.h"

namespace runout {

/// Angles that are tried for a plane of discontinuity, above the horizontal and rising uphill (towards -x),
/// rad.
struct PlaneSearch {
    double lowest = 0.35;   ///< 20 deg: below any slip surface of the paper
    double highest = 1.55;  ///< 89 deg
    double step = 0.004;    ///< 0.23 deg
};

/// The straight plane through `exit` that parts fast soil from slow, shortly after release.
struct Discontinuity {
    double angle = 0;     ///< rad, as in PlaneSearch; NaN if no plane has soil on both sides
    double contrast = 0;  ///< variance of speed between the two sides over the whole: 1 for two rigid blocks
    double front_speed = 0;  ///< mean above the plane, m/s
    double rear_speed = 0;   ///< mean below it, m/s
    double front_share = 0;  ///< particles above it over all
};

/// Of all planes through `exit` the one with the greatest variance of speed between its two sides (Otsu's
/// threshold, with a line in place of a grey value): no speed has to be named that would count as moving.
/// Each side holds at least one particle in twenty. Soil downhill of the plane and above it is the front. One
/// field of speeds gives the angle to about a particle spacing over the length of the plane; what a lattice
/// adds to that is the scatter over several.
Discontinuity find_discontinuity(const Snapshot& snapshot, const Vec2& exit, const PlaneSearch& search = {});

/// Its angle alone, rad.
double discontinuity_angle(const Snapshot& snapshot, const Vec2& exit, const PlaneSearch& search = {});

/// The same threshold strip by strip: where, in `strips` equal strips across the straight plane, the speed
/// changes most. Shows how far the discontinuity is from straight. Strips without enough soil are left out.
Polyline discontinuity_trace(const Snapshot& snapshot, const Vec2& exit, int strips = 12,
                             const PlaneSearch& search = {});

}  // namespace runout
