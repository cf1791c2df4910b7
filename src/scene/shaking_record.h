#pragma once

#include <string>

#include "engine/effects/effects.h"

namespace runout {

/// Acceleration of the ground from a CSV whose header names time_s, horizontal_m_s2 and, if wanted,
/// vertical_m_s2. Throws InputError, with the line: unreadable file, unknown or missing column, a value that
/// is no number, times that do not start at 0 and rise, and what no ground does: rows closer than a hundredth
/// of a millisecond, more than an hour, more than five times `gravity` (m/s2, that of the run, since models
/// in a centrifuge are shaken harder).
Shaking read_shaking_record(const std::string& path, double gravity);

}  // namespace runout
