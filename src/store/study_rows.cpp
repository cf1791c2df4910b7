#include "store/study_rows.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/ranges.h>

#include <array>
#include <limits>

#include "store/known_tables.h"
#include "store/real_value.h"

namespace runout {
namespace {

using SQLite::Database;
using SQLite::Statement;

struct NumberColumn {
    const char* sql;
    double StudyRow::*value;
};
constexpr std::array number_columns = {
    NumberColumn{"section.slope_angle_deg", &StudyRow::slope_angle_deg},
    NumberColumn{"scenario.friction_angle_deg", &StudyRow::friction_angle_deg},
    NumberColumn{"source.area_m2", &StudyRow::source_area_m2},
    NumberColumn{"source.front_area_m2", &StudyRow::front_area_m2},
    NumberColumn{"source.drop_height_m", &StudyRow::drop_height_m},
    NumberColumn{"measure.farthest_front_m", &StudyRow::farthest_front_m},
    NumberColumn{"measure.run_out_m", &StudyRow::run_out_m},
    NumberColumn{"measure.run_out_normalised", &StudyRow::run_out_normalised},
    NumberColumn{"measure.reach_angle_deg", &StudyRow::reach_angle_deg},
    NumberColumn{"measure.deposit_height_m", &StudyRow::deposit_height_m},
    NumberColumn{"run.run_out_error_m", &StudyRow::run_out_error_m},
    NumberColumn{"run.reach_angle_error_deg", &StudyRow::reach_angle_error_deg},
};

struct TextColumn {
    const char* sql;
    std::string StudyRow::*value;
};
constexpr std::array text_columns = {
    TextColumn{"run.name", &StudyRow::name},
    TextColumn{"run.section_origin", &StudyRow::section_origin},
    TextColumn{"source.source_type", &StudyRow::source_type},
    TextColumn{"run.status", &StudyRow::status},
    TextColumn{"run.status_detail", &StudyRow::status_detail},
    TextColumn{"run.front_definition", &StudyRow::front_definition},
};

StudyRow read_row(const Statement& statement) {
    StudyRow row;
    int place = 0;
    row.scenario.index = statement.getColumn(place++).getInt64();
    row.scenario.scenario_hash = statement.getColumn(place++).getString();
    row.scenario.inputs = statement.getColumn(place++).getString();
    row.scenario.refusal = statement.getColumn(place++).getString();
    if (statement.getColumn(place++).getInt() == 0)
        throw DamagedData(
            fmt::format("has a scenario {} of a study whose inputs are no JSON object", row.scenario.index));
    const SQLite::Column id = statement.getColumn(place++);
    if (!id.isNull()) row.run_id = id.getInt64();
    row.is_result = statement.getColumn(place++).getInt() != 0;
    for (const TextColumn& column : text_columns)
        row.*column.value = statement.getColumn(place++).getString();
    for (const NumberColumn& column : number_columns) {
        const SQLite::Column number = statement.getColumn(place++);
        row.*column.value = real_value(number);
    }
    return row;
}

}  // namespace

long study_row(Database& database, const std::string& name, const std::string& text) {
    Statement known(database, "SELECT study_id, text FROM study WHERE name = ?");
    known.bind(1, name);
    if (!known.executeStep()) {
        Statement insert(database, "INSERT INTO study (name, text) VALUES (?, ?)");
        SQLite::bind(insert, name, text);
        insert.exec();
        return database.getLastInsertRowid();
    }
    const long study_id = known.getColumn(0).getInt64();
    if (known.getColumn(1).getString() == text) return study_id;
    Statement forget(database, "DELETE FROM study_scenario WHERE study_id = ?");
    forget.bind(1, study_id);
    forget.exec();
    Statement update(database, "UPDATE study SET text = ? WHERE study_id = ?");
    SQLite::bind(update, text, study_id);
    update.exec();
    return study_id;
}

void set_study_scenarios(Database& database, long study_id, const std::vector<StudyScenario>& rows) {
    Statement statement(database,
                        "INSERT OR REPLACE INTO study_scenario"
                        " (study_id, scenario_index, scenario_hash, inputs, refusal) VALUES (?, ?, ?, ?, ?)");
    for (const StudyScenario& row : rows) {
        SQLite::bind(statement, study_id, row.index, row.scenario_hash, row.inputs, row.refusal);
        statement.exec();
        statement.reset();
    }
}

std::vector<StoredStudy> select_studies(Database& database) {
    Statement statement(database,
                        "SELECT study_id, name, text, (SELECT count(*) FROM study_scenario"
                        " WHERE study_scenario.study_id = study.study_id) FROM study ORDER BY study_id");
    std::vector<StoredStudy> studies;
    while (statement.executeStep())
        studies.push_back({statement.getColumn(0).getInt64(), statement.getColumn(1).getString(),
                           statement.getColumn(2).getString(), statement.getColumn(3).getInt64()});
    return studies;
}

std::string study_rows_sql() {
    std::vector<std::string> names;
    for (const TextColumn& column : text_columns) names.emplace_back(column.sql);
    for (const NumberColumn& column : number_columns) names.emplace_back(column.sql);
    return fmt::format(
        "SELECT study_scenario.scenario_index, study_scenario.scenario_hash, study_scenario.inputs,"
        " study_scenario.refusal, iif(json_valid(study_scenario.inputs),"
        " json_type(study_scenario.inputs) = 'object', 0), run.run_id, coalesce(run_status.is_result, 0), {}"
        " FROM study_scenario"
        " LEFT JOIN scenario ON scenario.scenario_hash = study_scenario.scenario_hash"
        " LEFT JOIN source ON source.source_id = scenario.source_id"
        " LEFT JOIN section ON section.section_id = source.section_id"
        " LEFT JOIN run ON run.run_id = (SELECT max(latest.run_id) FROM run AS latest"
        " WHERE latest.scenario_id = scenario.scenario_id AND latest.status <> 'interrupted')"
        " LEFT JOIN run_status ON run_status.status = run.status"
        " LEFT JOIN measure ON measure.run_id = run.run_id"
        " WHERE study_scenario.study_id = ? ORDER BY study_scenario.scenario_index",
        fmt::join(names, ", "));
}

std::vector<StudyRow> select_study_rows(Database& database, long study_id) {
    Statement statement(database, study_rows_sql());
    statement.bind(1, study_id);
    std::vector<StudyRow> rows;
    while (statement.executeStep()) rows.push_back(read_row(statement));
    return rows;
}

}  // namespace runout
