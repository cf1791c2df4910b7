#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/input_error.h"
#include "gis/map_line.h"

namespace runout {

/// Which lines of which vector data set. Empty and absent: not said.
struct LineQuery {
    std::string file{};   ///< of a driver that may read lines (docs/maps.md)
    std::string layer{};  ///< may be left out where one has lines
    std::string where{};  ///< condition on the attributes, "slope_no = '11SW-D/C1'"
    std::optional<long> feature_id{};
    std::string crs{};  ///< replaces what the file says, "EPSG:2326"
};

/// A vertex of a three-dimensional line as it was drawn.
struct LineVertex {
    Vec2 place{0, 0};  ///< in the coordinate system of the line
    double chainage_m = 0;
    double elevation = 0;  ///< in units of the data set; NaN: the file gives none here
};

/// One line feature.
struct SectionLine {
    std::string layer;
    long feature_id = 0;
    MapLine map;
    std::vector<LineVertex> vertices;  ///< all of them; those of a vertical face have one chainage; empty for
                                       ///< a 2-D line
    double elevation_unit_m = 0;       ///< metres in such a unit if the data set says so, else 0
    std::string height_datum;          ///< what its heights are counted from where that is no level:
                                       ///< "clampToGround", "relativeToGround"; else empty
};

/// One feature of a layer, which may be no section.
struct LineFeature {
    std::string file;
    std::string layer;
    long feature_id = 0;
    MapLine drawn;  ///< of one that is refused: points only if it has any, chainages in units of its system
    std::optional<InputError> refusal{};  ///< why it is no section
};

/// All features that the query asks for, in the order of the layer. Throws InputError: a file, layer, feature
/// or field that does not exist, no feature at all.
std::vector<LineFeature> list_section_lines(const LineQuery& query);

/// The one line that the query asks for. A multi-line of one part is a line, an arc is broken into straight
/// pieces. Chainages are metres on the ground: where the scale factor of the coordinate system is more than
/// 0.1 % from 1, and in degrees, they are measured on the ellipsoid, and the line gets points every 10 m, so
/// that proportion along a piece is proportion in metres. Throws InputError: as list_section_lines, several
/// lines, no coordinate system, another geometry, several parts, a line that closes or crosses itself or has
/// no length.
SectionLine read_section_line(const LineQuery& query);

/// The driver that would read lines from a file, "GPKG" or "DXF"; empty if there is none.
std::string line_driver(const std::string& path);

}  // namespace runout
