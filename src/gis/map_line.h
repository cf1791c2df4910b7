#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/geometry.h"

namespace runout {

/// Nothing, or a value as a data set or the database has it.
using FieldValue = std::variant<std::monostate, long, double, std::string>;

/// What a map says of a feature, such as the number of a slope.
struct Attribute {
    std::string name;
    FieldValue value;

    bool operator==(const Attribute&) const = default;
};

/// Where a section lies on the map. Points are (easting, northing) or (longitude, latitude) in `crs`; between
/// two of them the section is straight there, and chainage grows in proportion.
struct MapLine {
    std::string crs;                 ///< coordinate system as WKT 2
    Polyline points;                 ///< two or more
    std::vector<double> chainage_m;  ///< of each point, rising, from 0 on a line of a map; true metres also
                                     ///< where `crs` counts in feet or degrees, or its scale factor is not 1
    std::vector<Attribute> attributes;  ///< of the feature, in the order of its layer
};

/// The point of the line at a chainage; its end beyond an end.
Vec2 point_at(const MapLine& line, double chainage);

/// The part between two chainages, from the smaller to the greater, with the vertices between them.
Polyline part_between(const MapLine& line, double from, double to);

/// The value of the first attribute with one of `names` (letters in any case) that holds something, as text;
/// empty if none does.
std::string attribute_text(const std::vector<Attribute>& attributes, const std::vector<std::string>& names);

/// Its value as text: empty, "7", "0.25", "11SW-D/C1".
std::string text_of(const FieldValue& value);

}  // namespace runout
