#pragma once

#include "validation/case_runs.h"

namespace runout {

// The cases of the suite, by what they hold results against; suite.cpp puts them in the order of the page.

// Exact solutions.
ValidationCase numerics_case();
ValidationCase slab_case();
ValidationCase silo_case();
ValidationCase dam_break_case();
ValidationCase similarity_case();

// Granular columns and heaps of the laboratory.
ValidationCase aluminium_column_case();
ValidationCase tall_columns_case();
ValidationCase column_run_out_case();
ValidationCase poured_heap_case();

// Chutes and cut slopes of the paper.
ValidationCase box_45_case();
ValidationCase box_70_case();
ValidationCase drop_height_case();
ValidationCase idealised_sources_case();

}  // namespace runout
