#pragma once

#include <string>
#include <vector>

#include "profile/descents.h"
#include "profile/profile.h"

namespace runout {

/// The ground with its face, before the origin is moved to the toe.
struct PlacedFace {
    Polyline ground;  ///< from the uphill end to the distal end; x is the chainage or its negative
    Descent ends;
    double inclination = 0;  ///< of the face, rad; 0 where there is none
    bool descends_with_chainage = true;
    std::vector<std::string> doubts;
};

/// Decides which way the section descends, and puts toe and crest where they are given, or else finds them.
/// `points` as checked_points() gives them. Throws InputError: a given chainage that is not on the section,
/// no descent.
PlacedFace place_face(const std::vector<Vec2>& points, const ProfileOptions& options,
                      const std::string& file);

}  // namespace runout
