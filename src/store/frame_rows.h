#pragma once

#include <vector>

#include "measures/measures.h"

namespace SQLite {
class Database;
}

namespace runout {

/// Adds the frames of a run. Call it within its transaction.
void insert_frames(SQLite::Database& database, long run_id, const std::vector<Frame>& frames);

std::vector<Frame> select_frames(SQLite::Database& database, long run_id);

}  // namespace runout
