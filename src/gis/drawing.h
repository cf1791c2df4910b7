#pragma once

#include <string>
#include <vector>

#include "core/geometry.h"
#include "gis/section_line.h"

namespace runout {

/// A line as it was drawn, arcs and splines in straight pieces; coordinates in units of the drawing.
struct DrawnLine {
    std::string layer;
    Polyline points;
    bool level = true;         ///< no point is higher than another in z, across the plane of the drawing
    double off_the_curve = 0;  ///< of a spline: how far the pieces may be off it, an estimate
};

/// The lines of a drawing; texts, dimensions, hatches, blocks and points are left out.
struct Drawing {
    std::string file;
    std::vector<DrawnLine> lines;
    std::string unit;       ///< as section.unit has it; empty: the drawing does not say
    std::string unit_from;  ///< what says so: "$INSUNITS"
    bool imperial = false;  ///< it says no unit, but that it is not metric
};

/// More points than this are no section.
constexpr std::size_t most_drawn_points = 1'000'000;

/// The lines in the model space of an ASCII DXF. An arc has a point every degree, so that a piece is off it
/// by 4e-5 of its radius; a spline eight a control point. Throws InputError: no such file, a binary or broken
/// or cut DXF, an entity on a layer of lines that cannot be read, too many points, a unit that no section is
/// in.
Drawing read_dxf(const std::string& path);

/// The lines of a vector file that names no coordinate system, x along the section and y upwards. Throws
/// InputError: no such file or field, lines in a coordinate system, too many points. GeoJSON, which is always
/// in degrees by its standard, counts as local where its lines are longer than a degree.
Drawing read_local_lines(const LineQuery& query);

/// Whether the lines are flat and named no coordinate system, as those of read_local_lines are. False for
/// CAD files, which section.file reads, and for what cannot be opened.
bool are_local_lines(const LineQuery& query);

}  // namespace runout
