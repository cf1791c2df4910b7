#pragma once

#include <vector>

#include "store/store.h"

namespace SQLite {
class Database;
}

namespace runout {

/// Throws std::runtime_error when there is no such run.
SectionGeometry select_geometry(SQLite::Database& database, long run_id);

/// Every column of the rows that a run has in run, scenario, source, section and measure, keys between them
/// left out.
std::vector<StoredFact> select_facts(SQLite::Database& database, long run_id);

/// What a run has in tables beside those and beside series, deposit_profile, snapshot, frame, stage and
/// phase_time; blobs and empty tables left out.
std::vector<StoredTable> select_further_tables(SQLite::Database& database, long run_id);

}  // namespace runout
