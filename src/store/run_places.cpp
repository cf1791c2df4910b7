#include "store/run_places.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <type_traits>

#include "store/known_tables.h"
#include "store/real_value.h"
#include "store/scenario_hash.h"

namespace runout {
namespace {

using SQLite::Database;
using SQLite::Statement;

/// Columns of `scenario` that say how it is computed and not what is asked. A column that is added later
/// counts as part of the question until it is named here.
constexpr std::array<std::string_view, 13> numerical_columns = {
    "particle_spacing_m",  "resolution",         "courant",       "smoothing_ratio",   "friction_scheme",
    "friction_iterations", "pressure_tolerance", "time_limit_s",  "front_thickness_m", "sleeping",
    "lattice_seed",        "snapshot_times_s",   "front_window_m"};
constexpr std::array<std::string_view, 3> keys = {"scenario_id", "scenario_hash", "source_id"};

std::optional<long> line_of_run(Database& database, long run_id) {
    Statement statement(database, "SELECT line_id FROM run WHERE run_id = ?");
    statement.bind(1, run_id);
    if (!statement.executeStep() || statement.getColumn(0).isNull()) return std::nullopt;
    return statement.getColumn(0).getInt64();
}

std::optional<long> line_with(Database& database, const std::string& hash) {
    Statement statement(database, "SELECT line_id FROM map_line WHERE line_hash = ?");
    statement.bind(1, hash);
    if (!statement.executeStep()) return std::nullopt;
    return statement.getColumn(0).getInt64();
}

void insert_points(Database& database, long line_id, const MapLine& line) {
    Statement statement(
        database,
        "INSERT INTO map_line_point (line_id, point_index, chainage_m, x, y) VALUES (?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        SQLite::bind(statement, line_id, static_cast<long>(i), line.chainage_m[i], line.points[i].x(),
                     line.points[i].y());
        statement.exec();
        statement.reset();
    }
}

void insert_attributes(Database& database, long line_id, const std::vector<Attribute>& attributes) {
    Statement statement(
        database,
        "INSERT INTO map_line_attribute (line_id, attribute_index, name, value) VALUES (?, ?, ?, ?)");
    for (std::size_t i = 0; i < attributes.size(); ++i) {
        SQLite::bind(statement, line_id, static_cast<long>(i), attributes[i].name);
        std::visit(
            [&](const auto& value) {
                if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>)
                    statement.bind(4);
                else
                    statement.bind(4, value);
            },
            attributes[i].value);
        statement.exec();
        statement.reset();
    }
}

long insert_line(Database& database, const MapLine& line, const std::string& hash) {
    Statement statement(database, "INSERT INTO map_line (line_hash, crs) VALUES (?, ?)");
    SQLite::bind(statement, hash, line.crs);
    statement.exec();
    const long line_id = database.getLastInsertRowid();
    insert_points(database, line_id, line);
    insert_attributes(database, line_id, line.attributes);
    return line_id;
}

FieldValue value_of(const SQLite::Column& column) {
    if (column.isNull()) return {};
    if (column.isInteger()) return static_cast<long>(column.getInt64());
    if (column.isFloat() && std::isfinite(column.getDouble())) return column.getDouble();
    return column.getString();
}

std::vector<Attribute> attributes_of(Database& database, long line_id) {
    Statement statement(
        database, "SELECT name, value FROM map_line_attribute WHERE line_id = ? ORDER BY attribute_index");
    statement.bind(1, line_id);
    std::vector<Attribute> attributes;
    while (statement.executeStep())
        attributes.push_back({statement.getColumn(0).getString(), value_of(statement.getColumn(1))});
    return attributes;
}

/// Rows of (x, y) in the local frame, brought to the section.
Polyline section_points(Database& database, const std::string& query, long run_id, const Profile& frame) {
    Statement statement(database, query);
    statement.bind(1, run_id);
    Polyline points;
    while (statement.executeStep())
        points.push_back(
            frame.to_section({coordinate(statement.getColumn(0)), coordinate(statement.getColumn(1))}));
    return points;
}

constexpr const char* from_run = " FROM run JOIN scenario USING (scenario_id) JOIN source USING (source_id) ";

