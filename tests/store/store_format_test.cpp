#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "core/units.h"
#include "store/columns.h"
#include "store/schema_comments.h"
#include "store_fixture.h"

// The format is what db/schema.sql says, for any program that reads it.

namespace runout {
namespace {

std::vector<std::string> columns_of(SQLite::Database& database, const std::string& table) {
    SQLite::Statement statement(database, "SELECT name FROM pragma_table_info('" + table + "') ORDER BY cid");
    std::vector<std::string> names;
    while (statement.executeStep()) names.push_back(statement.getColumn(0).getString());
    return names;
}

template <class Columns>
std::vector<std::string> names_of(std::vector<std::string> first, const Columns& columns) {
    for (const auto& column : columns) first.emplace_back(column.name);
    return first;
}

TEST_F(StoreTest, ColumnsAreTheMembersOfTheResultStructs) {
    add(example_scene(), example_result());
    SQLite::Database database = raw();
    EXPECT_EQ(columns_of(database, "measure"), names_of({"run_id"}, measure_fields()));
    EXPECT_EQ(columns_of(database, "series"), names_of({"run_id", "row_index"}, series_columns()));
    EXPECT_EQ(columns_of(database, "deposit_profile"), names_of({"run_id", "row_index"}, deposit_columns()));
    EXPECT_EQ(columns_of(database, "stage"), names_of({"run_id", "row_index"}, stage_columns()));
    EXPECT_EQ(columns_of(database, "snapshot"),
              names_of({"run_id", "row_index", "time_s"}, snapshot_columns()));

    const auto run = columns_of(database, "run");
    const auto work = names_of({}, work_columns());
    std::vector<std::string> counts = run;
    std::erase_if(counts,
                  [&](const std::string& name) { return std::ranges::find(work, name) == work.end(); });
    EXPECT_EQ(counts, work) << "in their order";
    for (const auto& column : appraisal_numbers())
        EXPECT_EQ(std::ranges::count(run, std::string(column.name)), 1) << column.name;
    for (const auto& column : appraisal_texts())
        EXPECT_EQ(std::ranges::count(run, std::string(column.name)), 1) << column.name;
    EXPECT_EQ(columns_of(database, "pilot"), names_of({"run_id", "row_index"}, pilot_columns()));
}

TEST(Columns, NameEveryMemberOnce) {
    EXPECT_EQ(measure_fields().size() * sizeof(double), sizeof(Measures));
    // Fails to compile when a member is added: then it needs a column too.
    const auto& [particles, boundary, spacing, steps, iterations, guard, density, simulated, wall, cpu,
                 threads, memory, spared] = RunWork{};
    EXPECT_EQ(work_columns().size(), 13U);
    EXPECT_EQ(threads, 1);

    RunWork work;
    for (const WorkColumn& column : work_columns())
        std::visit([&](auto member) { work.*member += 1; }, column.member);
    for (const WorkColumn& column : work_columns())
        std::visit([&](auto member) { EXPECT_EQ(work.*member - RunWork{}.*member, 1) << column.name; },
                   column.member);
}

TEST_F(StoreTest, MarksTheFileAsItsOwn) {
    add(example_scene(), example_result());
    SQLite::Database database = raw();
    EXPECT_EQ(database.execAndGet("PRAGMA application_id").getInt(), 0x52554E4F);  // RUNO
    EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), 10);
    EXPECT_EQ(database.execAndGet("PRAGMA journal_mode").getString(), "delete");
    EXPECT_EQ(database.execAndGet("PRAGMA integrity_check").getString(), "ok");
    EXPECT_EQ(count("pragma_foreign_key_check"), 0);
    EXPECT_EQ(count("pragma_table_list WHERE type = 'table' AND name NOT LIKE 'sqlite_%' AND NOT strict"), 0);
    EXPECT_EQ(files(), 1U) << "the one file is all there is between writes";
}

