#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace runout {

/// A unit that a table may be in.
struct LengthUnit {
    std::string_view name;  ///< "metres", "feet (0.3048 m)"
    double metres = 1;

    [[nodiscard]] bool is_foot() const { return metres > 0.3 && metres < 0.31; }
};

/// m, ft, us-ft: what section.unit may be.
LengthUnit unit_named(std::string_view name);

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
