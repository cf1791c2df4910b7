// Databases in careless hands: read while a run ends, copied without their log, merged after a change,
// cleared out. What has ended is stored somewhere, and what was lost is said.

#include <SQLiteCpp/SQLiteCpp.h>

#include <chrono>
#include <optional>
#include <thread>

#include "program_fixture.h"
#include "store/store.h"

namespace runout {
namespace {

using SQLite::Database;

Arguments run_into(const std::string& database, const std::string& name, const std::string& angle = "38") {
    return {"run",         "case.toml", "--db",  database,
            "--name",      name,        "--set", "material.friction_angle_deg=" + angle,
            "--no-pilots", "--frames",  "0"};
}

class DatabasesTest : public ProgramTest {
  protected:
    [[nodiscard]] Database raw(const std::string& name) const {
        return {work(name).string(), SQLite::OPEN_READWRITE};
    }
    [[nodiscard]] long count(const std::string& name, const std::string& what) const {
        return Database(work(name).string(), SQLite::OPEN_READONLY)
            .execAndGet("SELECT count(*) FROM " + what)
            .getInt64();
    }
    /// The one file whose name begins so.
    [[nodiscard]] std::string file_beginning(const std::string& start) const {
        std::string found;
        for (const std::string& file : files())
            if (file.starts_with(start)) found = file;
        return found;
    }
    /// Nobody can be asked: what would go is listed, and stays.
    void expect_refused_with_list(const Arguments& arguments) const {
        const long before = count("v.db", "run");
        const Outcome outcome = runout(arguments);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_TRUE(contains(outcome.out, "To be removed from v.db: 1 run\n")) << outcome.out;
        EXPECT_TRUE(contains(outcome.err, "give --yes")) << outcome.err;
        EXPECT_EQ(count("v.db", "run"), before);
    }
    [[nodiscard]] bool says_soon(const std::string& part) const {
        for (int i = 0; i < 3000; ++i) {
            if (contains(text_of(folder_.path() / "streams" / "err"), part)) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return false;
    }
};

/// A program that looks at a database in the middle of a transaction, as QGIS does.
class Looking {
  public:
    explicit Looking(Database database) : database_(std::move(database)) {
        database_->exec("BEGIN");
        (void)database_->execAndGet("SELECT count(*) FROM run");
    }
    void end() { database_.reset(); }

  private:
    std::optional<Database> database_;
};

TEST_F(DatabasesTest, ARunThatEndsWhileAnotherProgramLooksIsStoredBesideAndMergedLater) {
    ASSERT_EQ(runout(run_into("v.db", "first")).exit_code, 0);
    Looking other(raw("v.db"));
    Arguments arguments = run_into("v.db", "second", "36");
    arguments.insert(arguments.end(), {"--wait", "1"});
    const Outcome outcome = runout(arguments);
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "second: the front stops")) << outcome.out;
    const std::string side = file_beginning("v-side-");
    ASSERT_FALSE(side.empty()) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "runout merge v.db " + side)) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "v.db: has been locked by another program")) << outcome.err;
    EXPECT_EQ(count("v.db", "run"), 1);
    other.end();
    const Outcome merged = runout({"merge", "v.db", side});
    EXPECT_EQ(merged.exit_code, 0) << merged.err;
    EXPECT_TRUE(contains(merged.out, "1 runs added")) << merged.out;
    EXPECT_EQ(count("v.db", "run"), 2);
}

TEST_F(DatabasesTest, ARunWaitsForAProgramThatLooksForAWhile) {
    ASSERT_EQ(runout(run_into("v.db", "first")).exit_code, 0);
    Looking other(raw("v.db"));
    Child child(folder_.path(), run_into("v.db", "second", "36"));
    EXPECT_TRUE(says_soon("v.db is in use by another program; trying for"));
    other.end();
    EXPECT_EQ(child.wait().exit_code, 0);
    EXPECT_EQ(count("v.db", "run"), 2);
    EXPECT_EQ(file_beginning("v-side-"), "");
}

