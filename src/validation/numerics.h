#pragma once

#include "validation/case_runs.h"

namespace runout {

ValidationCase numerics_case();

}  // namespace runout
