#pragma once

#include <vector>

#include "profile/descents.h"

namespace runout {

/// A descent that may be the cut.
struct Face {
    Descent ends;
    double height = 0;       ///< crest above toe, m
    double inclination = 0;  ///< of what is not vertical in it, rad; pi/2 where all is
    double weight = 0;       ///< height times the third power of the sine of its mean inclination, m
};

/// What gaps, steps and ditches about a face are measured against: its height, or the relief where that is
/// less, m.
double scale_of(const Face& face, double relief);

/// What was found on ground that goes from left to right, downhill to the right.
struct FaceSearch {
    std::vector<Face> faces;  ///< the chosen one first, then others that could be meant, heaviest first
    double relief = 0;        ///< as relief_of, m
};

/// Looks for the cut: of the descents whose parts are steeper than half of their own inclination (descents())
/// and that are at least 15 deg steep in the mean, the one of the greatest weight. Of several with at least
/// 0.6 of that weight the one whose toe is furthest uphill is taken, since a run-out counts from the toe.
/// None: there is no face.
FaceSearch find_faces(const Polyline& ground);

}  // namespace runout
