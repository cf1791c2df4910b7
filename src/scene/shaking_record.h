#pragma once

#include <string>

#include "scene/effects.h"

namespace runout {

/// Acceleration of the ground from a CSV whose header names time_s, horizontal_m_s2 and, if wanted,
/// vertical_m_s2. Throws InputError, with the line: unreadable file, unknown or missing column, a value that
/// is no number, times that do not start at 0 and rise.
Shaking read_shaking_record(const std::string& path);

}  // namespace runout