/// The columns of `scenario`, keys apart, that say how it is computed, or those that say what is asked.
std::vector<std::string> scenario_columns(bool numerical) {
    std::vector<std::string> names;
    for (const std::string& name : known_table("scenario").columns) {
        if (std::ranges::find(keys, name) != keys.end()) continue;
        const bool is_numerical = std::ranges::find(numerical_columns, name) != numerical_columns.end();
        if (is_numerical == numerical) names.push_back(fmt::format("'{}', scenario.{}", name, name));
    }
    return names;
}

/// What everything that puts a run on a map relies on.
void check_place(const RunPlace& place, long run_id) {
    if (place.bed.size() < 2 || place.source_outline.size() < 3 || place.line.points.size() < 2)
        throw DamagedData(fmt::format("has no place on the map for run {}", run_id));
}

}  // namespace

long map_line_row(Database& database, const MapLine& line) {
    const std::string hash = map_line_hash(line);
    const std::optional<long> known = line_with(database, hash);
    return known ? *known : insert_line(database, line, hash);
}

MapLine select_map_line(Database& database, long line_id) {
    MapLine line;
    Statement crs(database, "SELECT crs FROM map_line WHERE line_id = ?");
    crs.bind(1, line_id);
    if (crs.executeStep()) line.crs = crs.getColumn(0).getString();
    Statement points(database,
                     "SELECT chainage_m, x, y FROM map_line_point WHERE line_id = ? ORDER BY point_index");
    points.bind(1, line_id);
    while (points.executeStep()) {
        line.chainage_m.push_back(coordinate(points.getColumn(0)));
        line.points.emplace_back(coordinate(points.getColumn(1)), coordinate(points.getColumn(2)));
    }
    line.attributes = attributes_of(database, line_id);
    return line;
}

void set_map_line(Database& database, long run_id, const MapLine& line) {
    const long line_id = map_line_row(database, line);
    Statement statement(database, "UPDATE run SET line_id = ? WHERE run_id = ?");
    SQLite::bind(statement, line_id, run_id);
    statement.exec();
}

std::vector<Attribute> select_attributes(Database& database, long run_id) {
    const std::optional<long> line_id = line_of_run(database, run_id);
    return line_id ? attributes_of(database, *line_id) : std::vector<Attribute>{};
}

std::optional<RunPlace> select_place(Database& database, long run_id) {
    const std::optional<long> line_id = line_of_run(database, run_id);
    if (!line_id) return std::nullopt;
    Profile frame;
    Statement section(database, fmt::format("SELECT toe_chainage_m, toe_elevation_m, descends_with_chainage{}"
                                            "JOIN section USING (section_id) WHERE run_id = ?",
                                            from_run));
    section.bind(1, run_id);
    if (!section.executeStep()) throw DamagedData(fmt::format("has no section for run {}", run_id));
    frame.toe_chainage_m = coordinate(section.getColumn(0));
    frame.toe_elevation_m = coordinate(section.getColumn(1));
    frame.descends_with_chainage = section.getColumn(2).getInt() != 0;
    const auto points = [&](const std::string& columns, const std::string& rest) {
        return section_points(database, fmt::format("SELECT {}{}{}", columns, from_run, rest), run_id, frame);
    };
    RunPlace place;
    place.toe_chainage_m = frame.toe_chainage_m;
    place.toe_elevation_m = frame.toe_elevation_m;
    place.descends_with_chainage = frame.descends_with_chainage;
    const auto part = [&](const std::string& name) {
        return points("x_m, y_m",
                      fmt::format("JOIN source_point USING (source_id) WHERE run_id = ? AND part = '{}' "
                                  "ORDER BY point_index",
                                  name));
    };
    place.bed = part("bed");
    place.source_outline = part("outline");
    place.head = points("head_x_m, head_y_m", "WHERE run_id = ?").at(0);
    place.exit_point = points("exit_x_m, exit_y_m", "WHERE run_id = ?").at(0);
    place.line = select_map_line(database, *line_id);
    check_place(place, run_id);
    return place;
}

Question select_question(Database& database, long run_id) {
    Statement statement(database, fmt::format("SELECT json_object('source_type', source_type, {}), "
                                              "source_id, json_object({}){}WHERE run_id = ?",
                                              fmt::join(scenario_columns(false), ", "),
                                              fmt::join(scenario_columns(true), ", "), from_run));
    statement.bind(1, run_id);
    if (!statement.executeStep()) return {};
    return {statement.getColumn(0).getString(), statement.getColumn(1).getString(),
            statement.getColumn(2).getString()};
}

}  // namespace runout
