#pragma once

#include <string>
#include <vector>

#include "measures/measures.h"

namespace runout {

/// Seconds of wall time in each phase of a run's steps and their share of the whole, a line each, for people.
/// Empty where no time was taken.
std::string time_table(const std::vector<PhaseTime>& phases);

}  // namespace runout
