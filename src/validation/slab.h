#pragma once

#include "validation/case_runs.h"

namespace runout {

ValidationCase slab_case();

}  // namespace runout