TEST_F(StoreTest, ForeignKeysHold) {
    const long run_id = add(example_scene(), example_result());
    SQLite::Database database = raw();
    database.exec("PRAGMA foreign_keys = ON");
    EXPECT_THROW(database.exec("DELETE FROM scenario"), SQLite::Exception);
    EXPECT_THROW(database.exec("INSERT INTO measure (run_id) VALUES (99)"), SQLite::Exception);
    EXPECT_THROW(database.exec("UPDATE run SET status = 'running'"), SQLite::Exception);
    EXPECT_THROW(database.exec("UPDATE measure SET run_out_m = 'far'"), SQLite::Exception);
    database.exec("DELETE FROM run WHERE run_id = " + std::to_string(run_id));
    for (const char* table : {"measure", "series", "deposit_profile", "snapshot", "stage", "phase_time"})
        EXPECT_EQ(count(table), 0) << table;
}

TEST(SchemaComments, StandBesideColumnsAndAboveTables) {
    const SchemaComments comments = schema_comments(
        "-- Not of a table.\n\n-- What moves,\n-- in two lines.\nCREATE TABLE mass (\n"
        "    mass_id  INTEGER PRIMARY KEY,\n    size_m2  REAL NOT NULL,   -- S_0\n"
        "    kind     TEXT NOT NULL CHECK (kind IN ('a', 'b')),  -- a or b\n"
        "    PRIMARY KEY (mass_id)\n) STRICT;\nCREATE TABLE bare (\n    x REAL\n);\n");
    EXPECT_EQ(comments.tables.at("mass"), "What moves, in two lines.");
    EXPECT_EQ(comments.tables.at("bare"), "");
    EXPECT_EQ(comments.columns.at("mass.size_m2"), "S_0");
    EXPECT_EQ(comments.columns.at("mass.kind"), "a or b");
    EXPECT_EQ(comments.columns.at("mass.mass_id"), "");
    EXPECT_EQ(comments.columns.count("mass.PRIMARY"), 0u);
    EXPECT_EQ(schema_comments().columns.at("measure.front_area_m2"), "S_front");
}

TEST_F(StoreTest, TellsEveryColumnOfARunWithItsMeaning) {
    const long id = add(example_scene(), example_result());
    const Store store(path, Store::Mode::read);
    const auto facts = store.facts(id);
    const auto fact = [&](const std::string& table, const std::string& column) -> const StoredFact& {
        const auto found = std::ranges::find_if(
            facts, [&](const StoredFact& item) { return item.table == table && item.column == column; });
        EXPECT_NE(found, facts.end()) << table << "." << column;
        return found == facts.end() ? facts.front() : *found;
    };
    EXPECT_EQ(fact("scenario", "density_kg_m3").value, StoredValue(1900.0));
    EXPECT_EQ(fact("scenario", "base_friction_angle_deg").value, StoredValue());
    EXPECT_EQ(fact("scenario", "smoothing_ratio").meaning, "h / particle spacing");
    EXPECT_EQ(fact("source", "area_m2").meaning, "S_0");
    EXPECT_EQ(fact("run", "particles").value, StoredValue(1601L));
    EXPECT_EQ(fact("run", "name").value, StoredValue(std::string("cut-60")));
    EXPECT_EQ(fact("measure", "run_out_m").value, StoredValue(example_result().measures.run_out_m));
    for (const StoredFact& item : facts) EXPECT_FALSE(item.column.ends_with("_id")) << item.column;
}

TEST_F(StoreTest, FindsTheTablesOfTheFormatThatHaveNoReaderAndNoOthers) {
    const long id = add(example_scene(), example_result());
    raw().exec(
        "INSERT INTO advice VALUES (1, 0, 'look at it'), (1, 1, 'and again');"
        "CREATE TABLE something_new (run_id INTEGER, row_index INTEGER, name TEXT, depth_m REAL, shape BLOB);"
        "INSERT INTO something_new VALUES (1, 0, 'house', 0.5, x'00')");
    const auto tables = Store(path, Store::Mode::read).further_tables(id);
    const auto found = std::ranges::find(tables, "advice", &StoredTable::name);
    ASSERT_NE(found, tables.end());
    EXPECT_EQ(found->columns, (std::vector<std::string>{"sentence"}));
    ASSERT_EQ(found->rows.size(), 2u);
    EXPECT_EQ(found->rows[0], (std::vector<StoredValue>{std::string("look at it")}));
    for (const StoredTable& table : tables) {
        EXPECT_NE(table.name, "something_new") << "a table of someone else is not shown as ours";
        EXPECT_NE(table.name, "series") << "it has a reader of its own";
    }
}

