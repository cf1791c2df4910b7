#include "store/known_tables.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "store/schema_sql.h"

namespace runout {
namespace {

using SQLite::Database;
using SQLite::Statement;

std::vector<std::string> columns_of(Database& database, const std::string& table) {
    Statement statement(database, "SELECT name FROM pragma_table_info(?) ORDER BY cid");
    statement.bind(1, table);
    std::vector<std::string> names;
    while (statement.executeStep()) names.push_back(statement.getColumn(0).getString());
    return names;
}

/// "table run", of everything but what SQLite makes for itself.
std::set<std::string> objects_of(Database& database) {
    Statement statement(database,
                        "SELECT type || ' ' || name FROM sqlite_schema WHERE name NOT LIKE 'sqlite\\_%'"
                        " ESCAPE '\\'");
    std::set<std::string> names;
    while (statement.executeStep()) names.insert(statement.getColumn(0).getString());
    return names;
}

/// What db/schema.sql makes of an empty file.
struct Format {
    std::vector<KnownTable> tables;
    std::set<std::string> objects;

    Format() {
        Database pristine(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        pristine.exec(schema_sql);
        objects = objects_of(pristine);
        for (const std::string& object : objects)
            if (object.starts_with("table ")) {
                const std::string name = object.substr(6);
                tables.push_back({name, columns_of(pristine, name)});
            }
    }
};

const Format& format() {
    static const Format known;
    return known;
}

void check_table(Database& database, const KnownTable& table) {
    Statement statement(database,
                        "SELECT type, \"strict\" FROM pragma_table_list WHERE schema = 'main' AND name = ?");
    statement.bind(1, table.name);
    if (!statement.executeStep()) throw DamagedData("has no table " + table.name);
    const std::string type = statement.getColumn(0).getString();
    if (type != "table")
        throw DamagedData(fmt::format("has a {} in place of the table {}", type, table.name));
    if (statement.getColumn(1).getInt() != 1)
        throw DamagedData(fmt::format("has a table {} whose columns may hold anything", table.name));
    const std::vector<std::string> columns = columns_of(database, table.name);
    for (const std::string& column : table.columns)
        if (std::ranges::find(columns, column) == columns.end())
            throw DamagedData(fmt::format("has a table {} without the column {}", table.name, column));
}

}  // namespace

bool KnownTable::has(const std::string& column) const {
    return std::ranges::find(columns, column) != columns.end();
}

const std::vector<KnownTable>& known_tables() {
    return format().tables;
}

const KnownTable& known_table(const std::string& name) {
    const auto found = std::ranges::find(known_tables(), name, &KnownTable::name);
    if (found == known_tables().end()) throw std::logic_error("db/schema.sql has no table " + name);
    return *found;
}

void check_tables(Database& database) {
    for (const KnownTable& table : known_tables()) check_table(database, table);
}

std::vector<std::string> foreign_objects(Database& database) {
    std::vector<std::string> foreign;
    std::ranges::set_difference(objects_of(database), format().objects, std::back_inserter(foreign));
    return foreign;
}

}  // namespace runout
