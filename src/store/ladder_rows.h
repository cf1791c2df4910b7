#pragma once

#include <optional>
#include <string>
#include <vector>

#include "store/store.h"

namespace SQLite {
class Database;
}

namespace runout {

/// Adds a study with its rows and returns its ladder_id. Call it within a transaction.
long insert_ladder(SQLite::Database& database, const StoredLadder& ladder);

/// All studies in the order of their ids.
std::vector<StoredLadder> select_ladders(SQLite::Database& database);

/// The latest study of a question.
std::optional<StoredLadder> select_ladder_of(SQLite::Database& database, const std::string& question_hash);

}  // namespace runout
