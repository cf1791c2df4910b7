#include "store/record.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/units.h"
#include "store/known_tables.h"
#include "store/real_value.h"
#include "store/schema_comments.h"

namespace runout {
namespace {

using SQLite::Database;
using SQLite::Statement;

/// The rows that say what was asked and answered: from run on, each found by the one before.
constexpr const char* joined_rows =
    "run JOIN scenario USING (scenario_id) JOIN source USING (source_id)"
    " JOIN section USING (section_id) LEFT JOIN measure ON measure.run_id = run.run_id";
constexpr std::array described_tables = {"run", "scenario", "source", "section", "measure"};
constexpr std::array read_elsewhere = {"series", "deposit_profile", "snapshot", "frame",
                                       "stage",  "phase_time",      "envelope"};

template <std::size_t Count>
bool is_among(const std::array<const char*, Count>& names, const std::string& name) {
    return std::ranges::any_of(names, [&](const char* known) { return name == known; });
}

StoredValue value_of(const SQLite::Column& column) {
    if (column.isInteger()) return static_cast<long>(column.getInt64());
    if (column.isFloat() && std::isfinite(column.getDouble())) return column.getDouble();
    if (column.isText()) return column.getString();
    return {};
}

std::string comment_on(const std::string& table, const std::string& column) {
    const auto& comments = schema_comments().columns;
    const auto found = comments.find(table + "." + column);
    return found == comments.end() ? "" : found->second;
}

std::vector<std::string> words(Database& database, const std::string& sql, const std::string& value) {
    Statement statement(database, sql);
    statement.bind(1, value);
    std::vector<std::string> found;
    while (statement.executeStep()) found.push_back(statement.getColumn(0).getString());
    return found;
}

std::vector<Vec2> points(Database& database, const std::string& sql, long id) {
    Statement statement(database, sql);
    statement.bind(1, id);
    std::vector<Vec2> found;
    while (statement.executeStep())
        found.emplace_back(coordinate(statement.getColumn(0)), coordinate(statement.getColumn(1)));
    return found;
}

std::vector<Vec2> source_points(Database& database, const char* part, long source_id) {
    return points(database,
                  fmt::format("SELECT x_m, y_m FROM source_point WHERE source_id = ? AND part = '{}'"
                              " ORDER BY point_index",
                              part),
                  source_id);
}

/// What everything that draws a section relies on.
void check_geometry(const SectionGeometry& geometry, long run_id) {
    const Profile& profile = geometry.profile;
    const std::size_t count = profile.ground.size();
    if (count < 2 || profile.crest >= count || profile.toe >= count)
        throw DamagedData(fmt::format("has no ground for the toe and the crest of run {}", run_id));
    if (geometry.outline.size() < 3 || geometry.bed.size() < 2)
        throw DamagedData(fmt::format("has no source for run {}", run_id));
}

StoredTable rows_of(Database& database, const std::string& table, long run_id) {
    StoredTable found{table, {}, {}, {}};
    const auto& meanings = schema_comments().tables;
    if (const auto meaning = meanings.find(table); meaning != meanings.end()) found.meaning = meaning->second;
    found.columns = words(database,
                          "SELECT name FROM pragma_table_info(?) WHERE type <> 'BLOB'"
                          " AND name NOT IN ('run_id', 'row_index')",
                          table);
    std::erase_if(found.columns, [&](const std::string& name) { return !known_table(table).has(name); });
    if (found.columns.empty()) return found;
    Statement statement(
        database, fmt::format("SELECT {} FROM {} WHERE run_id = ?", fmt::join(found.columns, ", "), table));
    statement.bind(1, run_id);
    while (statement.executeStep()) {
        auto& row = found.rows.emplace_back();
        for (int i = 0; i < statement.getColumnCount(); ++i) row.push_back(value_of(statement.getColumn(i)));
    }
    return found;
}

}  // namespace

SectionGeometry select_geometry(Database& database, long run_id) {
    Statement statement(
        database, fmt::format("SELECT section.section_id, source_id, toe_chainage_m, toe_elevation_m,"
                              " descends_with_chainage, crest_index, toe_index, section_origin, exit_x_m,"
                              " exit_y_m, head_x_m, head_y_m, discontinuity_angle_deg FROM {}"
                              " WHERE run.run_id = ?",
                              joined_rows));
    statement.bind(1, run_id);
    if (!statement.executeStep())
        throw DamagedData(fmt::format("has no scenario, source or section for run {}", run_id));
    const auto real = [&](int column) { return coordinate(statement.getColumn(column)); };
    SectionGeometry geometry;
    geometry.section_id = statement.getColumn(0).getInt64();
    const long source_id = statement.getColumn(1).getInt64();
    geometry.profile.toe_chainage_m = real(2);
    geometry.profile.toe_elevation_m = real(3);
    geometry.profile.descends_with_chainage = statement.getColumn(4).getInt() == 1;
    geometry.profile.crest = static_cast<std::size_t>(statement.getColumn(5).getInt64());
    geometry.profile.toe = static_cast<std::size_t>(statement.getColumn(6).getInt64());
    geometry.profile.origin = statement.getColumn(7).getString();
    geometry.exit_point = {real(8), real(9)};
    geometry.head = {real(10), real(11)};
    geometry.discontinuity_angle = radians(real(12));
    geometry.profile.ground =
        points(database, "SELECT x_m, y_m FROM section_point WHERE section_id = ? ORDER BY point_index",
               geometry.section_id);
    geometry.outline = source_points(database, "outline", source_id);
    geometry.bed = source_points(database, "bed", source_id);
    check_geometry(geometry, run_id);
    return geometry;
}

std::vector<StoredFact> select_facts(Database& database, long run_id) {
    std::vector<StoredFact> facts;
    for (const std::string table : described_tables) {
        Statement statement(database,
                            fmt::format("SELECT {}.* FROM {} WHERE run.run_id = ?", table, joined_rows));
        statement.bind(1, run_id);
        if (!statement.executeStep())
            throw DamagedData(fmt::format("has no scenario, source or section for run {}", run_id));
        for (int i = 0; i < statement.getColumnCount(); ++i) {
            const std::string column = statement.getColumnName(i);
            if (column.ends_with("_id") || column.ends_with("_index")) continue;
            facts.push_back({table, column, comment_on(table, column), value_of(statement.getColumn(i))});
        }
    }
    return facts;
}

std::vector<StoredTable> select_further_tables(Database& database, long run_id) {
    std::vector<StoredTable> tables;
    for (const auto& [name, columns] : known_tables()) {
        if (!known_table(name).has("run_id")) continue;
        if (is_among(described_tables, name) || is_among(read_elsewhere, name)) continue;
        StoredTable table = rows_of(database, name, run_id);
        if (!table.rows.empty()) tables.push_back(std::move(table));
    }
    return tables;
}

}  // namespace runout
