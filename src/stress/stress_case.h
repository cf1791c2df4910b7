#pragma once

#include <string>
#include <utility>
#include <vector>

#include "stress/stress_point.h"

namespace runout {

/// A random scene as files that `runout run` takes.
struct StressCase {
    std::string section;  ///< CSV, chainage and elevation
    std::string text;     ///< case file
};

/// The scene of a point as a case whose run has the same bits. `section_file`: what the case calls its
/// section. `settings`: keys "run.*" of the case and their values, in place of those of the point. Throws
/// InputError (--case) for a mass that starts as a column or a block of its own.
StressCase stress_case(const StressPoint& point, const std::string& name, const std::string& section_file,
                       const std::vector<std::pair<std::string, std::string>>& settings);

}  // namespace runout
