#pragma once

#include <string>
#include <vector>

#include "core/geometry.h"

namespace runout {

/// Where lines come from, for messages.
struct LinePlace {
    std::string file;
    std::string what;  ///< "layer GROUND"
};

enum class Course { open, closed };

/// Pieces whose ends meet, in any order and direction, as one line; a piece that is there twice counts once.
/// Ends meet that are no further apart than joining_tolerance; the one with the smaller x (then y) stays.
/// An open line runs from its end with the smaller x; a step back by less than the tolerance is a vertical
/// step. A closed one does not repeat its first point. Throws InputError, with the place: a gap, more than
/// two ends that meet, an open line where a closed one is asked and the other way round, no line, coordinates
/// that are no places.
Polyline join_lines(const std::vector<Polyline>& pieces, Course course, const LinePlace& place);

/// 1e-4 of the greater side of the box around the points, and no more than 0.01 m.
double joining_tolerance(const std::vector<Polyline>& pieces);

}  // namespace runout
