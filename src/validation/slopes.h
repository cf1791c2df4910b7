#pragma once

#include "validation/case_runs.h"

namespace runout {

ValidationCase box_45_case();
ValidationCase box_70_case();
ValidationCase drop_height_case();
ValidationCase idealised_sources_case();

}  // namespace runout
