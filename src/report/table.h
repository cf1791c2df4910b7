#pragma once

#include <string>
#include <vector>

#include "store/store.h"

namespace runout {

enum class TableFormat { text, csv, json };

/// The stored runs as one table, a line each. Runs that did not settle show their status in place of numbers.
std::string run_table(const std::vector<StoredRun>& runs, TableFormat format);

/// One JSON object with every measure, keys as in the database. NaN becomes null.
std::string run_json(const StoredRun& run);

/// A few lines for people: how far, how thick, how sure, how long it took.
std::string run_summary(const StoredRun& run);

}  // namespace runout