TEST_F(DatabasesTest, WithALogAProgramThatLooksIsNoHindrance) {
    ASSERT_EQ(runout(run_into("v.db", "first")).exit_code, 0);
    raw("v.db").exec("PRAGMA journal_mode = wal");
    Looking other(raw("v.db"));
    Arguments arguments = run_into("v.db", "second", "36");
    arguments.insert(arguments.end(), {"--wait", "0"});
    EXPECT_EQ(runout(arguments).exit_code, 0);
    EXPECT_EQ(count("v.db", "run"), 2);
    EXPECT_TRUE(contains(runout({"table", "v.db"}).out, "second")) << "while the other still looks";
}

TEST_F(DatabasesTest, AfterARunTheOneFileIsComplete) {
    ASSERT_EQ(runout(run_into("v.db", "first")).exit_code, 0);
    EXPECT_EQ(files(), (std::set<std::string>{"case.toml", "section.csv", "v.db"}));
    EXPECT_EQ(raw("v.db").execAndGet("PRAGMA journal_mode").getString(), "delete");
}

TEST_F(DatabasesTest, AHelpPageAndAReadmeNameTheExitCode) {
    EXPECT_TRUE(contains(runout({"--help"}).out, "4 stored elsewhere"));
    EXPECT_TRUE(contains(text_of(fs::path(RUNOUT_SOURCE_DIR) / "README.md"), "4 for a run"));
}

// ---- copies without their log

constexpr const char* long_study =
    "[study]\nname = \"long\"\ncase = \"case.toml\"\n[vary]\n"
    "material.friction_angle_deg = { from = 30, to = 45, step = 0.05 }\n";

TEST_F(DatabasesTest, OfAKilledSweepTheOneFileAloneHoldsWhatEndedSecondsBefore) {
    write("study.toml", long_study);
    Child child(folder_.path(), {"sweep", "study.toml", "--db", "v.db", "-j", "1", "--quiet"});
    long runs = 0;
    for (int i = 0; i < 2000 && runs == 0; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        std::error_code not_yet;
        fs::copy_file(work("v.db"), work("copy.db"), fs::copy_options::overwrite_existing, not_yet);
        try {
            if (!not_yet)
                runs = static_cast<long>(Store(work("copy.db").string(), Store::Mode::read).runs().size());
        } catch (const std::exception&) {
            runs = 0;  // copied in the middle of a write
        }
    }
    child.kill_at_once();
    EXPECT_EQ(child.wait().exit_code, -1) << "it must have been killed at work";
    EXPECT_GT(runs, 0) << "while the sweep still ran";
    fs::copy_file(work("v.db"), work("alone.db"));
    const Outcome merged = runout({"merge", "all.db", "alone.db"});
    EXPECT_EQ(merged.exit_code, 1);
    EXPECT_TRUE(contains(merged.err, "there is no alone.db-wal beside it: runs may be missing"))
        << merged.err;
    EXPECT_GE(count("all.db", "run"), runs);
    const Outcome whole = runout({"merge", "all.db", "v.db"});
    EXPECT_EQ(whole.exit_code, 0) << whole.err << "with its log beside it";
    EXPECT_EQ(count("all.db", "run"), count("v.db", "run"));
}

TEST_F(DatabasesTest, LookingLeavesNothingBehind) {
    ASSERT_EQ(runout(run_into("v.db", "first")).exit_code, 0);
    raw("v.db").exec("PRAGMA journal_mode = wal");
    const auto before = files();
    const std::string bytes = text_of(work("v.db"));
    EXPECT_EQ(runout({"table", "v.db"}).exit_code, 0);
    EXPECT_EQ(files(), before);
    EXPECT_EQ(text_of(work("v.db")), bytes);
}

// ---- merging

TEST_F(DatabasesTest, ADamagedPartIsNamedBeforeAnyIsMerged) {
    ASSERT_EQ(runout(run_into("a.db", "a")).exit_code, 0);
    ASSERT_EQ(runout(run_into("b.db", "b", "36")).exit_code, 0);
    fs::copy_file(work("b.db"), work("cut.db"));
    fs::resize_file(work("cut.db"), fs::file_size(work("b.db")) / 2);
    fs::copy_file(work("b.db"), work("holed.db"));
    {
        std::fstream file(work("holed.db"), std::ios::in | std::ios::out | std::ios::binary);
        for (const std::streamoff page : {5, 9, 13}) file.seekp(page * 4096) << std::string(4096, '\x7f');
    }
    write("text.db",
          "not a database, and long enough to be looked at as if it were one, which it is not at all");
    for (const std::string bad : {"cut.db", "holed.db", "text.db", "missing.db"}) {
        expect_refused({"merge", "m.db", "a.db", bad}, {"error: " + bad + ": "});
        expect_refused({"merge", "a.db", "b.db", bad}, {"error: " + bad + ": "});
    }
    EXPECT_EQ(count("a.db", "run"), 1);
    EXPECT_EQ(runout({"merge", "m.db", "a.db", "b.db"}).exit_code, 0);
}

