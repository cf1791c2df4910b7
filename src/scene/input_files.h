#pragma once

#include <string>
#include <vector>

#include "scene/case_spec.h"

namespace runout {

/// The files that a case reads: itself, and those it names. No output may replace them.
std::vector<std::string> input_files(const CaseSpec& spec);

}  // namespace runout
