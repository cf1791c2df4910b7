#include "store/migrations.h"

#include <SQLiteCpp/Database.h>
#include <fmt/format.h>

namespace runout {

// Version 1 is the first, so there is nothing to bring up to date yet. A step is SQL in the manner of
//     {1, "ALTER TABLE scenario ADD COLUMN cohesion_pa REAL NOT NULL DEFAULT 0;"}
// and db/schema.sql says the same for new files.
std::span<const Migration> migrations() {
    return {};
}

void migrate(SQLite::Database& database, std::span<const Migration> steps) {
    for (const Migration& step : steps) {
        if (database.execAndGet("PRAGMA user_version").getInt() != step.from) continue;
        database.exec(step.sql);
        database.exec(fmt::format("PRAGMA user_version = {}", step.from + 1));
    }
}

}  // namespace runout
