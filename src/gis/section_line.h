#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gis/map_line.h"

namespace runout {

/// Which lines of which vector data set. Empty and absent: not said.
struct LineQuery {
    std::string file{};   ///< anything GDAL reads
    std::string layer{};  ///< may be left out where there is one
    std::string where{};  ///< condition on the attributes, "slope_no = '11SW-D/C1'"
    std::optional<long> feature_id{};
    std::string crs{};  ///< replaces what the file says, "EPSG:2326"
};

/// One line feature.
struct SectionLine {
    std::string layer;
    long feature_id = 0;
    MapLine map;
    std::vector<double> elevations;  ///< one per point, in units of the data set; empty for a 2-D line
    double elevation_unit_m = 0;     ///< metres in such a unit if the data set says so, else 0
};

/// All lines that the query asks for, in the order of the layer. A multi-line of one part is a line, an arc
/// is broken into straight pieces; in degrees a line gets points every 10 m, so that proportion along a piece
/// is proportion in metres. Throws InputError: a file, layer, feature or field that does not exist, no
/// coordinate system, another geometry, several parts, a line that closes or crosses itself or has no length.
std::vector<SectionLine> read_section_lines(const LineQuery& query);

}  // namespace runout
