#pragma once

#include <string>
#include <vector>

#include "profile/find_face.h"

namespace runout {

/// Ground from its uphill to its distal end, whose x is the chainage or its negative.
struct GroundSeen {
    const Polyline& ground;
    bool with_chainage = true;
    double scale = 0;  ///< as scale_of, m
};

/// What speaks against the first of `faces` (as find_faces gives them), a sentence each: others that could be
/// meant, a wide berm in it, a toe that is not sharp.
std::vector<std::string> doubts_about(const GroundSeen& seen, const std::vector<Face>& faces);

/// Adds a sentence where the best face of the opposite hillside could be meant as well.
void add_doubt_of_other_side(std::vector<std::string>& doubts, const Face& chosen, const GroundSeen& other,
                             const Face& face);

/// A sentence where a given toe lies far beyond the foot of the face above it.
std::vector<std::string> doubts_about_given_toe(const GroundSeen& seen, const Face& face, std::size_t toe);

}  // namespace runout