TEST_F(DatabasesTest, APartThatContradictsIsSaidWithWhatWasMergedBeforeIt) {
    ASSERT_EQ(runout(run_into("a.db", "a")).exit_code, 0);
    ASSERT_EQ(runout(run_into("c.db", "c", "36")).exit_code, 0);
    fs::copy_file(work("a.db"), work("b.db"));
    raw("b.db").exec("UPDATE measure SET run_out_m = run_out_m + 1");
    const Outcome outcome = runout({"merge", "m.db", "a.db", "b.db", "c.db"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_TRUE(contains(outcome.out, "a.db: 1 runs added")) << outcome.out;
    EXPECT_TRUE(contains(outcome.err, "b.db: run = 1: (a) has another result")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "the 1 before it are merged")) << outcome.err;
    EXPECT_EQ(count("m.db", "run"), 1);
    expect_refused({"merge", "a.db", "b.db"}, {"b.db: run = 1"});
    expect_refused({"merge", "a.db", "./a.db"}, {"is the database to merge into"});
}

TEST_F(DatabasesTest, PartsOfAStudyWhoseCaseOrSectionChangedAreNotMerged) {
    write("study.toml",
          "[study]\nname = \"s\"\ncase = \"case.toml\"\n[vary]\nmaterial.friction_angle_deg = [34, 36]\n");
    const auto part = [&](const char* shard, const char* database) {
        return runout({"sweep", "study.toml", "--shard", shard, "--db", database, "-j", "1", "--quiet"})
            .exit_code;
    };
    ASSERT_EQ(part("0/2", "0.db"), 0);
    ASSERT_EQ(part("1/2", "1.db"), 0);
    std::string finer = sound_case;
    finer.replace(finer.find("resolution = 10"), 15, "resolution = 8 ");
    write("case.toml", finer);
    ASSERT_EQ(part("1/2", "finer.db"), 0);
    write("case.toml", sound_case);
    write("section.csv", "chainage_m,elevation_m\n0,0.4\n0.3,0.4\n0.45,0\n2.6,0\n");
    ASSERT_EQ(part("1/2", "longer.db"), 0);
    expect_refused({"merge", "0.db", "finer.db"}, {"finer.db", "study = s", "asks something else"});
    expect_refused({"merge", "0.db", "longer.db"}, {"longer.db", "study = s", "asks something else"});
    EXPECT_EQ(runout({"merge", "0.db", "1.db"}).exit_code, 0);
    EXPECT_EQ(count("0.db", "study_scenario"), 2);
}

// ---- deleting

TEST_F(DatabasesTest, ARunIsRemovedWholeAndItsSpaceGivenBack) {
    for (const char* angle : {"34", "36", "38"})
        ASSERT_EQ(runout(run_into("v.db", "run", angle)).exit_code, 0);
    ASSERT_EQ(runout({"run", "case.toml", "--db", "v.db", "--name", "large", "--set",
                      "material.friction_angle_deg=33", "--no-pilots"})
                  .exit_code,
              0);
    const auto size = fs::file_size(work("v.db"));
    expect_refused_with_list({"delete", "v.db", "--run", "4"});
    const Outcome removed = runout({"delete", "v.db", "--run", "4", "--run", "2", "--yes"});
    EXPECT_EQ(removed.exit_code, 0) << removed.err;
    EXPECT_TRUE(contains(removed.out, "2 runs\n  run 4: large, settled")) << removed.out;
    EXPECT_LT(fs::file_size(work("v.db")), size);
    EXPECT_EQ(count("v.db", "pragma_freelist_count WHERE freelist_count > 0"), 0);
    for (const char* table : {"run", "measure", "scenario"}) EXPECT_EQ(count("v.db", table), 2) << table;
    for (const char* table : {"series", "deposit_profile", "frame", "phase_time", "invariant"})
        EXPECT_EQ(count("v.db", std::string(table) + " WHERE run_id NOT IN (SELECT run_id FROM run)"), 0)
            << table;
    EXPECT_EQ(count("v.db", "section"), 1) << "the others stand on it";
    EXPECT_EQ(count("v.db", "pragma_foreign_key_check"), 0);
    EXPECT_EQ(runout(run_into("v.db", "again", "36")).exit_code, 0);
    EXPECT_EQ(count("v.db", "run WHERE run_id > 4"), 1) << "an id is not given twice";
    EXPECT_EQ(runout({"delete", "v.db", "--older-than", "2999-01-01", "--yes"}).exit_code, 0);
    for (const char* table : {"run", "scenario", "source", "section", "section_point", "source_point"})
        EXPECT_EQ(count("v.db", table), 0) << table;
}

TEST_F(DatabasesTest, AStudyGoesWithItsRunsButThoseThatAnotherShares) {
    const auto study = [&](const std::string& name, const std::string& angles) {
        write(name + ".toml",
              "[study]\ncase = \"case.toml\"\n[vary]\nmaterial.friction_angle_deg = " + angles + "\n");
        EXPECT_EQ(runout({"sweep", name + ".toml", "--db", "v.db", "-j", "1", "--quiet"}).exit_code, 0);
    };
    study("one", "[34, 36]");
    study("two", "[36, 38]");
    const Outcome removed = runout({"delete", "v.db", "--study", "one", "--yes"});
    EXPECT_EQ(removed.exit_code, 0) << removed.err;
    EXPECT_TRUE(contains(removed.out, "Kept: 1 of its runs")) << removed.out;
    EXPECT_EQ(count("v.db", "run"), 2);
    EXPECT_EQ(count("v.db", "study"), 1);
    EXPECT_EQ(count("v.db", "study_scenario"), 2);
    EXPECT_TRUE(contains(runout({"table", "v.db"}).out, "Run-out of two"));
}

TEST_F(DatabasesTest, NothingIsRemovedByMistake) {
    ASSERT_EQ(runout(run_into("v.db", "first")).exit_code, 0);
    const std::string before = text_of(work("v.db"));
    expect_refused({"delete", "v.db"}, {"--run, --study or --older-than"});
    expect_refused({"delete", "v.db", "--run", "1", "--older-than", "1d"}, {"in one way"});
    expect_refused({"delete", "v.db", "--run", "7", "--yes"}, {"--run = 7", "is not in this database"});
    expect_refused({"delete", "v.db", "--study", "x", "--yes"}, {"--study = x"});
    for (const char* age : {"soon", "-1d", "1y", "9999999d", "2024-5-1", "2024-05-01' OR '1'='1"})
        expect_refused({"delete", "v.db", "--older-than", age, "--yes"}, {"is no age and no date"});
    expect_refused({"delete", "none.db", "--run", "1", "--yes"}, {"no such file"});
    EXPECT_TRUE(contains(runout({"delete", "v.db", "--older-than", "1d", "--yes"}).out, "0 runs"));
    EXPECT_TRUE(contains(runout({"delete", "v.db", "--older-than", "2024-05-31", "--yes"}).out, "0 runs"));
    EXPECT_EQ(text_of(work("v.db")), before);
}

TEST_F(DatabasesTest, NothingIsRemovedWhileAnotherProgramWritesOrLooks) {
    ASSERT_EQ(runout(run_into("v.db", "first")).exit_code, 0);
    const Arguments remove = {"delete", "v.db", "--run", "1", "--yes"};
    {
        Database writer = raw("v.db");
        writer.exec("PRAGMA journal_mode = wal");
        (void)writer.execAndGet("SELECT count(*) FROM run");
        const Outcome outcome = runout(remove);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_TRUE(contains(outcome.err, "v.db: is in use by another program")) << outcome.err;
    }
    raw("v.db").exec("PRAGMA journal_mode = delete");
    {
        const Looking other(raw("v.db"));
        const Outcome outcome = runout(remove);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_TRUE(contains(outcome.err, "v.db: ")) << outcome.err;
    }
    EXPECT_EQ(count("v.db", "run"), 1);
    EXPECT_EQ(runout(remove).exit_code, 0);
}

}  // namespace
}  // namespace runout
