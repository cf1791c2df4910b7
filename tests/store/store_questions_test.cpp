// Questions and studies in the store: what is equal has one row, and a study finds its runs.

#include <gtest/gtest.h>

#include "store/database.h"
#include "store_fixture.h"

namespace runout {
namespace {

// ---- one question, one row

TEST_F(StoreTest, EqualScenesShareTheirRows) {
    Scene copy = example_scene();
    copy.name = "the same under another name";
    copy.profile.origin = "copy.csv";
    add(example_scene(), example_result());
    add(copy, example_result());
    EXPECT_EQ(count("section"), 1);
    EXPECT_EQ(count("source"), 1);
    EXPECT_EQ(count("scenario"), 1);
    EXPECT_EQ(count("run"), 2);
    const auto runs = Store(path, Store::Mode::read).runs();
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[0].section_origin, "profiles/cut-60.csv");
    EXPECT_EQ(runs[1].section_origin, "copy.csv");
    EXPECT_EQ(runs[1].name, copy.name);
}

TEST_F(StoreTest, WhatDiffersGetsItsOwnRow) {
    Scene soil = example_scene();
    soil.material.friction_angle = 0.5;
    Scene mass = example_scene();
    mass.source.outline[2].y() += 1e-9;
    Scene ground = example_scene();
    ground.profile.ground[3].x() += 1e-9;
    for (const Scene& scene : {example_scene(), soil, mass, ground}) add(scene, example_result());
    EXPECT_EQ(count("section"), 2);
    EXPECT_EQ(count("source"), 3);
    EXPECT_EQ(count("scenario"), 4);
}

// ---- studies

TEST_F(StoreTest, AStudyListsItsScenariosWithTheLatestRunOfEach) {
    const Scene scene = example_scene();
    Store store(path, Store::Mode::write);
    const long study = store.begin_study("cuts", "[vary]");
    store.set_study_scenarios(study, {{2, "", "{\"a\": 3}", "too steep"},
                                      {0, scenario_hash(scene), "{\"a\": 1}", ""},
                                      {1, "not run yet", "{\"a\": 2}", ""}});
    store.add(scene, example_result());
    const long latest = store.add(scene, example_result());
    RunResult interrupted = example_result();
    interrupted.status = RunStatus::interrupted;
    store.add(scene, interrupted);
    const std::vector<StudyRow> rows = store.study_rows(study);
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0].run_id, latest);
    EXPECT_TRUE(rows[0].is_result);
    EXPECT_EQ(rows[0].run_out_m, example_result().measures.run_out_m);
    EXPECT_FALSE(rows[1].run_id);
    EXPECT_TRUE(std::isnan(rows[1].run_out_m));
    EXPECT_EQ(rows[2].scenario.refusal, "too steep");
    EXPECT_EQ(store.begin_study("cuts", "[vary]"), study);
    EXPECT_EQ(store.studies().at(0).scenarios, 3);
    EXPECT_EQ(store.begin_study("cuts", "[vary]\nanother = 1"), study);
    EXPECT_TRUE(store.study_rows(study).empty()) << "what was said of a study that has changed is forgotten";
    EXPECT_EQ(store.runs().size(), 3u);
}

// A million runs must not be looked through for one study.
TEST_F(StoreTest, TheTableOfAStudyScansNothing) {
    add(example_scene(), example_result());
    SQLite::Database database = raw();
    SQLite::Statement plan(database, "EXPLAIN QUERY PLAN " + study_rows_sql());
    int searches = 0;
    while (plan.executeStep()) {
        const std::string step = plan.getColumn(3).getString();
        EXPECT_FALSE(step.starts_with("SCAN ")) << step;
        searches += step.starts_with("SEARCH ") ? 1 : 0;
    }
    EXPECT_GE(searches, 7);
}

}  // namespace
}  // namespace runout
