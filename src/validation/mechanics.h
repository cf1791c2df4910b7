#pragma once

#include "validation/case_runs.h"

namespace runout {

ValidationCase silo_case();
ValidationCase dam_break_case();
ValidationCase similarity_case();

}  // namespace runout
