#pragma once

#include <string>
#include <vector>

#include "core/section_point.h"
#include "gis/drawing.h"
#include "profile/section_points.h"

namespace runout {

/// What the user says of a drawing. Empty: not said.
struct DrawingOptions {
    std::string layers{};  ///< "ground=NAME,source=NAME,slip=NAME", each optional; NAME alone is the ground
    std::string unit{};    ///< replaces what the drawing says
};

/// A mass that is drawn with its section.
struct DrawnMass {
    std::vector<SectionPoint> outline{};    ///< closed, the first point not repeated; empty: none is drawn
    std::string outline_from{};             ///< "layer SOURCE of section.dxf"
    std::vector<SectionPoint> slip_line{};  ///< from end to end; empty: none is drawn
    std::string slip_line_from{};
};

/// A section and what is drawn with it.
struct SectionContent {
    SectionPoints section{};
    DrawnMass mass{};
};

/// The section in a drawing: x is the chainage, y the elevation. Layers that the options do not name: ground,
/// source and slip where there are such (letters in any case); else the only layer with lines is the ground.
/// Lines of a layer are joined end to end (join_lines). Throws InputError: no lines, several layers to choose
/// from, a layer that does not exist, what join_lines refuses, a unit that must be said, a plan (coordinates
/// of a map), lines in three dimensions.
SectionContent section_of_drawing(const Drawing& drawing, const DrawingOptions& options);

}  // namespace runout
