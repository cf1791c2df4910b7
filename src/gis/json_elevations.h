#pragma once

#include <string>
#include <vector>

namespace runout {

/// Which positions of a line in GeoJSON have a third number, for a feature as its file has it. GDAL reads a
/// missing one as 0. Empty where the text holds no line of one part.
std::vector<bool> has_third_number(const std::string& feature);

}  // namespace runout
