#pragma once

#include <span>
#include <string>
#include <vector>

#include "stress/run_stress.h"

namespace runout {

/// How the scenes ended, how near each invariant came to its limit, and every scene that is not sound with
/// the numbers that it is made of.
std::string stress_table(const std::vector<StressOutcome>& outcomes, std::span<const StressAxis> axes);

}  // namespace runout
