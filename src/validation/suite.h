#pragma once

#include <span>

#include "validation/case_runs.h"

namespace runout {

/// All cases of the suite, in the order of the page.
std::span<const ValidationCase> validation_cases();

}  // namespace runout
