#include "store/chart_rows.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/ranges.h>

#include <array>
#include <limits>

#include "store/real_value.h"

namespace runout {
namespace {

struct NumberColumn {
    const char* sql;
    double ChartRow::*value;
};
constexpr std::array number_columns = {
    NumberColumn{"section.slope_angle_deg", &ChartRow::slope_angle_deg},
    NumberColumn{"source.head_y_m", &ChartRow::head_height_m},
    NumberColumn{"source.area_m2", &ChartRow::source_area_m2},
    NumberColumn{"source.front_area_m2", &ChartRow::front_area_m2},
    NumberColumn{"source.discontinuity_angle_deg", &ChartRow::discontinuity_angle_deg},
    NumberColumn{"scenario.friction_angle_deg", &ChartRow::friction_angle_deg},
    NumberColumn{"run.particle_spacing_m", &ChartRow::particle_spacing_m},
    NumberColumn{"measure.run_out_m", &ChartRow::run_out_m},
};

ChartRow read_row(const SQLite::Statement& statement) {
    ChartRow row;
    int place = 0;
    row.run_id = statement.getColumn(place++).getInt64();
    row.source_id = statement.getColumn(place++).getInt64();
    row.status = statement.getColumn(place++).getString();
    row.front_definition = statement.getColumn(place++).getString();
    row.effects = statement.getColumn(place++).getString();
    for (const NumberColumn& column : number_columns) {
        const SQLite::Column number = statement.getColumn(place++);
        row.*column.value = real_value(number);
    }
    return row;
}

}  // namespace

std::string chart_rows_sql(bool of_study) {
    std::vector<const char*> names;
    for (const NumberColumn& column : number_columns) names.push_back(column.sql);
    return fmt::format(
        "SELECT run.run_id, source.source_id, run.status, run.front_definition,"
        " coalesce((SELECT group_concat(effect || '.' || key || ' = ' || value, ', ') FROM effect_setting"
        " WHERE effect_setting.scenario_id = scenario.scenario_id), ''), {}"
        " FROM scenario"
        " JOIN source ON source.source_id = scenario.source_id"
        " JOIN section ON section.section_id = source.section_id"
        " JOIN run ON run.run_id = (SELECT max(latest.run_id) FROM run AS latest"
        " WHERE latest.scenario_id = scenario.scenario_id AND latest.status <> 'interrupted')"
        " JOIN measure ON measure.run_id = run.run_id{} ORDER BY scenario.scenario_id",
        fmt::join(names, ", "),
        of_study ? " WHERE scenario.scenario_hash IN"
                   " (SELECT scenario_hash FROM study_scenario WHERE study_id = ?)"
                 : "");
}

std::vector<ChartRow> select_chart_rows(SQLite::Database& database, std::optional<long> study_id) {
    SQLite::Statement statement(database, chart_rows_sql(study_id.has_value()));
    if (study_id) statement.bind(1, *study_id);
    std::vector<ChartRow> rows;
    while (statement.executeStep()) rows.push_back(read_row(statement));
    return rows;
}

}  // namespace runout
