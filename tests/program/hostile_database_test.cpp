// Databases that someone prepared: nothing in them runs, leads to another file, or passes for a result.

#include <SQLiteCpp/SQLiteCpp.h>
#include <sys/wait.h>

#include "program_fixture.h"

namespace runout {
namespace {

using SQLite::Database;

class HostileDatabaseTest : public ProgramTest {
  protected:
    HostileDatabaseTest() {
        EXPECT_EQ(runout({"run", "case.toml", "--db", "v.db", "--no-pilots", "--frames", "5", "--quiet",
                          "--set", "run.snapshot_times_s=[0.01]"})
                      .exit_code,
                  0);
    }
    void change(const std::string& name, const std::string& sql) const {
        Database database(work(name).string(), SQLite::OPEN_READWRITE);
        database.exec("PRAGMA foreign_keys = OFF; " + sql);
    }
    [[nodiscard]] long count(const std::string& name, const std::string& what) const {
        return Database(work(name).string(), SQLite::OPEN_READONLY)
            .execAndGet("SELECT count(*) FROM " + what)
            .getInt64();
    }
    /// A copy of v.db, changed.
    void copy_with(const std::string& name, const std::string& sql) const {
        fs::copy_file(work("v.db"), work(name), fs::copy_options::overwrite_existing);
        change(name, sql);
    }
};

TEST_F(HostileDatabaseTest, NamesOfTablesAreNoStatements) {
    const std::string evil =
        "CREATE TABLE \"x'); DELETE FROM run; --\" (run_id INTEGER, y TEXT);"
        "INSERT INTO \"x'); DELETE FROM run; --\" VALUES (1, 'of-someone-else');"
        "CREATE TABLE \"run; DROP TABLE run\" (run_id INTEGER);"
        "ALTER TABLE series ADD COLUMN \"a, (SELECT 1) AS b\" TEXT;"
        "ALTER TABLE scenario ADD COLUMN \"x', 1), (SELECT\" TEXT;";
    copy_with("target.db", evil);
    EXPECT_EQ(runout({"run", "case.toml", "--db", "part.db", "--no-pilots", "--quiet", "--set",
                      "material.friction_angle_deg=34"})
                  .exit_code,
              0);
    change("part.db", evil);
    const Outcome merged = runout({"merge", "target.db", "part.db"});
    EXPECT_EQ(merged.exit_code, 0) << merged.err;
    EXPECT_TRUE(contains(merged.err, "part.db holds a table run; DROP TABLE run that is not Runout's"))
        << merged.err;
    EXPECT_EQ(count("target.db", "run"), 2);
    EXPECT_EQ(count("target.db", "\"x'); DELETE FROM run; --\""), 1)
        << "a table of someone else is left alone";
    EXPECT_EQ(count("target.db", "series WHERE run_id = 2") > 0, true);
    for (const Arguments& arguments : {Arguments{"table", "target.db"}, Arguments{"report", "target.db"},
                                       Arguments{"compare", "target.db"}})
        EXPECT_EQ(runout(arguments).exit_code, 0);
    EXPECT_FALSE(contains(text_of(work("report.html")), "of-someone-else"));
    EXPECT_EQ(runout({"delete", "target.db", "--run", "1", "--yes"}).exit_code, 0);
    EXPECT_EQ(count("target.db", "run"), 1);
    EXPECT_EQ(count("target.db", "\"x'); DELETE FROM run; --\""), 1);
}

TEST_F(HostileDatabaseTest, TriggersAndViewsDoNotRun) {
    copy_with("t.db",
              "CREATE TRIGGER t AFTER INSERT ON run BEGIN DELETE FROM run; END;"
              "CREATE TRIGGER u BEFORE DELETE ON run BEGIN SELECT RAISE(ABORT, 'no'); END;"
              "CREATE VIEW v AS SELECT load_extension('/tmp/x');"
              "CREATE TABLE spread (a); CREATE TRIGGER w AFTER INSERT ON measure BEGIN"
              " INSERT INTO spread SELECT randomblob(1000000) FROM run; END;");
    EXPECT_EQ(runout({"run", "case.toml", "--db", "t.db", "--no-pilots", "--quiet"}).exit_code, 0);
    EXPECT_EQ(count("t.db", "run"), 2);
    EXPECT_EQ(count("t.db", "spread"), 0);
    EXPECT_EQ(runout({"delete", "t.db", "--run", "1", "--yes"}).exit_code, 0);
    EXPECT_EQ(count("t.db", "run"), 1);
}

TEST_F(HostileDatabaseTest, OtherThingsInPlaceOfTablesAreWrongInput) {
    const std::vector<std::pair<std::string, std::string>> changes = {
        {"ALTER TABLE series RENAME TO s; CREATE VIEW series AS SELECT * FROM s",
         "has a view in place of the table series"},
        {"DROP TABLE series", "has no table series"},
        {"ALTER TABLE run DROP COLUMN machine", "has a table run without the column machine"},
        {"DROP TABLE advice; CREATE TABLE advice (run_id INTEGER, row_index INTEGER, sentence TEXT)",
         "has a table advice whose columns may hold anything"},
        {"DROP TABLE advice; CREATE VIRTUAL TABLE advice USING rtree(run_id, row_index, sentence)",
         "has a virtual in place of the table advice"}};
    for (const auto& [sql, problem] : changes) {
        copy_with("x.db", sql);
        for (const Arguments& arguments :
             {Arguments{"table", "x.db"}, Arguments{"report", "x.db", "-o", "x.html"},
              Arguments{"run", "case.toml", "--db", "x.db", "--quiet"}, Arguments{"merge", "v.db", "x.db"},
              Arguments{"merge", "x.db", "v.db"}, Arguments{"delete", "x.db", "--run", "1", "--yes"}})
            expect_refused(arguments, {"x.db: " + problem});
    }
}

TEST_F(HostileDatabaseTest, AVersionThatIsNotTrueIsWrongInput) {
    for (const int version : {1, 2, 4, 6, 7}) {
        copy_with("x.db", fmt::format("PRAGMA user_version = {}", version));
        expect_refused({"table", "x.db"}, {"x.db: was written by an older Runout"});
        expect_refused({"run", "case.toml", "--db", "x.db", "--quiet"},
                       {"x.db: is not what its version says"});
    }
}

TEST_F(HostileDatabaseTest, BlobsAndIndicesAreCheckedBeforeUse) {
    const std::vector<std::pair<std::string, Arguments>> changes = {
        {"UPDATE snapshot SET vx_m_s = x'00000000'", {"export", "x.db", "--vtk", "out"}},
        {"UPDATE snapshot SET y_m = x''", {"export", "x.db", "--vtk", "out"}},
        {"UPDATE snapshot SET pressure_pa = zeroblob(6); UPDATE snapshot SET x_m = zeroblob(4)",
         {"export", "x.db", "--vtk", "out"}},
        {"DELETE FROM snapshot; UPDATE frame SET y = x'00'", {"export", "x.db", "--vtk", "out"}},
        {"UPDATE frame SET speed = x'00' WHERE row_index = 1", {"report", "x.db"}},
        {"UPDATE frame SET x = x'0000', y = x'0000', speed = x'00', pressure = x'00' WHERE row_index = 1",
         {"report", "x.db"}},
        {"UPDATE section SET crest_index = 1000000", {"report", "x.db"}},
        {"UPDATE section SET toe_index = -1", {"compare", "x.db"}},
        {"DELETE FROM section_point", {"report", "x.db"}},
        {"DELETE FROM source_point", {"report", "x.db"}},
        {"UPDATE run SET status = 'excellent'", {"table", "x.db"}}};
    for (const auto& [sql, arguments] : changes) {
        SCOPED_TRACE(sql);
        copy_with("x.db", sql);
        expect_refused(arguments, {"x.db: "});
    }
}

TEST_F(HostileDatabaseTest, InputsOfAStudyThatAreNoJsonAreWrongInput) {
    for (const char* inputs : {"{", "[1]", "", "null"}) {
        copy_with("x.db",
                  fmt::format("INSERT INTO study VALUES (1, 's', ''); INSERT INTO study_scenario VALUES"
                              " (1, 0, (SELECT scenario_hash FROM scenario), '{}', '')",
                              inputs));
        for (const char* format : {"text", "csv", "json", "markdown"})
            expect_refused({"table", "x.db", "--format", format}, {"x.db: ", "no JSON object"});
    }
}

/// The database's own idea of JSON is wider than that of the reports.
TEST_F(HostileDatabaseTest, InputsOfAStudyMayBeJsonOfAnotherReader) {
    for (const auto& [inputs, exit_code] :
         {std::pair{R"('{"a" : 1e400}')", 2}, std::pair{R"(CAST(x'7b226122203a2022c3227d' AS TEXT))", 0},
          std::pair{R"(CAST(x'7b2261c322203a20317d' AS TEXT))", 0}}) {
        copy_with("x.db",
                  fmt::format("INSERT INTO study VALUES (1, 's', ''); INSERT INTO study_scenario VALUES"
                              " (1, 0, (SELECT scenario_hash FROM scenario), {}, '')",
                              inputs));
        for (const char* format : {"text", "csv", "json", "markdown"})
            EXPECT_EQ(runout({"table", "x.db", "--format", format}).exit_code, exit_code) << inputs << format;
    }
}

TEST_F(HostileDatabaseTest, TextThatIsNoTextIsShownAndStopsNothing) {
    copy_with("x.db",
              "UPDATE run SET name = CAST(x'ff1b5b324a' AS TEXT), status_detail = CAST(x'c3' AS TEXT)");
    for (const Arguments& arguments :
         {Arguments{"table", "x.db"}, Arguments{"table", "x.db", "--format", "json"},
          Arguments{"table", "x.db", "--format", "csv"}, Arguments{"report", "x.db", "-o", "x.html"},
          Arguments{"compare", "x.db"}, Arguments{"export", "x.db", "--csv", "tables"}}) {
        const Outcome outcome = runout(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_FALSE(contains(outcome.out, "\x1b")) << outcome.out;
    }
}

/// What is stored at `offset` as SQLite stores it: most significant byte first.
std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((value >> shift) & 0xFFU);
    return bytes;
}

/// The end of a rollback journal that names a super-journal, which SQLite removes after the rollback.
std::string super_journal_record(const std::string& name) {
    std::uint32_t sum = 0;
    for (const char c : name) sum += static_cast<std::uint32_t>(static_cast<signed char>(c));
    return big_endian(262145) + name + big_endian(static_cast<std::uint32_t>(name.size())) + big_endian(sum) +
           "\xd9\xd5\x05\xf9\x20\xa1\x63\xd7";
}

/// A database left in the middle of a write, with its journal.
void leave_hot_journal(const std::string& path) {
    const pid_t child = fork();
    if (child == 0) {
        Database database(path, SQLite::OPEN_READWRITE);
        database.exec(
            "PRAGMA cache_size = 1; BEGIN IMMEDIATE; UPDATE run SET name = 'half';"
            "CREATE TABLE filler AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n"
            " LIMIT 20000) SELECT i, hex(randomblob(50)) AS x FROM n; UPDATE filler SET x = x || 'a'");
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(fs::exists(path + "-journal")) << "nothing was left to recover from";
}

TEST_F(HostileDatabaseTest, AJournalDeletesNoOtherFile) {
    write("precious.txt", "keep me\n");
    leave_hot_journal(work("v.db").string());
    std::ofstream(work("v.db-journal"), std::ios::binary | std::ios::app)
        << super_journal_record(work("precious.txt").string());
    for (const char* name : {"plain.db", "v2.db"}) {
        fs::copy_file(work("v.db"), work(name));
        fs::copy_file(work("v.db-journal"), work(std::string(name) + "-journal"));
    }
    const auto before = files();
    for (const Arguments& arguments :
         {Arguments{"table", "v.db"}, Arguments{"report", "v.db"}, Arguments{"merge", "m.db", "v.db"},
          Arguments{"merge", "v.db", "v2.db"}, Arguments{"delete", "v.db", "--run", "1", "--yes"},
          Arguments{"run", "case.toml", "--db", "v.db", "--quiet"}})
        expect_refused(arguments, {"-journal", "names a further file"});
    EXPECT_EQ(files(), before);
    EXPECT_EQ(text_of(work("precious.txt")), "keep me\n");
    // The journal is a real one: SQLite alone removes the file that it names.
    (void)Database(work("plain.db").string(), SQLite::OPEN_READWRITE).execAndGet("SELECT count(*) FROM run");
    EXPECT_FALSE(fs::exists(work("precious.txt")));
}

TEST_F(HostileDatabaseTest, LookingRestoresNothingAndWritingDoes) {
    leave_hot_journal(work("v.db").string());
    const std::string journal = text_of(work("v.db-journal"));
    expect_refused({"table", "v.db"}, {"v.db: was left in the middle of a write", "restores it"});
    EXPECT_EQ(text_of(work("v.db-journal")), journal);
    EXPECT_EQ(runout({"run", "case.toml", "--db", "v.db", "--no-pilots", "--quiet"}).exit_code, 0);
    const std::string table = runout({"table", "v.db"}).out;
    EXPECT_FALSE(contains(table, "half")) << table;
    EXPECT_EQ(count("v.db", "run"), 2);
}

TEST_F(HostileDatabaseTest, FilesBesideADatabaseAreOrdinary) {
    write("precious.txt", "keep me\n");
    for (const char* ending : {"-journal", "-wal", "-shm"}) {
        fs::create_symlink("precious.txt", work(std::string("v.db") + ending));
        expect_refused({"table", "v.db"}, {ending, "is no ordinary file"});
        expect_refused({"run", "case.toml", "--db", "v.db", "--quiet"}, {ending, "is no ordinary file"});
        fs::remove(work(std::string("v.db") + ending));
    }
    EXPECT_EQ(text_of(work("precious.txt")), "keep me\n");
}

TEST_F(HostileDatabaseTest, NamesWithQuestionMarksAndPercentSignsAreNames) {
    for (const std::string name :
         {"a?mode=rwc.db", "b%41.db", "c#d.db", "e'; DETACH shard; --.db", "f g.db"}) {
        fs::copy_file(work("v.db"), work(name));
        EXPECT_EQ(runout({"table", name}).exit_code, 0) << name;
        EXPECT_EQ(runout({"merge", "m.db", name}).exit_code, 0) << name;
    }
    EXPECT_FALSE(fs::exists(work("a")));
    EXPECT_FALSE(fs::exists(work("bA.db")));
}

TEST_F(HostileDatabaseTest, AFileOfManyDatabasesIsNotAttached) {
    // The only ATTACH is of what the user named; one in the schema of a view is never evaluated.
    write("other.txt", "keep me\n");
    copy_with("x.db", "CREATE VIEW w AS SELECT * FROM pragma_database_list");
    const Outcome merged = runout({"merge", "m.db", "x.db"});
    EXPECT_EQ(merged.exit_code, 0) << merged.err;
    EXPECT_TRUE(contains(merged.err, "holds a view w that is not Runout's")) << merged.err;
    EXPECT_EQ(count("m.db", "sqlite_schema WHERE name = 'w'"), 0);
}

}  // namespace
}  // namespace runout
