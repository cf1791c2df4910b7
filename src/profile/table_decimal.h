#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "profile/table_numbers.h"
#include "profile/table_rows.h"

namespace runout {

/// The two cells of a point, and the line that they stand on.
struct PointCells {
    int line = 0;
    std::string_view chainage{};
    std::string_view elevation{};
};

/// The decimal mark of a table, from all its numbers; point where none has a decimal part. Throws InputError
/// where they contradict each other, or could as well be thousands; `path` is for the message.
DecimalMark decimal_mark_of(const std::vector<PointCells>& points, Separator separator,
                            const std::string& path);

}  // namespace runout
