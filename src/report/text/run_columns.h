#pragma once

#include <string>
#include <vector>

#include "store/store.h"

namespace runout {

/// Nothing, or a value as the database has it.
using Cell = FieldValue;

struct RunColumn {
    std::string name;
    Cell value;
};

/// All that is printed of a run by machine-readable formats, named as in the database. Measures of a run that
/// is not a result, and numbers that do not exist, are empty.
std::vector<RunColumn> run_columns(const StoredRun& run);

}  // namespace runout
