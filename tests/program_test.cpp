// The real program, as a shell sees it: exit codes, what goes to which stream, what is left on the disk.

#include <SQLiteCpp/Database.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "core/version.h"
#include "scene/parameters.h"
#include "store/store.h"

namespace runout {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

std::string text_of(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

struct Outcome {
    int exit_code = -1;  ///< -1: killed by a signal
    std::string out;
    std::string err;
};

/// `runout` with its streams in files beside its working directory.
class Child {
  public:
    Child(const fs::path& folder, const Arguments& arguments) : streams_(folder / "streams") {
        fs::create_directories(streams_);
        pid_ = fork();
        if (pid_ == 0) become_runout(folder / "work", arguments);
    }

    void interrupt() const { kill(pid_, SIGINT); }
    void kill_at_once() const { kill(pid_, SIGKILL); }

    Outcome wait() {
        int status = 0;
        waitpid(pid_, &status, 0);
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(streams_ / "out"),
                text_of(streams_ / "err")};
    }

  private:
    [[noreturn]] void become_runout(const fs::path& work, const Arguments& arguments) const {
        const auto redirect = [](const fs::path& path, int stream) {
            dup2(open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0644), stream);
        };
        redirect(streams_ / "out", STDOUT_FILENO);
        redirect(streams_ / "err", STDERR_FILENO);
        std::vector<char*> argv;
        std::string program = RUNOUT_PROGRAM;
        argv.push_back(program.data());
        Arguments copies = arguments;
        for (std::string& argument : copies) argv.push_back(argument.data());
        argv.push_back(nullptr);
        if (chdir(work.c_str()) == 0) execv(program.c_str(), argv.data());
        _exit(127);
    }

    fs::path streams_;
    pid_t pid_ = -1;
};

constexpr const char* slope = "chainage_m,elevation_m\n0,0.4\n0.3,0.4\n0.45,0\n2.5,0\n";

constexpr const char* sound_case =
    "[section]\n"                // line 1
    "file = \"section.csv\"\n"   // 2
    "[source]\n"                 // 3
    "type = \"B\"\n"             // 4
    "base_angle_deg = 35\n"      // 5
    "scarp_angle_deg = 80\n"     // 6
    "height_m = 0.15\n"          // 7
    "drop_height_m = 0.3\n"      // 8
    "[material]\n"               // 9
    "friction_angle_deg = 38\n"  // 10
    "[run]\n"                    // 11
    "resolution = 10\n";         // 12

class ProgramTest : public testing::Test {
  protected:
    ProgramTest()
        : folder_(fs::temp_directory_path() / fmt::format("runout-program-{}-{}", getpid(), test_name())) {
        fs::create_directories(folder_ / "work");
        write("section.csv", slope);
        write("case.toml", sound_case);
    }
    ~ProgramTest() override { fs::remove_all(folder_); }

    static std::string test_name() {
        std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        for (char& c : name)
            if (c == '/') c = '-';
        return name;
    }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / "work" / name, std::ios::binary) << text;
    }

    [[nodiscard]] fs::path work(const std::string& name = "") const { return folder_ / "work" / name; }

    [[nodiscard]] Outcome runout(const Arguments& arguments) const {
        return Child(folder_, arguments).wait();
    }

    [[nodiscard]] std::set<std::string> files() const {
        std::set<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(folder_ / "work"))
            names.insert(fs::relative(entry.path(), folder_ / "work").string());
        return names;
    }

    /// A refusal: exit code 2, one sentence on standard error, nothing else, nothing written.
    void expect_refused(const Arguments& arguments, const std::vector<std::string>& parts) const {
        SCOPED_TRACE(fmt::format("runout {}", fmt::join(arguments, " ")));
        const std::set<std::string> before = files();
        const Outcome outcome = runout(arguments);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_TRUE(outcome.err.starts_with("runout: error: ")) << outcome.err;
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
        for (const std::string& part : parts)
            EXPECT_TRUE(contains(outcome.err, part)) << part << ": " << outcome.err;
        EXPECT_EQ(files(), before);
    }

    fs::path folder_;
};

// --- help

