#pragma once

#include "validation/case_runs.h"

namespace runout {

ValidationCase aluminium_column_case();
ValidationCase tall_columns_case();
ValidationCase column_run_out_case();

}  // namespace runout
