#pragma once

#include <optional>
#include <string>
#include <vector>

#include "profile/column_names.h"
#include "profile/table_decimal.h"
#include "profile/table_points.h"

namespace runout {

/// What the numbers of a table stand for.
struct TableUnits {
    LengthUnit chainage{};
    LengthUnit elevation{};
    std::optional<int> station_digits{};  ///< behind the plus of 0+050: 3, or 2 for stations of 100 ft
    std::string text{};                   ///< for the sentence that says how the file was read
};

/// From the header, or as the user says; metres where neither says anything. Throws InputError where that
/// leaves a choice.
TableUnits table_units(const TableReading& reading, const std::vector<PointCells>& points);

}  // namespace runout