TEST_F(ProgramTest, TellsItsVersionAndRevision) {
    const Outcome outcome = runout({"--version"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, fmt::format("runout {} (revision {}, {})\n", program_version(), program_revision(),
                                       compiler_description()));
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
    expect_refused({"rnu", "case.toml"},
                   {"rnu is not a subcommand",
                    "run, profile, source, effects, sweep, merge, table, estimate, accuracy, map"});
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
    Child child(folder_, {"run", "case.toml", "--resolution", "150", "--json"});
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
    Child child(folder_, {"run", "case.toml", "--resolution", "1000", "--json"});
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

// --- bad input: every mistake of the issue

// --- reports

TEST_F(ProgramTest, ReportsComparesAndExportsAStoredRun) {
    ASSERT_EQ(runout({"run", "case.toml", "--quiet", "--frames", "10"}).exit_code, 0);
    const Outcome report = runout({"report", "runout.db", "-o", "page.html"});
    EXPECT_EQ(report.exit_code, 0) << report.err;
    EXPECT_EQ(report.out, "");
    const std::string page = text_of(work() / "page.html");
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
    EXPECT_TRUE(contains(page, "\"animation\":{"));

    const Outcome compare = runout({"compare", "runout.db", "--width", "2"});
    EXPECT_EQ(compare.exit_code, 0) << compare.err;
    EXPECT_TRUE(contains(compare.out, "Hunter & Fell"));
    EXPECT_TRUE(contains(compare.out, "over a width of 2 m"));

    const Outcome files = runout({"export", "runout.db", "--vtk", "made/points", "--csv", "tables"});
    EXPECT_EQ(files.exit_code, 0) << files.err;
    EXPECT_TRUE(fs::exists(work() / "made/points/particles.pvd"));
    EXPECT_TRUE(fs::exists(work() / "made/points/particles_0000.vtp"));
    EXPECT_TRUE(fs::exists(work() / "tables/series.csv"));

    EXPECT_EQ(runout({"report", "runout.db", "--section", "1", "-o", "section.html"}).exit_code, 0);
}

TEST_F(ProgramTest, RefusesReportsItCannotMake) {
    expect_refused({"report", "none.db"}, {"none.db", "no such file"});
    ASSERT_EQ(runout({"run", "case.toml", "--quiet", "--frames", "0"}).exit_code, 0);
    expect_refused({"report", "runout.db", "--run", "7"}, {"7", "no such run"});
    expect_refused({"report", "runout.db", "--section", "7"}, {"7", "section"});
    expect_refused({"report", "runout.db", "--study", "none"}, {"--study = none", "it holds no study"});
    expect_refused({"report", "runout.db", "--run", "1", "--study", "none"}, {"--study"});
    expect_refused({"report", "runout.db", "--run", "1", "--section", "1"}, {"--section"});
    expect_refused({"report", "runout.db", "-o", "absent/page.html"}, {"absent", "does not exist"});
    expect_refused({"report", "runout.db", "-o", "."}, {"is a directory"});
    expect_refused({"compare", "runout.db", "--width", "-3"}, {"--width"});
    expect_refused({"export", "runout.db"}, {"--vtk", "--csv"});
    expect_refused({"export", "runout.db", "--vtk", "points"}, {"no particles stored"});
    expect_refused({"back-analysis", "absent"}, {"absent", "is not a folder"});
    EXPECT_FALSE(fs::exists(work() / "report.html"));
    EXPECT_FALSE(fs::exists(work() / "points"));
    EXPECT_FALSE(fs::exists(work() / "back-analysis.db"));
}

TEST_F(ProgramTest, AnEmptyDatabaseHasNothingToReport) {
    { const Store store((work() / "empty.db").string(), Store::Mode::write); }
    expect_refused({"report", "empty.db"}, {"empty.db", "holds no runs"});
    expect_refused({"compare", "empty.db"}, {"empty.db", "holds no runs"});
    expect_refused({"export", "empty.db", "--csv", "x"}, {"empty.db", "holds no runs"});
}

TEST_F(ProgramTest, ARunThatFailedIsReportedAsSuchAndNotCompared) {
    ASSERT_EQ(runout({"run", "case.toml", "--quiet", "--time-limit", "0.05"}).exit_code, 1);
    EXPECT_EQ(runout({"report", "runout.db", "-o", "page.html"}).exit_code, 0);
    EXPECT_TRUE(contains(text_of(work() / "page.html"), "Last state, not a result"));
    expect_refused({"compare", "runout.db"}, {"cannot be compared", "time_limit"});
}

TEST_F(ProgramTest, BadFiles) {
    expect_refused({"run", "none.toml"}, {"none.toml", "does not exist"});
    expect_refused({"run", "none.csv", "--friction-angle", "38"}, {"none.csv"});
    write("empty.toml", "");
    expect_refused({"run", "empty.toml"}, {"empty.toml", "is empty"});
    write("empty.csv", "");
    expect_refused({"run", "empty.csv", "--friction-angle", "38"}, {"empty.csv"});
    write("broken.toml", "[section\n");
    expect_refused({"run", "broken.toml"}, {"broken.toml, line 1", "TOML"});
    expect_refused({"run", "."}, {"folder"});
}

TEST_F(ProgramTest, BadSections) {
    const auto refused = [&](const std::string& text, const std::vector<std::string>& parts) {
        write("bad.csv", text);
        expect_refused({"run", "bad.csv", "--friction-angle", "38"}, parts);
        expect_refused({"source", "bad.csv"}, parts);
    };
    const std::string header = "chainage_m,elevation_m\n";
    refused(header + "0,1\n", {"bad.csv", "one point"});
    refused(header + "0,1\n1,high\n", {"bad.csv, line 3", "elevation_m", "high"});
    refused(header + "0,1\nnan,0\n", {"bad.csv, line 3", "chainage_m", "nan"});
    refused("chainage_m,elevation_m,colour\n0,1,red\n1,0,red\n", {"bad.csv, line 1", "colour"});
    refused("x,y\n0,1\n1,0\n", {"bad.csv, line 1", "chainage_m"});
    refused(header + "0,1\n1,0\n0.5,-1\n", {"bad.csv, line 4", "chainage_m = 0.5", "overhang"});
    refused(header + "0,1\n1,0\n1,0\n2,0\n", {"bad.csv, line 4", "repeats"});
}

TEST_F(ProgramTest, BadKeys) {
    const std::string section = "[section]\nfile = \"section.csv\"\n[material]\n";
    const auto refused = [&](const std::string& text, const std::vector<std::string>& parts) {
        write("bad.toml", text);
        expect_refused({"run", "bad.toml"}, parts);
    };
    refused(section + "friction_angel_deg = 38\n",
            {"bad.toml, line 4", "friction_angel_deg = 38", "friction_angle_deg"});
    refused(section + "friction_angle_deg = 95\n", {"bad.toml, line 4", "= 95", "0 <= number < 80 deg"});
    refused(section + "friction_angle_deg = \"x\"\n", {"bad.toml, line 4", "not a number"});
    refused(section + "density_kg_m3 = 2000\n", {"bad.toml", "material.friction_angle_deg", "missing"});
    refused(section + "friction_angle_deg = 38\n[run]\nresolution = 40\nparticle_spacing_m = 0.01\n",
            {"bad.toml, line 7", "excludes run.resolution"});
    refused(section + "friction_angle_deg = 38\n[run]\nparticle_spacing_m = 10\n",
            {"bad.toml, line 6", "particles"});
    expect_refused({"run", "case.toml", "--friction-angle", "-1"},
                   {"--friction-angle", "= -1", "out of range"});
    expect_refused({"run", "case.toml", "--set", "run.speed=3"},
                   {"--set", "run.speed = 3", "not a known key"});
}

TEST_F(ProgramTest, BadSources) {
    const Arguments bare = {"run", "section.csv", "--friction-angle", "38"};
    const auto with = [&](Arguments more) {
        more.insert(more.begin(), bare.begin(), bare.end());
        return more;
    };
    expect_refused(with({"--height", "0.2", "--area", "0.5"}), {"source.area_m2", "height"});
    expect_refused(with({"--scarp-angle", "60"}),
                   {"--scarp-angle", "source.scarp_angle_deg = 60", "steeper than the face"});
    expect_refused(with({"--height", "3"}), {"--height", "source.height_m = 3"});
    expect_refused(with({"--drop-height", "2"}), {"--drop-height", "source.drop_height_m = 2"});
    expect_refused(with({"--length", "2"}), {"--length", "does not apply to source.type = B"});
    expect_refused(with({"--source", "polygon", "--set", "source.points=[[5,0.5],[6,0.5],[6,0.6],[5,0.6]]"}),
                   {"source.points"});
}

/// The database's version number stands in bytes 60 to 63 of the file, most significant first.
void write_user_version(const fs::path& database, char version) {
    std::fstream file(database, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(60);
    const char bytes[4] = {0, 0, 0, version};
    file.write(bytes, 4);
}

TEST_F(ProgramTest, BadDatabasesAreFoundBeforeTheWork) {
    // This resolution would keep the program busy for hours.
    const auto refused = [&](const std::string& database, const std::vector<std::string>& parts) {
        const auto start = std::chrono::steady_clock::now();
        expect_refused({"run", "case.toml", "--resolution", "1000", "--db", database}, parts);
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
    };
    refused("no/such/folder/runs.db", {"no/such/folder/runs.db"});
    fs::create_directories(work("folder.db"));
    refused("folder.db", {"folder.db"});
    refused("section.csv", {"section.csv"});
    EXPECT_EQ(text_of(work("section.csv")), slope);

    ASSERT_EQ(runout({"run", "case.toml", "--db", "newer.db"}).exit_code, 0);
    write_user_version(work("newer.db"), 99);
    refused("newer.db", {"newer.db", "99"});
}

TEST_F(ProgramTest, ADatabaseIsNotMadeForBadInput) {
    expect_refused({"run", "case.toml", "--base-angle", "75", "--db", "new.db"}, {"source.base_angle_deg"});
    EXPECT_FALSE(fs::exists(work("new.db")));
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
    write("gauged.toml", std::string(sound_case) + "[[gauge]]\nname = \"house\"\nchainage_m = 0.5\n");
    const Outcome outcome = runout({"run", "gauged.toml"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("Gauge house at chainage 0.5 m: arrival after"), std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("Effects on: gauges"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("Off: base_friction, cohesion"), std::string::npos) << outcome.out;
}

// --- from map to map

const std::string terrain = RUNOUT_SOURCE_DIR "/cases/terrain/case.toml";

TEST_F(ProgramTest, ShowsTheSectionsOfALayer) {
    const Outcome all = runout({"profile", terrain});
    EXPECT_EQ(all.exit_code, 0) << all.err;
    EXPECT_EQ(std::ranges::count(all.out, '\n'), 12) << "a title of two lines and ten sections\n" << all.out;
    EXPECT_TRUE(contains(all.out, "terrain-J-J"));

    const Outcome one = runout({"profile", terrain, "--where", "name = 'C-C'", "--svg", "c.svg"});
    EXPECT_EQ(one.exit_code, 0) << one.err;
    for (const char* part :
         {"terrain.tif along", "layer sections, feature 3", "toe ", "crest ", "face ", "T toe", "# source"})
        EXPECT_TRUE(contains(one.out, part)) << part;
    EXPECT_TRUE(text_of(work("c.svg")).starts_with("<svg")) << text_of(work("c.svg")).substr(0, 60);
}

TEST_F(ProgramTest, ASectionWithoutASourceIsShownAllTheSame) {
    write("flat.csv", "chainage_m,elevation_m\n0,1\n10,1\n20,0.9\n");
    const Outcome ground = runout({"profile", "flat.csv"});
    EXPECT_EQ(ground.exit_code, 0);
    EXPECT_TRUE(contains(ground.err, "no source is shown: ")) << ground.err;
    expect_refused({"profile", "flat.csv", "--source", "C"}, {});
}

TEST_F(ProgramTest, SectionsOfAMapAreRunAndDrawn) {
    const Outcome run = runout({"run", terrain, "--where", "id in (4, 5)", "--resolution", "8", "--db",
                                "t.db", "--threads", "1", "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_TRUE(contains(run.out, "terrain-D-D: the front stops"));
    EXPECT_TRUE(contains(run.out, "terrain-E-E: the front stops"));
    const Json rows = Json::parse(runout({"table", "t.db", "--format", "json"}).out);
    EXPECT_EQ(rows.at(0).at("section_attributes").at("slope_no"), "11SW-D/C101");

    const Outcome map = runout({"map", "t.db", "-o", "t.gpkg"});
    EXPECT_EQ(map.exit_code, 0) << map.err;
    for (const char* layer :
         {"hazard_band ", "section ", "deposit ", "thickness ", "source ", "runout_extent "})
        EXPECT_TRUE(contains(map.out, layer)) << layer << map.out;
    EXPECT_TRUE(fs::exists(work("t.gpkg")));
    expect_refused({"map", "t.db", "-o", "t.gpkg"}, {"--output = t.gpkg", "exists", "--overwrite"});
    EXPECT_EQ(runout({"map", "t.db", "-o", "t.gpkg", "--overwrite"}).exit_code, 0);
    EXPECT_EQ(runout({"map", "t.db", "-o", "t.geojson"}).exit_code, 0);
    const Json features = Json::parse(text_of(work("t.geojson"))).at("features");
    EXPECT_GT(features.size(), 10u);
    EXPECT_TRUE(features.at(0).at("properties").contains("layer"));
}

TEST_F(ProgramTest, BadMaps) {
    expect_refused({"map", "none.db", "-o", "t.gpkg"}, {"none.db"});
    expect_refused({"map", "none.db"}, {"--output"});
    expect_refused({"run", terrain, "--where", "id = 99"},
                   {"section.where = id = 99", "holds for no feature"});
    expect_refused({"run", terrain, "--set", "section.layer=roads"},
                   {"section.layer = roads", "name one of sections"});
}

// --- sweeps

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
        Child child(folder_, {"sweep", "study.toml", "--db", "killed.db", "-j", "2", "--quiet"});
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
    expect_refused({"sweep", "none.toml"}, {"none.toml", "is not a file"});
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
