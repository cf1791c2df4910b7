#include "store/known_tables.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string_view>

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

/// What may refuse a row of a table.
struct Constraints {
    long unique_indices = 0;
    std::string definition;
};

std::size_t checks_in(std::string sql) {
    std::erase_if(sql, [](unsigned char c) { return std::isspace(c) != 0; });
    std::ranges::transform(sql, sql.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::string_view word = "check(";
    std::size_t count = 0;
    for (std::size_t at = sql.find(word); at != std::string::npos; at = sql.find(word, at + 1)) ++count;
    return count;
}

/// Definitions that this program wrote are the same to the letter, and need no count.
bool equally_strict(const Constraints& a, const Constraints& b) {
    return a.unique_indices == b.unique_indices &&
           (a.definition == b.definition || checks_in(a.definition) == checks_in(b.definition));
}

Constraints constraints_of(Database& database, const std::string& table) {
    Statement indices(database, "SELECT count(*) FROM pragma_index_list(?) WHERE \"unique\" = 1");
    indices.bind(1, table);
    Statement definition(database, "SELECT sql FROM sqlite_schema WHERE type = 'table' AND name = ?");
    definition.bind(1, table);
    if (!indices.executeStep() || !definition.executeStep()) return {};
    return {indices.getColumn(0).getInt64(), definition.getColumn(0).getString()};
}

/// What db/schema.sql makes of an empty file.
struct Format {
    std::vector<KnownTable> tables;
    std::map<std::string, Constraints> constraints;
    std::set<std::string> objects;

    Format() {
        Database pristine(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        pristine.exec(schema_sql);
        objects = objects_of(pristine);
        for (const std::string& object : objects)
            if (object.starts_with("table ")) {
                const std::string name = object.substr(6);
                tables.push_back({name, columns_of(pristine, name)});
                constraints[name] = constraints_of(pristine, name);
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
    if (!equally_strict(constraints_of(database, table.name), format().constraints.at(table.name)))
        throw DamagedData(fmt::format("has a table {} with conditions that are not Runout's", table.name));
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
