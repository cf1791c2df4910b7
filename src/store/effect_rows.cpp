#include "store/effect_rows.h"

#include <SQLiteCpp/VariadicBind.h>

#include <algorithm>
#include <limits>

#include "scene/effect_settings.h"
#include "store/column_rows.h"

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

void insert_place(Database& database, long run_id, long index, const PlaceRecord& record) {
    std::vector<std::string> names = {"run_id", "place_index", "name", "kind"};
    append_names(names, place_columns());
    Statement whole(database, insert_sql("place", names));
    SQLite::bind(whole, run_id, index, record.name, record.kind);
    int place = 4;
    bind_numbers(whole, place, record, place_columns());
    whole.exec();
    Statement row(database,
                  "INSERT INTO place_series (run_id, place_index, row_index, time_s, thickness_m, speed_m_s,"
                  " kinetic_head_m, passed_area_m2) VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
    long i = 0;
    for (const PlaceRow& r : record.rows)
        insert(row, run_id, index, i++, r.time_s, r.thickness_m, r.speed_m_s, r.kinetic_head_m,
               r.passed_area_m2);
}

void insert_barrier(Database& database, long run_id, const BarrierRecord& b) {
    std::vector<std::string> names = {"run_id"};
    append_names(names, barrier_columns());
    Statement whole(database, insert_sql("barrier", names));
    whole.bind(1, run_id);
    int place = 1;
    bind_numbers(whole, place, b, barrier_columns());
    whole.exec();
    Statement row(database,
                  "INSERT INTO barrier_series (run_id, row_index, time_s, force_x_n_m, force_y_n_m, moment_n,"
                  " impulse_x_n_s_m) VALUES (?, ?, ?, ?, ?, ?, ?)");
    long i = 0;
    for (const BarrierRow& r : b.rows)
        insert(row, run_id, i++, r.time_s, r.force_x_n_m, r.force_y_n_m, r.moment_n, r.impulse_x_n_s_m);
}

std::vector<PlaceRow> select_place_rows(Database& database, long run_id, long number) {
    Statement row(database,
                  "SELECT time_s, thickness_m, speed_m_s, kinetic_head_m, passed_area_m2 FROM place_series"
                  " WHERE run_id = ? AND place_index = ? ORDER BY row_index");
    SQLite::bind(row, run_id, number);
    std::vector<PlaceRow> rows;
    while (row.executeStep())
        rows.push_back({real_value(row.getColumn(0)), real_value(row.getColumn(1)),
                        real_value(row.getColumn(2)), real_value(row.getColumn(3)),
                        real_value(row.getColumn(4))});
    return rows;
}

void select_places(Database& database, StoredRun& run) {
    std::vector<std::string> names = {"name", "kind"};
    append_names(names, place_columns());
    Statement whole(database, fmt::format("SELECT {} FROM place WHERE run_id = ? ORDER BY place_index",
                                          fmt::join(names, ", ")));
    whole.bind(1, run.run_id);
    while (whole.executeStep()) {
        const long index = static_cast<long>(run.places.size());
        PlaceRecord& record = run.places.emplace_back();
        record.name = whole.getColumn(0).getString();
        record.kind = whole.getColumn(1).getString();
        int place = 2;
        read_numbers(whole, place, record, place_columns());
        record.rows = select_place_rows(database, run.run_id, index);
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
    std::vector<std::string> names;
    append_names(names, barrier_columns());
    Statement whole(database, fmt::format("SELECT {} FROM barrier WHERE run_id = ?", fmt::join(names, ", ")));
    whole.bind(1, run.run_id);
    while (whole.executeStep()) {
        BarrierRecord& barrier = run.barriers.emplace_back();
        int place = 0;
        read_numbers(whole, place, barrier, barrier_columns());
        barrier.rows = select_barrier_rows(database, run.run_id);
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

void insert_effects(Database& database, long run_id, const StoredRun& run) {
    Statement effect(
        database, "INSERT INTO run_effect (run_id, row_index, effect, why, cost_s) VALUES (?, ?, ?, ?, ?)");
    long i = 0;
    for (const EffectRow& row : run.effects)
        if (row.on) insert(effect, run_id, i++, row.name, row.why, row.cost_s);
    Statement advice(database, "INSERT INTO advice (run_id, row_index, sentence) VALUES (?, ?, ?)");
    i = 0;
    for (const std::string& sentence : run.advice) insert(advice, run_id, i++, sentence);
    i = 0;
    for (const PlaceRecord& record : run.places) insert_place(database, run_id, i++, record);
    for (const BarrierRecord& barrier : run.barriers) insert_barrier(database, run_id, barrier);
}

void select_places(Database& database, std::vector<StoredRun>& runs) {
    std::vector<std::string> names = {"run_id", "name", "kind"};
    append_names(names, place_columns());
    Statement whole(database,
                    fmt::format("SELECT {} FROM place ORDER BY run_id, place_index", fmt::join(names, ", ")));
    auto run = runs.begin();
    while (whole.executeStep()) {
        const long run_id = whole.getColumn(0).getInt64();
        while (run != runs.end() && run->run_id < run_id) ++run;
        if (run == runs.end()) return;
        if (run->run_id != run_id) continue;
        PlaceRecord& record = run->places.emplace_back();
        record.name = whole.getColumn(1).getString();
        record.kind = whole.getColumn(2).getString();
        int place = 3;
        read_numbers(whole, place, record, place_columns());
    }
}

void select_effects(Database& database, StoredRun& run) {
    run.effects = select_states(database, run.run_id);
    run.effect_settings = select_settings(database, run.run_id);
    Statement advice(database, "SELECT sentence FROM advice WHERE run_id = ? ORDER BY row_index");
    advice.bind(1, run.run_id);
    while (advice.executeStep()) run.advice.push_back(advice.getColumn(0).getString());
    select_places(database, run);
    select_barrier(database, run);
}

}  // namespace runout
