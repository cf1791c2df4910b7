#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace runout {

/// A database does not hold what its version says, or a row holds what cannot be. `what()` completes the name
/// of the file: "has no table run".
class DamagedData : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A table of db/schema.sql. Statements are made from these names only, never from names in a database.
struct KnownTable {
    std::string name;
    std::vector<std::string> columns;

    [[nodiscard]] bool has(const std::string& column) const;
};

/// All of them, in the order of their names.
const std::vector<KnownTable>& known_tables();
const KnownTable& known_table(const std::string& name);

/// Throws DamagedData when a table is missing, is a view or virtual, lacks a column, or lets a column hold
/// values of any type.
void check_tables(SQLite::Database& database);

/// What a database holds beside the format: "table notes", "trigger t". It is never read, run or changed.
std::vector<std::string> foreign_objects(SQLite::Database& database);

}  // namespace runout
