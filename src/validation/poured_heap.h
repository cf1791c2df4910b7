#pragma once

#include "validation/case_runs.h"

namespace runout {

ValidationCase poured_heap_case();

}  // namespace runout
