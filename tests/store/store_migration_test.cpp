// A file of an older version is brought up to date, step by step, and keeps what it holds.

#include <array>
#include <set>
#include <string>

#include "store/database.h"
#include "store/migrations.h"
#include "store_fixture.h"

namespace runout {
namespace {

TEST_F(StoreTest, MigrationsGoStepByStepFromWhereTheFileStands) {
    constexpr std::array steps = {
        Migration{1, "CREATE TABLE step (version INTEGER); INSERT INTO step VALUES (2)"},
        Migration{2, "INSERT INTO step VALUES (3)"},
    };
    SQLite::Database database(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    database.exec("PRAGMA user_version = 1");
    migrate(database, steps);
    EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), 3);
    EXPECT_EQ(count("step"), 2);
    migrate(database, steps);
    EXPECT_EQ(count("step"), 2) << "a step is never taken twice";
}

std::set<std::string> texts(SQLite::Database& database, const char* query) {
    SQLite::Statement statement(database, query);
    std::set<std::string> found;
    while (statement.executeStep()) found.insert(statement.getColumn(0).getString());
    return found;
}

/// The format of a file as SQLite understands it, comments and spaces apart: every column with its place,
/// type and default, every kind of table, every reference, every index and view.
std::set<std::string> format_of(SQLite::Database& database) {
    std::set<std::string> format =
        texts(database,
              "SELECT printf('%s.%s place %d %s notnull %d default %s key %d', t.name, c.name, c.cid, c.type,"
              " c.\"notnull\", c.dflt_value, c.pk) FROM pragma_table_list t, pragma_table_info(t.name) c"
              " WHERE t.name NOT LIKE 'sqlite_%'");
    format.merge(texts(database,
                       "SELECT printf('%s %s: strict %d, without rowid %d', type, name, strict, wr)"
                       " FROM pragma_table_list WHERE name NOT LIKE 'sqlite_%'"));
    format.merge(texts(database,
                       "SELECT printf('%s.%s references %s, on delete %s', t.name, f.\"from\", f.\"table\","
                       " f.on_delete) FROM pragma_table_list t, pragma_foreign_key_list(t.name) f"));
    format.merge(texts(database, "SELECT type || ' ' || name FROM sqlite_schema WHERE type <> 'table'"));
    return format;
}

/// Version 10 told the front of thickness.
void take_back_the_front(SQLite::Database& database) {
    for (const char* column :
         {"run_out_along_bed_m", "farthest_front_m", "front_window_m", "front_by_top_m",
          "peak_mass_995_speed_m_s", "farthest_soil_m", "beyond_front_area_m2", "beyond_front_speed_m_s"})
        database.exec(std::string("ALTER TABLE measure DROP COLUMN ") + column);
    database.exec(
        "ALTER TABLE scenario DROP COLUMN front_window_m; ALTER TABLE series DROP COLUMN front_m;"
        "ALTER TABLE series RENAME COLUMN front_mass_995_m TO front_m;"
        "DELETE FROM run_status WHERE status = 'not_a_body'");
}

/// The format as it is now without what versions 4 to 10 added.
void take_back_to_version_three(SQLite::Database& database) {
    database.exec(
        "DROP TABLE refused_section; DROP TABLE study_scenario; DROP TABLE study; DROP VIEW result; DROP "
        "VIEW section_face; DROP VIEW ladder_rung; DROP TABLE "
        "pilot; DROP TABLE ladder_run;"
        " DROP TABLE ladder_verdict; DROP TABLE ladder;"
        "DROP TABLE invariant; DROP TABLE effect_setting; DROP TABLE run_effect; DROP TABLE advice; DROP "
        "TABLE place_series; DROP "
        "TABLE "
        "place; DROP TABLE envelope; DROP TABLE barrier_series; DROP TABLE barrier; ALTER TABLE run DROP "
        "COLUMN spared_share;"
        "ALTER TABLE measure DROP COLUMN eroded_area_m2; ALTER TABLE scenario DROP COLUMN sleeping; PRAGMA "
        "user_version = 3");
    for (const char* column :
         {"peak_memory_mb", "machine", "accuracy_asked", "run_out_error_m", "reach_angle_error_deg",
          "error_origin", "error_note", "expected_cpu_s", "choosing_cpu_s", "toe_origin", "crest_origin",
          "section_read_as", "section_doubts", "front_definition"})
        database.exec(std::string("ALTER TABLE run DROP COLUMN ") + column);
    take_back_the_front(database);
    database.exec("CREATE VIEW result AS SELECT run.name FROM run");
}

/// What a program of version 1 would have written.
void take_back_to_version_one(SQLite::Database& database) {
    take_back_to_version_three(database);
    database.exec(
        "ALTER TABLE run DROP COLUMN line_id; DROP TABLE map_line_point; DROP TABLE map_line_attribute;"
        "DROP TABLE map_line; DROP TABLE snapshot; DROP TABLE stage; DROP TABLE frame; "
        "PRAGMA user_version = "
        "1");
    for (const char* column : {"lattice_seed", "snapshot_times_s", "base_friction_angle_deg",
                               "release_layers", "release_layer_width_m", "release_layer_height_m"})
        database.exec(std::string("ALTER TABLE scenario DROP COLUMN ") + column);
}

TEST_F(StoreTest, AFileOfVersionOneIsBroughtUpToDateAndKeepsItsRun) {
    const RunResult result = example_result();
    const long id = add(example_scene(), result);
    const std::set<std::string> wanted = [this] {
        SQLite::Database file = raw();
        std::set<std::string> format = format_of(file);
        take_back_to_version_one(file);
        EXPECT_NE(format_of(file), format);
        return format;
    }();
    EXPECT_TRUE(contains(refusal_to_open(path, Store::Mode::read), "was written by an older Runout"));

    Store store(path, Store::Mode::write);
    SQLite::Database file = raw();
    EXPECT_EQ(format_of(file), wanted);
    EXPECT_EQ(file.execAndGet("PRAGMA user_version").getInt(), 10);
    EXPECT_EQ(store.run(id).front_definition, "top") << "its run-out is never taken for one of thickness";
    EXPECT_FALSE(store.envelope(id)) << "it has none, and says so";
    EXPECT_TRUE(std::isnan(store.run(id).measures.farthest_front_m));
    EXPECT_TRUE(std::isnan(store.series(id)[0].front_m));
    EXPECT_EQ(store.series(id)[0].front_mass_995_m, result.series[0].front_mass_995_m);
    EXPECT_EQ(store.run(id).appraisal.error_origin, "none");
    EXPECT_TRUE(std::isnan(store.run(id).appraisal.run_out_error_m));
    EXPECT_TRUE(store.ladders().empty());
    EXPECT_EQ(store.run(id).name, example_scene().name);
    EXPECT_EQ(store.run(id).measures.run_out_m, result.measures.run_out_m);
    EXPECT_EQ(store.series(id).size(), result.series.size());
    EXPECT_TRUE(store.snapshots(id).empty());
    EXPECT_TRUE(store.frames(id).empty());
    EXPECT_TRUE(store.stages(id).empty());
    EXPECT_TRUE(store.invariants(id).empty());
    EXPECT_EQ(count("scenario WHERE lattice_seed = 0 AND snapshot_times_s = '[]'"
                    " AND base_friction_angle_deg IS NULL AND release_layers IS NULL"),
              1);
    const long second = store.add(example_scene(), result, example_appraisal(), {example_pilot()});
    EXPECT_EQ(store.run(second).appraisal.run_out_error_m, example_appraisal().run_out_error_m);
    EXPECT_EQ(store.pilots(second).size(), 1u);
    EXPECT_EQ(store.snapshots(second).size(), result.snapshots.size());
    EXPECT_EQ(store.stages(second).size(), result.stages.size());
}

TEST_F(StoreTest, EffectsOfAnOlderFileAreKnownToBeOn) {
    Scene scene = example_scene();
    scene.effects.base_friction = BaseFriction{radians(12.5)};
    const long id = add(scene, example_result());
    {
        SQLite::Database file = raw();
        take_back_to_version_three(file);
    }
    const StoredRun run = Store(path, Store::Mode::write).run(id);
    for (const EffectRow& effect : run.effects)
        EXPECT_EQ(effect.on, effect.name == "base_friction") << effect.name;
    EXPECT_EQ(settings_text(run.effect_settings, "base_friction"), "angle_deg = 12.5");
}

TEST_F(StoreTest, MigrationsLeadToTheVersionOfTheSchema) {
    add(example_scene(), example_result());
    const int version = raw().execAndGet("PRAGMA user_version").getInt();
    int reached = 1;
    for (const Migration& step : migrations()) EXPECT_EQ(step.from, reached++);
    EXPECT_EQ(reached, version);
}

}  // namespace
}  // namespace runout
