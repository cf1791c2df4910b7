#include "store/effect_rows.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/VariadicBind.h>

#include <algorithm>
#include <limits>

#include "scene/effect_settings.h"
#include "store/real_value.h"

namespace runout {
namespace {

using SQLite::Database;
using SQLite::Statement;

/// Runs an INSERT once with these values.
template <class... Values>
void insert(Statement& statement, const Values&... values) {
    SQLite::bind(statement, values...);
    statement.exec();
    statement.reset();
}

void insert_gauge(Database& database, long run_id, long index, const GaugeRecord& gauge) {
    Statement whole(
        database,
        "INSERT INTO gauge (run_id, gauge_index, name, chainage_m, arrival_time_s, greatest_thickness_m,"
        " greatest_speed_m_s, greatest_kinetic_head_m, passed_area_m2) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
    insert(whole, run_id, index, gauge.name, gauge.chainage_m, gauge.arrival_time_s,
           gauge.greatest_thickness_m, gauge.greatest_speed_m_s, gauge.greatest_kinetic_head_m,
           gauge.passed_area_m2);
    Statement row(database,
                  "INSERT INTO gauge_series (run_id, gauge_index, row_index, time_s, thickness_m, speed_m_s,"
                  " kinetic_head_m, passed_area_m2) VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
    long i = 0;
    for (const GaugeRow& r : gauge.rows)
        insert(row, run_id, index, i++, r.time_s, r.thickness_m, r.speed_m_s, r.kinetic_head_m,
               r.passed_area_m2);
}

void insert_barrier(Database& database, long run_id, const BarrierRecord& b) {
    Statement whole(database,
                    "INSERT INTO barrier (run_id, arrival_time_s, greatest_force_n_m, greatest_force_time_s,"
                    " greatest_moment_n, impulse_n_s_m, last_force_n_m, run_up_m, overtopped_area_m2,"
                    " approach_speed_m_s, approach_thickness_m, design_force_n_m)"
                    " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    insert(whole, run_id, b.arrival_time_s, b.greatest_force_n_m, b.greatest_force_time_s,
           b.greatest_moment_n, b.impulse_n_s_m, b.last_force_n_m, b.run_up_m, b.overtopped_area_m2,
           b.approach_speed_m_s, b.approach_thickness_m, b.design_force_n_m);
    Statement row(database,
                  "INSERT INTO barrier_series (run_id, row_index, time_s, force_x_n_m, force_y_n_m, moment_n,"
                  " impulse_x_n_s_m) VALUES (?, ?, ?, ?, ?, ?, ?)");
    long i = 0;
    for (const BarrierRow& r : b.rows)
        insert(row, run_id, i++, r.time_s, r.force_x_n_m, r.force_y_n_m, r.moment_n, r.impulse_x_n_s_m);
}

std::vector<GaugeRow> select_gauge_rows(Database& database, long run_id, long gauge) {
    Statement row(database,
                  "SELECT time_s, thickness_m, speed_m_s, kinetic_head_m, passed_area_m2 FROM gauge_series"
                  " WHERE run_id = ? AND gauge_index = ? ORDER BY row_index");
    SQLite::bind(row, run_id, gauge);
    std::vector<GaugeRow> rows;
    while (row.executeStep())
        rows.push_back({real_value(row.getColumn(0)), real_value(row.getColumn(1)),
                        real_value(row.getColumn(2)), real_value(row.getColumn(3)),
                        real_value(row.getColumn(4))});
    return rows;
}

void select_gauges(Database& database, StoredRun& run) {
    Statement whole(
        database,
        "SELECT name, chainage_m, arrival_time_s, greatest_thickness_m, greatest_speed_m_s,"
        " greatest_kinetic_head_m, passed_area_m2 FROM gauge WHERE run_id = ? ORDER BY gauge_index");
    whole.bind(1, run.run_id);
    while (whole.executeStep()) {
        const long index = static_cast<long>(run.gauges.size());
        run.gauges.push_back(
            {whole.getColumn(0).getString(), real_value(whole.getColumn(1)), real_value(whole.getColumn(2)),
             real_value(whole.getColumn(3)), real_value(whole.getColumn(4)), real_value(whole.getColumn(5)),
             real_value(whole.getColumn(6)), select_gauge_rows(database, run.run_id, index)});
    }
}

std::vector<BarrierRow> select_barrier_rows(Database& database, long run_id) {
    Statement row(database,
                  "SELECT time_s, force_x_n_m, force_y_n_m, moment_n, impulse_x_n_s_m FROM barrier_series"
                  " WHERE run_id = ? ORDER BY row_index");
    row.bind(1, run_id);
    std::vector<BarrierRow> rows;
    while (row.executeStep())
        rows.push_back({real_value(row.getColumn(0)), real_value(row.getColumn(1)),
                        real_value(row.getColumn(2)), real_value(row.getColumn(3)),
                        real_value(row.getColumn(4))});
    return rows;
}

void select_barrier(Database& database, StoredRun& run) {
    Statement whole(database,
                    "SELECT arrival_time_s, greatest_force_n_m, greatest_force_time_s, greatest_moment_n,"
                    " impulse_n_s_m, last_force_n_m, run_up_m, overtopped_area_m2, approach_speed_m_s,"
                    " approach_thickness_m, design_force_n_m FROM barrier WHERE run_id = ?");
    whole.bind(1, run.run_id);
    while (whole.executeStep()) {
        const auto value = [&](int column) { return real_value(whole.getColumn(column)); };
        run.barriers.push_back({value(0), value(1), value(2), value(3), value(4), value(5), value(6),
                                value(7), value(8), value(9), value(10),
                                select_barrier_rows(database, run.run_id)});
    }
}

/// The effects that were on, among all that the program knows.
std::vector<EffectRow> select_states(Database& database, long run_id) {
    std::vector<EffectRow> rows;
    for (const EffectState& off : effect_states({}, 0))
        rows.push_back({off.name, off.on, off.meaning, std::numeric_limits<double>::quiet_NaN()});
    Statement effect(database, "SELECT effect, why, cost_s FROM run_effect WHERE run_id = ?");
    effect.bind(1, run_id);
    while (effect.executeStep()) {
        const std::string name = effect.getColumn(0).getString();
        const auto row = std::ranges::find(rows, name, &EffectRow::name);
        if (row != rows.end())
            *row = {name, true, effect.getColumn(1).getString(), real_value(effect.getColumn(2))};
    }
    return rows;
}

std::vector<EffectSetting> select_settings(Database& database, long run_id) {
    Statement setting(database,
                      "SELECT effect, key, value FROM run JOIN effect_setting USING (scenario_id)"
                      " WHERE run_id = ? ORDER BY setting_index");
    setting.bind(1, run_id);
    std::vector<EffectSetting> settings;
    while (setting.executeStep())
        settings.push_back({setting.getColumn(0).getString(), setting.getColumn(1).getString(),
                            setting.getColumn(2).getString()});
    return settings;
}

}  // namespace

void insert_effect_settings(Database& database, long scenario_id, const Scene& scene) {
    Statement statement(database,
                        "INSERT INTO effect_setting (scenario_id, setting_index, effect, key, value)"
                        " VALUES (?, ?, ?, ?, ?)");
    long i = 0;
    for (const EffectSetting& setting : effect_settings(scene.effects, scene.profile))
        insert(statement, scenario_id, i++, setting.effect, setting.key, setting.value);
}

void insert_effects(Database& database, long run_id, const RunResult& result) {
    Statement effect(
        database, "INSERT INTO run_effect (run_id, row_index, effect, why, cost_s) VALUES (?, ?, ?, ?, ?)");
    long i = 0;
    for (const EffectRow& row : result.effects)
        if (row.on) insert(effect, run_id, i++, row.name, row.why, row.cost_s);
    Statement advice(database, "INSERT INTO advice (run_id, row_index, sentence) VALUES (?, ?, ?)");
    i = 0;
    for (const std::string& sentence : result.advice) insert(advice, run_id, i++, sentence);
    i = 0;
    for (const GaugeRecord& gauge : result.gauges) insert_gauge(database, run_id, i++, gauge);
    for (const BarrierRecord& barrier : result.barriers) insert_barrier(database, run_id, barrier);
}

void select_effects(Database& database, StoredRun& run) {
    run.effects = select_states(database, run.run_id);
    run.effect_settings = select_settings(database, run.run_id);
    Statement advice(database, "SELECT sentence FROM advice WHERE run_id = ? ORDER BY row_index");
    advice.bind(1, run.run_id);
    while (advice.executeStep()) run.advice.push_back(advice.getColumn(0).getString());
    select_gauges(database, run);
    select_barrier(database, run);
}

}  // namespace runout
