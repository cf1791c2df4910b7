#pragma once

#include <string>
#include <vector>

#include "store/store.h"

namespace runout {

enum class TableFormat { text, csv, json };

// What is printed of stored runs. Every text ends with a newline. Of a run that is not a result (is_result in
// engine/status.h) no measure is printed anywhere: its status stands in their place, and the database has the
// rest.

/// The runs as one table, a line each. CSV and JSON have all columns, named as in the database.
std::string run_table(const std::vector<StoredRun>& runs, TableFormat format);

/// One JSON object with every measure, keys as in the database. What does not exist is null.
std::string run_json(const StoredRun& run);

/// A few lines for people: how far, how thick, how sure, how long it took.
std::string run_summary(const StoredRun& run);

/// Seconds of wall time in each phase of a run's steps and their share of the whole, a line each, for people.
/// Empty where no time was taken.
std::string time_table(const std::vector<PhaseTime>& phases);

/// What speaks against the toe and crest that a run counts from, a sentence each.
std::vector<std::string> section_doubts(const StoredRun& run);

/// Of a run whose front has the definition of before database 10.
std::string former_front_sentence();

/// A sentence when the particles were too coarse for the front; empty otherwise.
std::string resolution_warning(const StoredRun& run);

/// How a run that is not a result ended, in words; empty for one that is.
std::string status_reason(RunStatus status);

}  // namespace runout
