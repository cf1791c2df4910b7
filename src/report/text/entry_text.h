#pragma once

#include <span>
#include <string>

#include "validation/entry.h"

namespace runout {

/// Four significant digits; "-" for what does not exist.
std::string number_text(double value);

/// "+3.1 %", "-0.02" in the unit of the quantity, or the computed number where that is all that is judged.
std::string deviation_text(const ValidationEntry& entry);

/// "+-5 %", "+-0.1", "<= 0.01", or "-" where nothing is asked.
std::string accepted_text(const ValidationEntry& entry);

/// The computed number, or "no result".
std::string computed_text(const ValidationEntry& entry);

/// "pass", "OUTSIDE", or "-" where nothing is asked.
std::string verdict_text(const ValidationEntry& entry);

bool is_judged(const ValidationEntry& entry);
bool is_outside(const ValidationEntry& entry);

/// How many entries are judged, and how.
std::string counts_text(std::span<const CaseReport> reports);

}  // namespace runout
