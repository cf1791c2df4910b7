#pragma once

#include <optional>
#include <vector>

#include "store/store.h"

namespace SQLite {
class Database;
}

namespace runout {

/// The id of a line on the map; one that is already there is shared. Call it within a transaction.
long map_line_row(SQLite::Database& database, const MapLine& line);
MapLine select_map_line(SQLite::Database& database, long line_id);

/// Gives a run its line on the map; Call it within a transaction.
void set_map_line(SQLite::Database& database, long run_id, const MapLine& line);

/// What the map says of the run's section; empty where it lies on none.
std::vector<Attribute> select_attributes(SQLite::Database& database, long run_id);

std::optional<RunPlace> select_place(SQLite::Database& database, long run_id);
Question select_question(SQLite::Database& database, long run_id);

}  // namespace runout
