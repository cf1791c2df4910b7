#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/length_unit.h"

namespace runout {

/// What a column holds, as far as its name says.
enum class ColumnRole {
    unknown,
    chainage,         ///< Chainage, Station, Distance, Abstand, ...
    short_chainage,   ///< s, d, km ...: where no column is named better
    elevation,        ///< Elevation, Altitude, Höhe, Z [m] ...
    short_elevation,  ///< z, h
    x,
    y,
    plan  ///< easting, northing
};

/// A cell of a header, such as "Höhe [m]".
struct ColumnName {
    std::string text{};   ///< as it stands there
    std::string plain{};  ///< lower case, no accents, one blank between words, no unit
    ColumnRole role = ColumnRole::unknown;
    std::optional<LengthUnit> unit{};
    bool strange_unit = false;  ///< a unit is named that is none of ours, or two are
};
ColumnName column_name(std::string_view cell);

/// The unit that a cell below the header names, such as "(m)".
ColumnName unit_cell(std::string_view cell);

/// Lower case, no accents, one blank between words.
std::string plain_words(std::string_view text);

/// A text speaks of feet, as a title may.
bool mentions_feet(std::string_view text);

}  // namespace runout
