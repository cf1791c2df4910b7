#pragma once

#include <string>
#include <vector>

#include "core/geometry.h"

namespace runout {

/// The first two columns of a CSV of measured points: `#` starts a comment, one line of column names. Rows
/// are taken only if their `label` column, the first, says so, when `label` is given; then the next two
/// columns count. Throws InputError: no such file, a row that is not numbers.
std::vector<Vec2> read_points(const std::string& path, const std::string& label = {});

/// Least x at which the line through the points (x rising) reaches y from below; NaN if it does not.
double crossing(const std::vector<Vec2>& points, double y);

}  // namespace runout
