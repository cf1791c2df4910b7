#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <thread>

#include "core/units.h"
#include "core/version.h"
#include "store/columns.h"
#include "store_fixture.h"

// What goes into the store comes out of it.

namespace runout {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST_F(StoreTest, ReturnsEveryFieldOfARun) {
    Scene scene = example_scene();
    scene.source.datum = DropDatum::base;
    const RunResult result = example_result();
    const long run_id = add(scene, result);

    const Store store(path, Store::Mode::read);
    ASSERT_EQ(store.runs().size(), 1U);
    const StoredRun run = store.runs().front();
    EXPECT_EQ(run.run_id, run_id);
    EXPECT_EQ(run.name, "cut-60");
    EXPECT_EQ(run.section_origin, "profiles/cut-60.csv");
    EXPECT_EQ(run.source_type, "C");
    EXPECT_EQ(run.discontinuity_angle_deg, degrees(0.96));
    EXPECT_EQ(run.drop_height_datum, "base");
    EXPECT_EQ(run.slope_angle_deg, degrees(scene.profile.slope_angle));
    EXPECT_EQ(run.friction_angle_deg, degrees(0.66));
    EXPECT_EQ(run.scenario_hash, scenario_hash(scene));
    EXPECT_EQ(run.program_version, program_version());
    EXPECT_EQ(run.program_revision, program_revision());
    EXPECT_EQ(run.compiler, compiler_description());
    EXPECT_EQ(run.host_threads, static_cast<int>(std::thread::hardware_concurrency()));
    EXPECT_EQ(run.status, RunStatus::settled);
    EXPECT_EQ(run.status_detail, "");
    for (const MeasureField& field : measure_fields())
        EXPECT_EQ(run.measures.*field.value, result.measures.*field.value) << field.name;
    for (const WorkColumn& column : work_columns())
        std::visit([&](auto member) { EXPECT_EQ(run.work.*member, result.work.*member) << column.name; },
                   column.member);
}

TEST_F(StoreTest, ReturnsSeriesDepositAndPhasesInTheirOrder) {
    const RunResult result = example_result();
    const long run_id = add(example_scene(), result);
    const Store store(path, Store::Mode::read);

    const auto series = store.series(run_id);
    ASSERT_EQ(series.size(), result.series.size());
    for (std::size_t i = 0; i < series.size(); ++i)
        for (const auto& column : series_columns())
            EXPECT_EQ(series[i].*column.value, result.series[i].*column.value) << column.name;

    const auto deposit = store.deposit(run_id);
    ASSERT_EQ(deposit.size(), result.deposit.size());
    for (std::size_t i = 0; i < deposit.size(); ++i)
        for (const auto& column : deposit_columns())
            EXPECT_EQ(deposit[i].*column.value, result.deposit[i].*column.value) << column.name;

    const auto phases = store.phases(run_id);
    ASSERT_EQ(phases.size(), result.phases.size());
    for (std::size_t i = 0; i < phases.size(); ++i) {
        EXPECT_EQ(phases[i].phase, result.phases[i].phase);
        EXPECT_EQ(phases[i].wall_s, result.phases[i].wall_s);
    }

    const auto invariants = store.invariants(run_id);
    ASSERT_EQ(invariants.size(), result.invariants.size());
    for (std::size_t i = 0; i < invariants.size(); ++i) {
        EXPECT_EQ(invariants[i].invariant, result.invariants[i].invariant);
        EXPECT_EQ(invariants[i].worst, result.invariants[i].worst);
        EXPECT_EQ(invariants[i].limit, result.invariants[i].limit);
        EXPECT_EQ(invariants[i].time_s, result.invariants[i].time_s);
        EXPECT_EQ(invariants[i].x_m, result.invariants[i].x_m);
    }
}

TEST_F(StoreTest, StoresTheScenarioThatWasAsked) {
    Scene scene = example_scene();
    scene.run = {.particle_spacing = 0.11,
                 .resolution = 41,
                 .gravity = 9.79,
                 .courant = 0.12,
                 .smoothing_ratio = 1.31,
                 .friction = FrictionScheme::explicit_,
                 .friction_iterations = 7,
                 .pressure_tolerance = 0.013,
                 .time_limit = 33.3,
                 .front_thickness = 0.07,
                 .lattice_seed = 11,
                 .snapshot_times = {},
                 .threads = 2};
    add(scene, example_result());
    SQLite::Database database = raw();
    SQLite::Statement row(
        database,
        "SELECT density_kg_m3, friction_angle_deg, particle_spacing_m, resolution, gravity_m_s2,"
        " courant, smoothing_ratio, friction_iterations, pressure_tolerance, time_limit_s,"
        " front_thickness_m, friction_scheme FROM scenario");
    ASSERT_TRUE(row.executeStep());
    const std::vector<double> expected = {1900, degrees(0.66), 0.11, 41,  9.79, 0.12, 1.31,
                                          7,    0.013,         33.3, 0.07};
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(row.getColumn(static_cast<int>(i)).getDouble(), expected[i]) << i;
    EXPECT_EQ(row.getColumn(11).getString(), "explicit");
}

TEST_F(StoreTest, StoresGroundAndSourceToTheBit) {
    const Scene scene = example_scene();
    add(scene, example_result());
    SQLite::Database database = raw();
    const auto expect_points = [&](const std::string& query, const std::vector<Vec2>& expected) {
        SQLite::Statement row(database, query + " ORDER BY point_index");
        for (const Vec2& point : expected) {
            ASSERT_TRUE(row.executeStep()) << query;
            EXPECT_EQ(row.getColumn(0).getDouble(), point.x());
            EXPECT_EQ(row.getColumn(1).getDouble(), point.y());
        }
        EXPECT_FALSE(row.executeStep()) << query;
    };
    expect_points("SELECT x_m, y_m FROM section_point", scene.profile.ground);
    expect_points("SELECT x_m, y_m FROM source_point WHERE part = 'outline'", scene.source.outline);
    expect_points("SELECT x_m, y_m FROM source_point WHERE part = 'bed'", scene.source.bed);

    SQLite::Statement row(
        database,
        "SELECT toe_chainage_m, toe_elevation_m, crest_index, toe_index, area_m2, front_area_m2,"
        " discontinuity_angle_deg, exit_x_m, exit_y_m, head_x_m, head_y_m, source.drop_height_m,"
        " drop_height_datum FROM source JOIN section USING (section_id)");
    ASSERT_TRUE(row.executeStep());
    const std::vector<double> expected = {834512.25,     41.5, 1, 2,  12.5,  9.1,
                                          degrees(0.96), -1,   2, -7, 10.25, 10.25};
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(row.getColumn(static_cast<int>(i)).getDouble(), expected[i]) << i;
    EXPECT_EQ(row.getColumn(12).getString(), "head");
}

TEST_F(StoreTest, GivesTheGroundInTheCoordinatesOfItsFile) {
    Scene scene = example_scene();
    scene.profile.descends_with_chainage = false;
    add(scene, example_result());
    SQLite::Database database = raw();
    EXPECT_EQ(database.execAndGet("SELECT chainage_m FROM section_ground WHERE point_index = 0").getDouble(),
              834512.25 + 20);
    EXPECT_EQ(database.execAndGet("SELECT elevation_m FROM section_ground WHERE point_index = 0").getDouble(),
              53.5);
}

TEST_F(StoreTest, NumbersThatDoNotExistAreNullAndComeBackAsNaN) {
    RunResult result = example_result();
    result.measures.reach_angle_deg = nan;
    result.work.highest_density_ratio = nan;
    result.series[1].kinetic_energy_j_m = nan;
    result.deposit[0].thickness_by_top_m = nan;
    const long run_id = add(example_scene(), result);
    EXPECT_EQ(count("measure WHERE reach_angle_deg IS NULL AND run_out_m IS NOT NULL"), 1);
    EXPECT_EQ(count("run WHERE highest_density_ratio IS NULL"), 1);
    const Store store(path, Store::Mode::read);
    EXPECT_TRUE(std::isnan(store.run(run_id).measures.reach_angle_deg));
    EXPECT_FALSE(std::isnan(store.run(run_id).measures.run_out_m));
    EXPECT_TRUE(std::isnan(store.run(run_id).work.highest_density_ratio));
    EXPECT_TRUE(std::isnan(store.series(run_id)[1].kinetic_energy_j_m));
    EXPECT_TRUE(std::isnan(store.deposit(run_id)[0].thickness_by_top_m));
}

TEST_F(StoreTest, StoresEveryWayARunCanEnd) {
    constexpr std::array ends = {RunStatus::settled,       RunStatus::stable,    RunStatus::time_limit,
                                 RunStatus::left_section,  RunStatus::diverged,  RunStatus::interrupted,
                                 RunStatus::not_converged, RunStatus::not_a_body};
    Store store(path, Store::Mode::write);
    for (const RunStatus end : ends) {
        RunResult result = example_result();
        result.status = end;
        result.status_detail = "density ratio 1.31 at t = 0.2 s, x = -4.5 m";
        const StoredRun run = store.run(store.add(example_scene(), result));
        EXPECT_EQ(run.status, end);
        EXPECT_EQ(run.status_detail, result.status_detail);
        EXPECT_EQ(count("run_status WHERE status = '" + std::string(to_string(end)) +
                        "' AND is_result = " + (is_result(end) ? "1" : "0")),
                  1)
            << to_string(end);
    }
    EXPECT_EQ(count("run_status"), static_cast<long>(ends.size()));
    EXPECT_EQ(count("result"), 2) << "only settled and stable runs are results";
}

TEST_F(StoreTest, TimesAreIsoAndInOrder) {
    RunResult result = example_result();
    result.work.wall_s = 3600;
    const StoredRun run = describe_run(example_scene(), result);
    ASSERT_EQ(run.started_utc.size(), std::string("2024-05-31T09:30:00Z").size());
    EXPECT_EQ(run.started_utc[10], 'T');
    EXPECT_EQ(run.started_utc.back(), 'Z');
    EXPECT_LT(run.started_utc, run.ended_utc);
}

TEST_F(StoreTest, KeepsTheErrorBarOfARunAndItsPilots) {
    Store store(path, Store::Mode::write);
    const Appraisal given = example_appraisal();
    const long run_id =
        store.add(example_scene(), example_result(), given, {example_pilot(), example_pilot()});
    const long bare = store.add(example_scene(), example_result());
    const StoredRun run = store.run(run_id);
    for (const auto& column : appraisal_numbers())
        EXPECT_EQ(run.appraisal.*column.value, given.*column.value) << column.name;
    for (const auto& column : appraisal_texts())
        EXPECT_EQ(run.appraisal.*column.value, given.*column.value) << column.name;
    EXPECT_FALSE(run.machine.empty());
    const std::vector<PilotRow> pilots = store.pilots(run_id);
    ASSERT_EQ(pilots.size(), 2U);
    for (const auto& column : pilot_columns())
        EXPECT_EQ(pilots[1].*column.value, example_pilot().*column.value) << column.name;
    EXPECT_EQ(store.run(bare).appraisal.error_origin, "none");
    EXPECT_TRUE(std::isnan(store.run(bare).appraisal.run_out_error_m));
    EXPECT_TRUE(store.pilots(bare).empty());
}

TEST_F(StoreTest, KnowsWhereAnErrorBarCanComeFrom) {
    Appraisal guess = example_appraisal();
    guess.error_origin = "guess";
    Store store(path, Store::Mode::write);
    EXPECT_ANY_THROW(store.add(example_scene(), example_result(), guess));
    EXPECT_TRUE(store.runs().empty());
}

TEST_F(StoreTest, KeepsStudiesAndGivesTheLatestOfAQuestion) {
    Store store(path, Store::Mode::write);
    const long run_id = add(example_scene(), example_result());
    StoredLadder ladder;
    ladder.question_hash = "q";
    ladder.name = "cut";
    ladder.target = "5 %";
    ladder.runs = {{"spacing", "8", 8, run_id}, {"run.courant", "0.2", 8, run_id}};
    ladder.verdicts = {
        {"run_out_m", "converged", 1.5, 0.1, 0.02, std::nan(""), 1.6, std::nan(""), 1.1, 1.55}};
    const long first = store.add(ladder);
    ladder.name = "cut again";
    const long second = store.add(ladder);
    ladder.question_hash = "other";
    store.add(ladder);
    EXPECT_EQ(store.ladders().size(), 3U);
    EXPECT_FALSE(store.find_ladder("none"));
    const StoredLadder found = store.find_ladder("q").value();
    EXPECT_NE(first, second);
    EXPECT_EQ(found.ladder_id, second);
    EXPECT_EQ(found.name, "cut again");
    EXPECT_FALSE(found.ended_utc.empty());
    ASSERT_EQ(found.runs.size(), 2U);
    EXPECT_EQ(found.runs[1].series, "run.courant");
    EXPECT_EQ(found.runs[1].setting, "0.2");
    EXPECT_EQ(found.runs[1].run_id, run_id);
    ASSERT_EQ(found.verdicts.size(), 1U);
    EXPECT_EQ(found.verdicts[0].fitted_value, 1.55);
    EXPECT_TRUE(std::isnan(found.verdicts[0].observed_order));
    EXPECT_EQ(raw()
                  .execAndGet("SELECT lattices FROM ladder_rung WHERE ladder_id = 1 AND series = 'spacing'")
                  .getInt(),
              1);
}

TEST_F(StoreTest, KeepsSnapshotsToTheBitAndStages) {
    const RunResult result = example_result();
    const long id = add(example_scene(), result);
    const Store store(path, Store::Mode::read);
    const std::vector<Snapshot> kept = store.snapshots(id);
    ASSERT_EQ(kept.size(), result.snapshots.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
        EXPECT_EQ(kept[i].time_s, result.snapshots[i].time_s);
        for (const SnapshotColumn& column : snapshot_columns())
            EXPECT_EQ(kept[i].*column.value, result.snapshots[i].*column.value) << column.name;
    }
    const std::vector<StageRow> stages = store.stages(id);
    ASSERT_EQ(stages.size(), result.stages.size());
    for (std::size_t i = 0; i < stages.size(); ++i)
        for (const auto& column : stage_columns())
            EXPECT_EQ(stages[i].*column.value, result.stages[i].*column.value) << column.name;
}

TEST_F(StoreTest, KeepsFramesToTheBit) {
    RunResult result = example_result();
    result.frames.push_back({});  // a picture of nothing
    const long id = add(example_scene(), result);
    const std::vector<Frame> frames = Store(path, Store::Mode::read).frames(id);
    ASSERT_EQ(frames.size(), result.frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        for (const auto& column : frame_scale_columns())
            EXPECT_EQ(frames[i].scale.*column.value, result.frames[i].scale.*column.value) << column.name;
        EXPECT_EQ(frames[i].x, result.frames[i].x);
        EXPECT_EQ(frames[i].y, result.frames[i].y);
        EXPECT_EQ(frames[i].speed, result.frames[i].speed);
        EXPECT_EQ(frames[i].pressure, result.frames[i].pressure);
    }
    EXPECT_EQ(count("frame WHERE length(x) = 4 AND x = x'0000FFFF' AND speed = x'FF01'"), 1)
        << "little-endian words and bytes";
}

TEST_F(StoreTest, PicturesMayGrowByLaterMasses) {
    RunResult result = example_result();
    Frame more = result.frames.back();
    more.x.push_back(1);
    more.y.push_back(1);
    more.speed.push_back(1);
    more.pressure.push_back(1);
    result.frames.push_back(more);
    const long id = add(example_scene(), result);
    EXPECT_EQ(Store(path, Store::Mode::read).frames(id).back().x, more.x);
}

TEST_F(StoreTest, GivesBackGroundAndSource) {
    const Scene scene = example_scene();
    const long id = add(scene, example_result());
    const SectionGeometry geometry = Store(path, Store::Mode::read).geometry(id);
    EXPECT_EQ(geometry.profile.ground, scene.profile.ground);
    EXPECT_EQ(geometry.profile.toe, scene.profile.toe);
    EXPECT_EQ(geometry.profile.crest, scene.profile.crest);
    EXPECT_EQ(geometry.profile.toe_chainage_m, scene.profile.toe_chainage_m);
    EXPECT_EQ(geometry.profile.toe_elevation_m, scene.profile.toe_elevation_m);
    EXPECT_EQ(geometry.profile.descends_with_chainage, scene.profile.descends_with_chainage);
    EXPECT_EQ(geometry.profile.origin, scene.profile.origin);
    EXPECT_EQ(geometry.outline, scene.source.outline);
    EXPECT_EQ(geometry.bed, scene.source.bed);
    EXPECT_EQ(geometry.exit_point, scene.source.exit_point);
    EXPECT_EQ(geometry.head, scene.source.head);
    EXPECT_NEAR(geometry.discontinuity_angle, scene.source.discontinuity_angle, 1e-15);
}

TEST_F(StoreTest, KeepsTheEffectsThatWereOnAndTheirSettings) {
    Scene scene = example_scene();
    RunResult result = example_result();
    scene.effects.cohesion = Cohesion{.strength = 5000};
    result.effects = {{"rate", false, "off", std::nan("")}, {"cohesion", true, "glue", 0.25}};
    const long run_id = add(scene, result);
    EXPECT_EQ(count("run_effect"), 1) << "what was off takes no room";
    const StoredRun run = Store(path, Store::Mode::read).run(run_id);
    EXPECT_EQ(run.effects.size(), effect_states({}, 0).size());
    for (const EffectRow& effect : run.effects)
        EXPECT_EQ(effect.on, effect.name == "cohesion") << effect.name;
    const auto glue = std::ranges::find(run.effects, "cohesion", &EffectRow::name);
    EXPECT_EQ(glue->why, "glue");
    EXPECT_EQ(glue->cost_s, 0.25);
    EXPECT_EQ(settings_text(run.effect_settings, "cohesion"), "cohesion_kpa = 5");
}

TEST_F(StoreTest, FindsTheLatestRunOfAScenarioThatWasNotInterrupted) {
    const std::string hash = scenario_hash(example_scene());
    EXPECT_EQ(Store(path, Store::Mode::write).find_run(hash), std::nullopt);
    RunResult stopped = example_result();
    stopped.status = RunStatus::interrupted;
    add(example_scene(), stopped);
    EXPECT_EQ(Store(path, Store::Mode::read).find_run(hash), std::nullopt);
    add(example_scene(), example_result());
    const long latest = add(example_scene(), example_result());
    add(example_scene(), stopped);
    Scene other = example_scene();
    other.material.friction_angle = 0.5;
    const long of_other = add(other, example_result());
    const Store store(path, Store::Mode::read);
    EXPECT_EQ(store.find_run(hash), latest);
    EXPECT_EQ(store.find_run(scenario_hash(other)), of_other);
}

TEST_F(StoreTest, FindsARunThatIsNotAResultToo) {
    RunResult failed = example_result();
    failed.status = RunStatus::diverged;
    const long id = add(example_scene(), failed);
    EXPECT_EQ(Store(path, Store::Mode::read).find_run(scenario_hash(example_scene())), id);
}

TEST_F(StoreTest, ListsTheRunsOnASection) {
    add(example_scene(), example_result());
    Scene other = example_scene();
    other.profile.toe_elevation_m += 1;
    const long second = add(other, example_result());
    const Store store(path, Store::Mode::read);
    ASSERT_EQ(store.runs_on_section(2).size(), 1u);
    EXPECT_EQ(store.runs_on_section(2)[0].run_id, second);
    EXPECT_TRUE(contains(input_error([&] { static_cast<void>(store.runs_on_section(3)); }), "3"));
}

}  // namespace
}  // namespace runout
