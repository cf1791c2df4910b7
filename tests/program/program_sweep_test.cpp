// Sweeps, their shards and merging, and estimates from them.

#include <SQLiteCpp/Database.h>

#include <chrono>
#include <thread>

#include "program_fixture.h"
#include "store/store.h"

namespace runout {
namespace {

constexpr const char* small_study =
    "[study]\nname = \"small\"\ncase = \"case.toml\"\n[vary]\n"
    "material.friction_angle_deg = [32, 34, 36, 38]\nsource.base_angle_deg = [30, 35, 70]\n";

TEST_F(ProgramTest, ASweepGivesOneTableWhateverTheOrderAndTheNumberOfWorkers) {
    write("study.toml", small_study);
    const Outcome dry = runout({"sweep", "study.toml", "--dry-run"});
    EXPECT_EQ(dry.exit_code, 0) << dry.err;
    EXPECT_TRUE(contains(dry.out, "small: 12 scenarios")) << dry.out;
    EXPECT_FALSE(fs::exists(work("sweep.db")));

    const Outcome whole = runout({"sweep", "study.toml", "--db", "whole.db", "-j", "1", "--quiet"});
    EXPECT_EQ(whole.exit_code, 1) << "a base steeper than the face is refused\n" << whole.err;
    EXPECT_TRUE(contains(whole.out, "12 of 12 scenarios: 8 simulated, 0 known before, 4 refused"))
        << whole.out;
    const std::string table = runout({"table", "whole.db"}).out;
    EXPECT_TRUE(contains(table, "4 of 12 scenarios gave no result")) << table;
    EXPECT_TRUE(contains(table, "refused: ")) << table;

    const Outcome again = runout({"sweep", "study.toml", "--db", "whole.db", "--quiet"});
    EXPECT_TRUE(contains(again.out, "0 simulated, 8 known before")) << again.out;
    (void)runout({"sweep", "study.toml", "--db", "two.db", "-j", "2", "--quiet"});
    EXPECT_EQ(runout({"table", "two.db"}).out, table);

    for (const char* shard : {"0", "1", "2"})
        (void)runout({"sweep", "study.toml", "--shard", std::string(shard) + "/3", "--db",
                      std::string("shard-") + shard + ".db", "-j", "1", "--quiet"});
    const Outcome merged = runout({"merge", "all.db", "shard-2.db", "shard-0.db", "shard-1.db"});
    EXPECT_EQ(merged.exit_code, 0) << merged.err;
    EXPECT_EQ(runout({"table", "all.db"}).out, table);
    EXPECT_TRUE(contains(runout({"merge", "all.db", "shard-1.db"}).out, "0 runs added"))
        << "merging twice adds nothing";
    EXPECT_EQ(runout({"table", "all.db"}).out, table);
}

TEST_F(ProgramTest, EstimatesFromTheRunsOfASweepAndRefusesOutsideOfThem) {
    write("study.toml",
          "[study]\nname = \"chart\"\ncase = \"case.toml\"\nsamples = 30\n[vary]\nrun.resolution = 6\n"
          "material.friction_angle_deg = { distribution = \"uniform\", low = 30, high = 38 }\n");
    ASSERT_EQ(runout({"sweep", "study.toml", "--db", "chart.db", "--quiet"}).exit_code, 0);
    for (const char* study : {"chart", "1"}) {
        const Outcome outcome =
            runout({"estimate", "chart.db", "--study", study, "--phi", "34", "--area", "4", "--json"});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        const Json json = Json::parse(outcome.out);
        EXPECT_EQ(json["runs"], 30);
        EXPECT_EQ(json["run_out_m"].get<double>(), 2 * json["run_out_normalised"].get<double>());
        EXPECT_EQ(json["varied"].size(), 1u);
    }
    const Outcome outcome =
        runout({"estimate", "chart.db", "case.toml", "--set", "material.friction_angle_deg=34"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "The same in all runs, and no variable: slope angle 69.4 deg"))
        << outcome.out;
    EXPECT_TRUE(contains(runout({"estimate", "chart.db", "--check"}).out, "Every fifth run held out"));
    EXPECT_EQ(runout({"report", "chart.db", "--study", "1", "-o", "study.html"}).exit_code, 0);
    EXPECT_TRUE(contains(text_of(work("study.html")), "30 scenarios"));
    expect_refused({"estimate", "chart.db", "--phi", "45"}, {"friction angle = 45", "lies outside the runs"});
    expect_refused({"estimate", "chart.db", "--phi", "34", "--slope-angle", "60"},
                   {"slope angle = 60", "all 30 runs"});
    expect_refused({"estimate", "chart.db", "--area", "4"}, {"friction angle", "is not given"});
    expect_refused({"estimate", "chart.db"}, {"says not what is to be estimated"});
    expect_refused({"estimate", "chart.db", "case.toml", "--phi", "34"}, {"a case and numbers"});
    expect_refused({"estimate", "chart.db", "--phi", "34", "--study", "x"}, {"--study = x", "chart (1)"});
    expect_refused({"estimate", "none.db", "--phi", "34"}, {"none.db", "no such file"});
}

TEST_F(ProgramTest, AChangedStudyRunsOnlyWhatIsNew) {
    write("study.toml", "[study]\ncase = \"case.toml\"\n[vary]\nmaterial.friction_angle_deg = [34, 38]\n");
    EXPECT_EQ(runout({"sweep", "study.toml", "--quiet"}).exit_code, 0);
    write("study.toml",
          "[study]\ncase = \"case.toml\"\n[vary]\nmaterial.friction_angle_deg = [38, 36, 34]\n");
    EXPECT_TRUE(contains(runout({"sweep", "study.toml", "--quiet"}).out, "1 simulated, 2 known before"));
    const Json table = Json::parse(runout({"table", "sweep.db", "--format", "json", "--rows",
                                           "material.friction_angle_deg", "--columns", "section"})
                                       .out);
    ASSERT_EQ(table["cells"].size(), 3u);
    EXPECT_GT(table["cells"][0]["run_out_m"].get<double>(), table["cells"][2]["run_out_m"].get<double>())
        << "a weaker soil runs farther";
}

TEST_F(ProgramTest, AKilledSweepLosesNothingThatHadEnded) {
    write("study.toml", small_study);
    (void)runout({"sweep", "study.toml", "--db", "whole.db", "--quiet"});
    const std::string table = runout({"table", "whole.db"}).out;
    int kills = 0;
    for (int k = 0; k < 50; ++k) {
        Child child(folder_.path(), {"sweep", "study.toml", "--db", "killed.db", "-j", "2", "--quiet"});
        // Moments spread over the start, the runs and the writes; the same ones each time.
        std::this_thread::sleep_for(std::chrono::milliseconds(5 + (k * 37) % 97));
        child.kill_at_once();
        kills += child.wait().exit_code == -1 ? 1 : 0;
    }
    EXPECT_GT(kills, 5) << "it must have been killed at work";
    (void)runout({"sweep", "study.toml", "--db", "killed.db", "--quiet"});
    EXPECT_EQ(runout({"table", "killed.db"}).out, table);
}

TEST_F(ProgramTest, RefusesBadSweepsAndMerges) {
    write("study.toml", small_study);
    write("empty.toml", "");
    write("huge.toml",
          "[study]\ncase = \"case.toml\"\n[vary]\nmaterial.friction_angle_deg = { from = 20, to = 40, step = "
          "0.02 }\n"
          "material.density_kg_m3 = { from = 1500, to = 2000, step = 1 }\n");
    expect_refused({"sweep", "empty.toml"}, {"empty.toml", "names nothing to vary"});
    expect_refused({"sweep", "none.toml"}, {"none.toml", "does not exist"});
    expect_refused({"sweep", "huge.toml"}, {"huge.toml", "combinations", "--yes"});
    expect_refused({"sweep", "study.toml", "--shard", "3/3"}, {"--shard = 3/3", "out of range", "0 to 2"});
    expect_refused({"sweep", "study.toml", "--shard", "x"}, {"--shard = x", "0/8"});
    expect_refused({"merge", "all.db", "none.db"}, {"none.db", "no such file"});
    ASSERT_EQ(runout({"run", "case.toml", "--db", "one.db", "--quiet"}).exit_code, 0);
    EXPECT_EQ(runout({"merge", "one.db", "one.db"}).exit_code, 2);
    EXPECT_TRUE(contains(runout({"table", "one.db", "--study", "none"}).err, "holds no study"));
}

TEST_F(ProgramTest, ResultsThatDifferAreNotMerged) {
    for (const char* name : {"one.db", "other.db"})
        ASSERT_EQ(runout({"run", "case.toml", "--db", name, "--quiet"}).exit_code, 0);
    {
        SQLite::Database other(work("other.db").string(), SQLite::OPEN_READWRITE);
        other.exec("UPDATE measure SET run_out_m = run_out_m + 1");
    }
    const Outcome outcome = runout({"merge", "one.db", "other.db"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(contains(outcome.err, "other.db") && contains(outcome.err, "has another result"))
        << outcome.err;
    EXPECT_EQ(Store(work("one.db").string(), Store::Mode::read).runs().size(), 1u);
}

TEST_F(ProgramTest, AJobArrayForSlurmIsAScript) {
    write("it's a study.toml", small_study);
    const Outcome script = runout({"sweep", "it's a study.toml", "--slurm", "--shard", "0/4"});
    EXPECT_EQ(script.exit_code, 0) << script.err;
    for (const char* part :
         {"#!/bin/bash", "#SBATCH --array=0-3", "'it'\\''s a study.toml'", "$SLURM_ARRAY_TASK_ID"})
        EXPECT_TRUE(contains(script.out, part)) << part << " in\n" << script.out;
}

}  // namespace
}  // namespace runout
