#pragma once

#include <SQLiteCpp/Column.h>

#include <cmath>
#include <limits>

#include "store/known_tables.h"

namespace runout {

/// What a column of numbers holds; NaN where there is none. SQLite reads NULL as 0, and a database from
/// elsewhere may hold an infinity, which is no result.
inline double real_value(const SQLite::Column& column) {
    const double value = column.isNull() ? std::numeric_limits<double>::quiet_NaN() : column.getDouble();
    return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
}

/// A number that a place or a shape is made of. Throws DamagedData: an infinity.
inline double coordinate(const SQLite::Column& column) {
    const double value = column.getDouble();
    if (!std::isfinite(value)) throw DamagedData("has an infinite number in place of a coordinate");
    return value;
}

}  // namespace runout
