// Running and listing: help, the main job, what accuracy costs, the source alone, the table of runs.

#include <SQLiteCpp/Database.h>

#include <chrono>
#include <thread>

#include "core/version.h"
#include "engine/simd/instruction_set.h"
#include "program_fixture.h"
#include "scene/parameters.h"
#include "store/store.h"

namespace runout {
namespace {

// --- help

TEST_F(ProgramTest, TellsItsVersionAndRevision) {
    const Outcome outcome = runout({"--version"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out,
              fmt::format("runout {} (revision {}, {}, {} instructions)\n", program_version(),
                          program_revision(), compiler_description(), to_string(instruction_set())));
    EXPECT_FALSE(program_revision().empty());
}

TEST_F(ProgramTest, HelpsWithEverySubcommand) {
    const Outcome outcome = runout({"--help"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    for (const char* word : {"run ", "source ", "table ", "help ", "Examples:", "Exit codes:"})
        EXPECT_TRUE(contains(outcome.out, word)) << word;
    for (const char* sub : {"run", "profile", "source", "table", "map", "report", "compare", "export",
                            "back-analysis", "estimate", "help"}) {
        EXPECT_EQ(runout({sub, "--help"}).exit_code, 0) << sub;
        EXPECT_TRUE(contains(runout({"help", sub}).out, fmt::format("runout {}", sub))) << sub;
    }
    EXPECT_EQ(runout({"help"}).out, outcome.out);
}

TEST_F(ProgramTest, HelpKeysTellsEveryKeyWithRangeAndDefault) {
    const Outcome outcome = runout({"help", "keys"});
    EXPECT_EQ(outcome.exit_code, 0);
    for (const Parameter& parameter : parameters()) {
        const std::string key(parameter.key.substr(parameter.key.find('.') + 1));
        const std::string line =
            fmt::format("  {}  ({}; default: {})\n", key, valid_values(parameter), parameter.fallback);
        EXPECT_TRUE(contains(outcome.out, line)) << line;
        EXPECT_TRUE(contains(outcome.out, std::string(parameter.help))) << parameter.key;
    }
}

TEST_F(ProgramTest, RefusesCommandLinesItDoesNotUnderstand) {
    expect_refused({}, {"subcommand"});
    expect_refused({"rnu", "case.toml"}, {"rnu is not a subcommand",
                                          "run, new, profile, source, effects, barrier, sweep, merge, "
                                          "delete, table, at, estimate, accuracy, map"});
    expect_refused({"run"}, {"FILE"});
    expect_refused({"run", "case.toml", "--angle", "3"}, {"--angle"});
    expect_refused({"run", "case.toml", "--friction-angle"}, {"--friction-angle"});
    expect_refused({"run", "case.toml", "--set", "resolution"}, {"--set", "key=value"});
    expect_refused({"run", "case.toml", "--set", "run.resolution=9", "--resolution", "8"},
                   {"run.resolution", "was given before", "give it once"});
    expect_refused({"help", "me"}, {"me", "valid: keys"});
}

// --- the main job

constexpr const char* measures_in_json[] = {"run_out_m",
                                            "run_out_normalised",
                                            "reach_angle_deg",
                                            "source_area_m2",
                                            "deposit_area_m2",
                                            "front_area_m2",
                                            "front_area_ratio",
                                            "drop_height_m",
                                            "drop_height_normalised",
                                            "deposit_height_m",
                                            "front_by_mass_m",
                                            "front_mass_995_m",
                                            "toe_thickness_m",
                                            "peak_front_speed_m_s",
                                            "time_to_rest_s",
                                            "status",
                                            "particles",
                                            "steps",
                                            "particle_spacing_m",
                                            "wall_s",
                                            "cpu_s",
                                            "scenario_hash",
                                            "name"};

TEST_F(ProgramTest, RunsACaseAndStoresIt) {
    const Outcome outcome = runout({"run", "case.toml", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json run = Json::parse(outcome.out);  // throws unless the whole of it is one value
    ASSERT_TRUE(run.is_object());
    for (const char* key : measures_in_json) EXPECT_TRUE(run.contains(key)) << key;
    EXPECT_EQ(run["status"], "settled");
    EXPECT_GT(run["run_out_m"].get<double>(), 0);
    EXPECT_NEAR(run["particles"].get<double>(), 100, 15);
    EXPECT_NEAR(run["drop_height_m"].get<double>(), 0.3, 1e-12);

    const std::vector<StoredRun> stored = Store(work("runout.db").string(), Store::Mode::read).runs();
    ASSERT_EQ(stored.size(), 1u);
    EXPECT_EQ(stored[0].status, RunStatus::settled);
    EXPECT_EQ(stored[0].measures.run_out_m, run["run_out_m"].get<double>());
    EXPECT_EQ(stored[0].run_id, run["run_id"].get<long>());
}

TEST_F(ProgramTest, WhatARunPrintsIsWhatTheTableSaysOfItLater) {
    const Outcome outcome = runout({"run", "case.toml", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json printed = Json::parse(outcome.out);
    const Json table = Json::parse(runout({"table", "runout.db", "--format", "json"}).out);
    ASSERT_EQ(table.size(), 1u);
    EXPECT_GT(table[0].size(), 50u);
    for (const auto& [name, value] : table[0].items())
        EXPECT_EQ(printed.at(name).dump(), value.dump()) << name;
}

TEST_F(ProgramTest, SaysTheAnswerInWordsOnStandardOutputAndTheRestOnStandardError) {
    // Fine enough that it takes a while, which is when progress is told.
    const Outcome outcome = runout({"run", "case.toml", "--resolution", "30"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_FALSE(outcome.out.empty());
    EXPECT_FALSE(contains(outcome.out, "runout: info"));
    EXPECT_TRUE(contains(outcome.err, "% done"));
    EXPECT_TRUE(contains(outcome.err, "stored as run 1 in runout.db"));
    EXPECT_FALSE(contains(outcome.err, "\r")) << "a progress bar belongs on a terminal";
}

TEST_F(ProgramTest, QuietSaysNothingButTheAnswer) {
    const Outcome outcome =
        runout({"run", "section.csv", "--friction-angle", "38", "--resolution", "10", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_FALSE(outcome.out.empty());
}

TEST_F(ProgramTest, NoStoreLeavesNothing) {
    const std::set<std::string> before = files();
    const Outcome outcome = runout({"run", "case.toml", "--no-store", "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out)["status"], "settled");
    EXPECT_EQ(files(), before);
}

TEST_F(ProgramTest, ABareSectionNeedsFourOptions) {
    const Outcome outcome =
        runout({"run", "section.csv", "--source", "B", "--base-angle", "35", "--scarp-angle", "80",
                "--friction-angle", "38", "--resolution", "10", "--db", "mine.db", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "not given, assumed: source.height_m = 0.4")) << outcome.err;
    EXPECT_FALSE(contains(outcome.err, "assumed: source.base_angle_deg")) << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out)["name"], "section");
    EXPECT_TRUE(fs::exists(work("mine.db")));
    EXPECT_FALSE(fs::exists(work("runout.db")));
}

TEST_F(ProgramTest, OptionsAndSettingsChangeTheRun) {
    const Json plain = Json::parse(runout({"run", "case.toml", "--json"}).out);
    const Json option = Json::parse(runout({"run", "case.toml", "--json", "--friction-angle", "30"}).out);
    const Json setting =
        Json::parse(runout({"run", "case.toml", "--json", "--set", "material.friction_angle_deg=30"}).out);
    EXPECT_GT(option["run_out_m"].get<double>(), plain["run_out_m"].get<double>());
    EXPECT_EQ(option["run_out_m"], setting["run_out_m"]);
    EXPECT_EQ(option["scenario_hash"], setting["scenario_hash"]);
    EXPECT_NE(option["scenario_hash"], plain["scenario_hash"]);
}

TEST_F(ProgramTest, ASourceThatStandsIsAResult) {
    write("gentle.csv", "chainage_m,elevation_m\n0,0.4\n0.3,0.4\n1.3,0\n3,0\n");  // a face of 22 deg
    const Outcome outcome = runout({"run", "gentle.csv", "--base-angle", "10", "--friction-angle", "38",
                                    "--resolution", "10", "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json run = Json::parse(outcome.out);
    EXPECT_EQ(run["status"], "stable");
    EXPECT_EQ(run["run_out_m"], 0.0);
}

TEST_F(ProgramTest, ARunThatDidNotSettleIsStoredAndEndsWithOne) {
    const Outcome outcome = runout({"run", "case.toml", "--time-limit", "0.01", "--json"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(Json::parse(outcome.out)["status"], "time_limit");
    EXPECT_TRUE(contains(outcome.err, "time_limit"));
    EXPECT_EQ(Store(work("runout.db").string(), Store::Mode::read).runs().at(0).status,
              RunStatus::time_limit);
}

void wait_for_file(const fs::path& path) {
    for (int i = 0; i < 300 && !fs::exists(path); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    std::this_thread::sleep_for(
        std::chrono::seconds(1));  // the run begins right after the database is opened
}

TEST_F(ProgramTest, CtrlCEndsCleanlyWithTheRunStored) {
    Child child(folder_.path(), {"run", "case.toml", "--resolution", "150", "--json"});
    wait_for_file(work("runout.db"));
    child.interrupt();
    const Outcome outcome = child.wait();
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_EQ(Json::parse(outcome.out)["status"], "interrupted");
    const std::vector<StoredRun> stored = Store(work("runout.db").string(), Store::Mode::read).runs();
    ASSERT_EQ(stored.size(), 1u);
    EXPECT_EQ(stored[0].status, RunStatus::interrupted);
}

TEST_F(ProgramTest, ASecondCtrlCEndsAtOnce) {
    Child child(folder_.path(), {"run", "case.toml", "--resolution", "1000", "--json"});
    wait_for_file(work("runout.db"));
    child.interrupt();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    child.interrupt();
    EXPECT_EQ(child.wait().exit_code, 130);
}

// --- accuracy

TEST_F(ProgramTest, ChoosesASpacingThatMeetsTheAccuracyAndSaysWhy) {
    const Outcome outcome = runout({"run", "case.toml", "--accuracy", "40%", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "is expected to meet 40 %")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "expected to take")) << outcome.err;
    const Json run = Json::parse(outcome.out);
    EXPECT_EQ(run["accuracy_asked"], "40 %");
    EXPECT_EQ(run["error_origin"], "pilot");
    EXPECT_GT(run["run_out_error_m"].get<double>(), 0);
    EXPECT_GT(run["expected_cpu_s"].get<double>(), 0);
    const Store store(work("runout.db").string(), Store::Mode::read);
    double pilot_work = 0;
    for (const PilotRow& pilot : store.pilots(1)) pilot_work += pilot.particles * pilot.steps;
    EXPECT_GT(pilot_work, 0);
    EXPECT_LT(pilot_work, 0.5 * run["particles"].get<double>() * run["steps"].get<double>());
}

TEST_F(ProgramTest, RefusesAnAccuracyThatCannotBeMet) {
    expect_refused({"run", "case.toml", "--accuracy", "0.0001%"},
                   {"--accuracy", "run.accuracy = 0.0001%", "cannot be met", "% (", "CPU time"});
    expect_refused({"run", "case.toml", "--accuracy", "5"}, {"--accuracy", "has no unit", "5%"});
    expect_refused({"run", "case.toml", "--accuracy", "5%", "--resolution", "8"}, {"excludes"});
    expect_refused({"accuracy", "case.toml", "--target", "no"}, {"--target = no", "percentage or a length"});
    expect_refused({"accuracy", "case.toml", "--resolution", "8"},
                   {"--resolution", "does not apply to a ladder"});
    expect_refused({"accuracy"}, {"FILE"});
    expect_refused({"accuracy", "case.toml", "--chart", "no/such/folder/a.svg"},
                   {"--chart", "no/such/folder"});
}

TEST_F(ProgramTest, ShowsWhatAccuracyCostsAndUsesItForTheNextRun) {
    const Outcome ladder = runout({"accuracy", "case.toml", "--target", "30%", "--lattices", "2", "--budget",
                                   "30", "--chart", "chart.svg"});
    ASSERT_EQ(ladder.exit_code, 0) << ladder.err;
    for (const char* part : {"sqrt(S)/dl", "The ladder ended because", "run-out, m: ",
                             "What accuracy of the run-out costs on this scene", "The target, 30 %"})
        EXPECT_TRUE(contains(ladder.out, part)) << part << " in\n" << ladder.out;
    EXPECT_TRUE(contains(text_of(work("chart.svg")), "<svg"));
    const Json run = Json::parse(runout({"run", "case.toml", "--json"}).out);
    EXPECT_EQ(run["error_origin"], "ladder");
    EXPECT_EQ(run["choosing_cpu_s"], 0.0);
    EXPECT_GT(run["run_out_error_m"].get<double>(), 0);

    ASSERT_EQ(runout({"accuracy", "--db", "runout.db", "--page", "page.md"}).exit_code, 0);
    EXPECT_TRUE(contains(text_of(work("page.md")), "# What accuracy costs in time"));
    EXPECT_TRUE(fs::exists(work("page/case.svg")) || fs::exists(work("page/work.svg")));
    expect_refused({"accuracy", "--db", "none.db", "--page", "page.md"}, {"none.db"});
}

// --- source and table

TEST_F(ProgramTest, ASurveyOfRandomSlopesGoesOnWhereItWasAndTellsItsCoverage) {
    const Arguments survey = {"accuracy", "--slopes",   "2", "--seed", "3",         "--finest", "16",
                              "--check",  "--lattices", "2", "--db",   "slopes.db", "--budget", "1"};
    const auto count = [&](const std::string& of) {
        return SQLite::Database(work("slopes.db").string()).execAndGet("SELECT count(*) FROM " + of).getInt();
    };
    const Outcome first = runout(survey);
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_TRUE(contains(first.err, "2 of 2: ")) << first.err;
    EXPECT_TRUE(contains(first.out, "target   runs    inside")) << first.out;
    EXPECT_TRUE(contains(first.out, "10 %")) << first.out;
    EXPECT_EQ(count("ladder_run WHERE series = 'spacing'"), 2 * 3 * 2) << "scenes, rungs, lattices";
    const int runs = count("run");
    EXPECT_EQ(runout({"accuracy", "--slopes", "2", "--seed", "3", "--finest", "16", "--lattices", "2", "--db",
                      "slopes.db", "--survey", "survey.csv"})
                  .exit_code,
              0);
    EXPECT_EQ(count("run"), runs) << "the same runs again";
    EXPECT_TRUE(contains(text_of(work("survey.csv")), "scene,lattices,resolution"));
    expect_refused({"accuracy", "case.toml", "--slopes", "2"}, {"--slopes = 2", "without FILE"});
}

TEST_F(ProgramTest, PrintsTheSourceOnly) {
    const std::set<std::string> before = files();
    const Outcome outcome = runout({"source", "section.csv", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json source = Json::parse(outcome.out);
    for (const char* key :
         {"source_type", "source_area_m2", "front_area_m2", "front_area_ratio", "exit_point", "head",
          "drop_height_m", "outline", "bed", "discontinuity_angle_deg", "slope_angle_deg"})
        EXPECT_TRUE(source.contains(key)) << key;
    EXPECT_EQ(source["source_type"], "B");
    EXPECT_EQ(source["head"], Json({0.3, 0.4}));  // in section coordinates: the crest
    EXPECT_EQ(source["outline"].size(), 3u);
    EXPECT_EQ(files(), before);

    const Outcome words = runout({"source", "case.toml"});
    EXPECT_EQ(words.exit_code, 0);
    EXPECT_TRUE(contains(words.out, "S_front")) << words.out;
}

TEST_F(ProgramTest, ListsTheRunsOfADatabase) {
    ASSERT_EQ(runout({"run", "case.toml", "--name", "first"}).exit_code, 0);
    ASSERT_EQ(runout({"run", "case.toml", "--name", "second", "--friction-angle", "30"}).exit_code, 0);
    const Outcome text = runout({"table", "runout.db"});
    EXPECT_EQ(text.exit_code, 0);
    EXPECT_TRUE(contains(text.out, "first") && contains(text.out, "second")) << text.out;
    const Outcome csv = runout({"table", "runout.db", "--format", "csv"});
    EXPECT_EQ(std::ranges::count(csv.out, '\n'), 3) << csv.out;
    const Json json = Json::parse(runout({"table", "runout.db", "--format", "json"}).out);
    EXPECT_EQ(json.size(), 2u);
}

TEST_F(ProgramTest, RefusesTablesItCannotMake) {
    expect_refused({"table", "none.db"}, {"none.db"});
    expect_refused({"table", "section.csv"}, {"section.csv"});
    ASSERT_EQ(runout({"run", "case.toml"}).exit_code, 0);
    expect_refused({"table", "runout.db", "--format", "xml"}, {"xml", "valid: text, csv, json"});
}

TEST_F(ProgramTest, EffectsAreListedOnOrOffWithTheirCost) {
    write("wet.toml", std::string(sound_case) + "[effects.pore_pressure]\nratio = 0.1\n");
    const Outcome outcome = runout({"effects", "wet.toml"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("pore_pressure  on"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("ratio = 0.1"), std::string::npos);
    EXPECT_NE(outcome.out.find("cohesion       off  nothing"), std::string::npos) << outcome.out;
    EXPECT_EQ(files(), (std::set<std::string>{"case.toml", "section.csv", "wet.toml"}));
}

TEST_F(ProgramTest, ARunSaysWhichEffectsItHad) {
    write("placed.toml", std::string(sound_case) + "[[place]]\nname = \"house\"\nchainage_m = 0.5\n");
    const Outcome outcome = runout({"run", "placed.toml"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("Place house at chainage 0.5 m: reached after"), std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("Effects on: places"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("Off: base_friction, cohesion"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace runout
