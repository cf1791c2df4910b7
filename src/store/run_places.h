#pragma once

#include <optional>
#include <vector>

#include "store/store.h"

namespace SQLite {
class Database;
}

namespace runout {

/// Gives a run its line on the map; lines that are already there are shared. Call it within a transaction.
void set_map_line(SQLite::Database& database, long run_id, const MapLine& line);

/// What the map says of the run's section; empty where it lies on none.
std::vector<Attribute> select_attributes(SQLite::Database& database, long run_id);

std::optional<RunPlace> select_place(SQLite::Database& database, long run_id);
Question select_question(SQLite::Database& database, long run_id);

}  // namespace runout
