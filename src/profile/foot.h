#pragma once

#include "core/geometry.h"
#include "profile/find_face.h"

namespace runout {

/// Ends of a face, and its mean inclination from toe to crest, rad; pi/2 for a vertical one.
struct PlacedEnds {
    Descent ends;
    double inclination = 0;
};

/// Which ends are given, and stay where they are.
struct GivenEnds {
    bool toe = false;
    bool crest = false;
};

/// Ends of a face as a surveyor would name them, on ground that goes from left to right, downhill to the
/// right, and their indices in it; points are put in where the ground has none. The given ends are those of
/// find_faces().
/// - A toe in a ditch (narrower and shallower than a tenth of `scale`, m) goes up to the level of its far
/// rim.
/// - In a dense survey no point need lie on the bend between face and level ground: an end then moves to the
///   chainage where lines fitted to the ground on both sides meet, between its neighbours at most. The
///   inclination is the one between these meetings, since the survey cuts the corners.
PlacedEnds placed_ends(Polyline& ground, const Face& face, double scale, const GivenEnds& given);

}  // namespace runout