// The round trip uses one list both ways and would not see a member under the name of another.
TEST_F(StoreTest, SnapshotsAndStagesStandUnderTheirOwnNames) {
    RunResult result = example_result();
    result.snapshots = {{0.25, {1}, {2}, {3}, {4}, {5}}};
    result.stages = {{1.1, 2.2, 30.3, 4.4, 5.5}};
    add(example_scene(), result);
    SQLite::Database database = raw();
    SQLite::Statement snapshot(
        database, "SELECT x_m, y_m, vx_m_s, vy_m_s, pressure_pa FROM snapshot WHERE time_s = 0.25");
    ASSERT_TRUE(snapshot.executeStep());
    for (int i = 0; i < 5; ++i) {
        float value = 0;
        ASSERT_EQ(snapshot.getColumn(i).getBytes(), static_cast<int>(sizeof value));
        std::memcpy(&value, snapshot.getColumn(i).getBlob(), sizeof value);
        EXPECT_EQ(value, static_cast<float>(i + 1)) << snapshot.getColumnName(i);
    }
    EXPECT_EQ(count("stage WHERE time_s = 1.1 AND area_m2 = 2.2 AND surface_angle_deg = 30.3"
                    " AND deposit_height_m = 4.4 AND run_out_m = 5.5"),
              1);
}

TEST_F(StoreTest, KeepsFloatsThatDoNotCompareAndInTheStatedOrderOfBytes) {
    using Limits = std::numeric_limits<float>;
    const std::vector<float> odd = {-0.0F, Limits::denorm_min(), -Limits::infinity(), Limits::quiet_NaN(),
                                    1.0F};
    RunResult result = example_result();
    result.snapshots = {{0.25, odd, odd, odd, odd, odd}};
    const long id = add(example_scene(), result);
    const std::vector<Snapshot> kept = Store(path, Store::Mode::read).snapshots(id);
    ASSERT_EQ(kept.size(), 1U);
    for (const SnapshotColumn& column : snapshot_columns()) {
        const std::vector<float>& values = kept[0].*column.value;
        ASSERT_EQ(values.size(), odd.size()) << column.name;
        EXPECT_EQ(std::memcmp(values.data(), odd.data(), odd.size() * sizeof(float)), 0) << column.name;
    }
    EXPECT_EQ(raw().execAndGet("SELECT hex(substr(x_m, 17)) FROM snapshot").getString(), "0000803F");
}

TEST_F(StoreTest, WritesEffectsAndLeavesAbsentOnesNull) {
    Scene scene = example_scene();
    add(scene, example_result());
    scene.effects.base_friction = BaseFriction{0.5};
    scene.effects.release = StagedRelease{7, 0.15, 0.01};
    scene.run.lattice_seed = 3;
    scene.run.snapshot_times = {0.1, 0.25};
    add(scene, example_result());
    SQLite::Database database = raw();
    SQLite::Statement rows(
        database,
        "SELECT lattice_seed, snapshot_times_s, base_friction_angle_deg, release_layers,"
        " release_layer_width_m, release_layer_height_m FROM scenario ORDER BY scenario_id");
    ASSERT_TRUE(rows.executeStep());
    EXPECT_EQ(rows.getColumn(0).getInt(), 0);
    EXPECT_EQ(rows.getColumn(1).getString(), "[]");
    for (int effect = 2; effect < 6; ++effect) EXPECT_TRUE(rows.getColumn(effect).isNull()) << effect;
    ASSERT_TRUE(rows.executeStep());
    EXPECT_EQ(rows.getColumn(0).getInt(), 3);
    EXPECT_EQ(rows.getColumn(1).getString(), "[0.1, 0.25]");
    EXPECT_EQ(rows.getColumn(2).getDouble(), degrees(0.5));
    EXPECT_EQ(rows.getColumn(3).getInt(), 7);
    EXPECT_EQ(rows.getColumn(4).getDouble(), 0.15);
    EXPECT_EQ(rows.getColumn(5).getDouble(), 0.01);
}

}  // namespace
}  // namespace runout
