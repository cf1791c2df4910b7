#pragma once

#include <string>
#include <vector>

#include "core/geometry.h"

namespace runout {

/// What interrupts the straight way from crest to toe and beyond.
enum class HillsideShape { plain, retaining_wall, concave_toe, convex_crest, berms, notch, steps, count };

/// "retaining_wall", ...
std::string to_string(HillsideShape shape);

/// A cut slope from a few numbers. SI and radians.
struct Hillside {
    HillsideShape shape = HillsideShape::plain;
    double face_angle = 0;      ///< up to 90 deg
    double height = 0;          ///< crest above toe
    double bench = 0;           ///< length of the level ground behind the crest
    double run_out_length = 0;  ///< of the bed beyond the toe
    double run_out_angle = 0;   ///< its fall in the direction of run-out, negative: it rises
    double detail = 0;          ///< size of the wall, arc, berm, notch or step
};

/// What the ground falls beyond the toe besides by its inclination, m.
double fall_of_steps(const Hillside& hillside);

/// Ground from the uphill end to the distal end with the toe at the origin.
std::vector<Vec2> ground_of(const Hillside& hillside);

}  // namespace runout
