#pragma once

#include <span>

namespace SQLite {
class Database;
}

namespace runout {

/// One step of the format: what turns user_version `from` into `from` + 1.
struct Migration {
    int from;
    const char* sql;
};

/// All steps up to the version of db/schema.sql, oldest first.
std::span<const Migration> migrations();

/// Applies the steps that the database has not seen and sets user_version. Call it within a transaction.
void migrate(SQLite::Database& database, std::span<const Migration> steps);

}  // namespace runout
