#pragma once

#include <string>
#include <vector>

#include "scene/case_spec.h"

namespace runout {

/// The files that a case reads: itself, those it names, and those that belong to them. No output may replace
/// them.
std::vector<std::string> input_files(const CaseSpec& spec);

}  // namespace runout
