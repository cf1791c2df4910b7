#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <set>
#include <thread>

#include "store/database.h"
#include "store_fixture.h"

// The file on the disk: never half written, never another program's, and every refusal a sentence.

namespace runout {
namespace {

// ---- all or nothing

TEST_F(StoreTest, ARunThatCannotBeStoredLeavesNothing) {
    RunResult twice = example_result();
    twice.phases.push_back(twice.phases.front());  // the last insert of the transaction breaks a primary key
    Store store(path, Store::Mode::write);
    EXPECT_THROW(store.add(example_scene(), twice), std::exception);
    for (const char* table :
         {"section", "section_point", "source", "source_point", "scenario", "run", "measure", "series",
          "deposit_profile", "snapshot", "frame", "stage", "phase_time", "map_line"})
        EXPECT_EQ(count(table), 0) << table;
    store.add(example_scene(), example_result());
    EXPECT_EQ(count("run"), 1) << "the store goes on after a failure";
}

TEST_F(StoreTest, ItsOwnWritesAreHeldToTheForeignKeys) {
    Store store(path, Store::Mode::write);
    raw().exec("DELETE FROM run_status WHERE status = 'settled'");
    EXPECT_THROW(store.add(example_scene(), example_result()), std::exception);
    EXPECT_EQ(count("scenario"), 0);
}

TEST_F(StoreTest, RefusesARunThatHasNotEnded) {
    RunResult result = example_result();
    result.status = RunStatus::running;
    EXPECT_THROW(add(example_scene(), result), std::logic_error);
    EXPECT_EQ(count("run"), 0);
}

TEST_F(StoreTest, AWriterKilledMidwayLeavesTheRunsBefore) {
    add(example_scene(), example_result());
    const auto die_midway = [this] {
        SQLite::Database database = raw();
        database.exec("PRAGMA cache_size = 1; BEGIN IMMEDIATE; UPDATE run SET name = 'half written';");
        SQLite::Statement insert(database, "INSERT INTO section_point VALUES (1, ?, 0, 0)");
        for (int i = 100; i < 20'000; ++i) {  // more than the cache holds, so that the file itself is changed
            insert.bind(1, i);
            insert.exec();
            insert.reset();
        }
        _exit(0);
    };
    EXPECT_EXIT(die_midway(), testing::ExitedWithCode(0), "");
    ASSERT_TRUE(fs::exists(path + "-journal")) << "nothing was left to recover from";
    EXPECT_TRUE(contains(refusal_to_open(path, Store::Mode::read), "was left in the middle of a write"))
        << "looking changes nothing";
    const Store store(path, Store::Mode::write);
    ASSERT_EQ(store.runs().size(), 1U);
    EXPECT_EQ(store.runs()[0].name, "cut-60");
    EXPECT_EQ(raw().execAndGet("PRAGMA integrity_check").getString(), "ok");
}

/// Stores runs of `angles` in its own threads, opening the file anew for each run, and returns what was
/// refused.
std::vector<std::string> write_at_once(const std::string& path, const std::vector<double>& angles,
                                       int runs_each) {
    std::vector<std::string> refused(angles.size());
    std::vector<std::thread> writers;
    for (std::size_t w = 0; w < angles.size(); ++w)
        writers.emplace_back([&, w] {
            for (int i = 0; i < runs_each; ++i)
                refused[w] += input_error([&] {
                    Scene scene = example_scene();
                    scene.material.friction_angle = angles[w] + i * 1e-3;
                    Store(path, Store::Mode::write).add(scene, example_result());
                });
        });
    for (std::thread& writer : writers) writer.join();
    return refused;
}

TEST_F(StoreTest, TwoWritersBothSucceed) {
    constexpr int runs_each = 50;
    for (const std::string& refused : write_at_once(path, {0.5, 0.7}, runs_each)) EXPECT_EQ(refused, "");
    EXPECT_EQ(count("run"), 2 * runs_each);
    EXPECT_EQ(count("scenario"), 2 * runs_each);
    EXPECT_EQ(count("section"), 1);
    EXPECT_EQ(Store(path, Store::Mode::read).runs().size(), 2U * runs_each);
}

TEST_F(StoreTest, AWriterWaitsForTheOtherBeforeItBegins) {
    Store store(path, Store::Mode::write);
    SQLite::Database other = raw();
    other.exec("BEGIN IMMEDIATE; UPDATE run_status SET meaning = 'changed meanwhile'");
    std::thread release([&other] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        other.exec("COMMIT");
    });
    // Had it begun to read before, it could not go on to write, as what it has read is out of date.
    const std::string refused = input_error([&] { store.add(example_scene(), example_result()); });
    release.join();
    EXPECT_EQ(refused, "");
    EXPECT_EQ(count("run"), 1);
}

// ---- opening

TEST_F(StoreTest, OpeningForWritingMakesAnEmptyDatabase) {
    { const Store store(path, Store::Mode::write); }
    EXPECT_TRUE(Store(path, Store::Mode::read).runs().empty());
    EXPECT_EQ(files(), 1U);
}

TEST_F(StoreTest, ReopeningKeepsWhatIsThere) {
    const long first = add(example_scene(), example_result());
    const long second = add(example_scene(), example_result());
    EXPECT_LT(first, second);
    const auto runs = Store(path, Store::Mode::read).runs();
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[0].run_id, first);
    EXPECT_EQ(runs[1].run_id, second);
}

TEST_F(StoreTest, AnEmptyFileIsANewDatabaseForWritersOnly) {
    std::ofstream(path).close();
    EXPECT_TRUE(contains(refusal_to_open(path, Store::Mode::read), "is empty"));
    EXPECT_EQ(fs::file_size(path), 0U);
    add(example_scene(), example_result());
    EXPECT_EQ(count("run"), 1);
}

TEST_F(StoreTest, AReaderChangesNothing) {
    add(example_scene(), example_result());
    Store store(path, Store::Mode::read);
    EXPECT_THROW(store.add(example_scene(), example_result()), std::logic_error);
    EXPECT_EQ(count("run"), 1);
}

TEST_F(StoreTest, AskingForARunThatIsNotThereIsAnInputError) {
    add(example_scene(), example_result());
    const Store store(path, Store::Mode::read);
    EXPECT_TRUE(contains(input_error([&] { (void)store.run(7); }), path + ": run_id = 7: no such run"));
    EXPECT_TRUE(store.series(7).empty());
}

TEST_F(StoreTest, ReadingAMissingFileIsAnInputErrorAndCreatesNothing) {
    EXPECT_TRUE(contains(refusal_to_open(path, Store::Mode::read), path + ": no such file"));
    EXPECT_EQ(files(), 0U);
}

TEST_F(StoreTest, NamesThatSqliteUnderstandsOtherwiseAreJustNames) {
    EXPECT_FALSE(refusal_to_open("", Store::Mode::write).empty());
    EXPECT_FALSE(refusal_to_open("", Store::Mode::read).empty());
    EXPECT_TRUE(contains(refusal_to_open(":memory:", Store::Mode::read), "no such file"));
    const fs::path before = fs::current_path();
    fs::current_path(directory);
    for (const char* name : {":memory:", "file:results.db?mode=memory"}) {
        path = name;
        add(example_scene(), example_result());
        EXPECT_TRUE(fs::exists(directory / name)) << name;
    }
    fs::current_path(before);
}

/// Files that are no database of ours stay as they were, byte for byte.
class ForeignFile : public StoreTest {
  protected:
    void expect_refused(const std::string& sentence) {
        const std::string before = bytes();
        for (const Store::Mode mode : {Store::Mode::read, Store::Mode::write})
            EXPECT_TRUE(contains(refusal_to_open(path, mode), path + ": " + sentence));
        EXPECT_EQ(bytes(), before);
        EXPECT_EQ(files(), 1U);
    }
    [[nodiscard]] std::string bytes() const {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }
};

TEST_F(ForeignFile, ShortText) {
    std::ofstream(path) << "x\n";
    expect_refused("is not a database");
}

TEST_F(ForeignFile, LongText) {
    std::ofstream file(path);
    for (int i = 0; i < 10'000; ++i) file << "chainage_m,elevation_m\n";
    file.close();
    expect_refused("is not a database");
}

TEST_F(ForeignFile, DatabaseOfNoStatedProgram) {
    SQLite::Database(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
        .exec("CREATE TABLE run (run_id INTEGER)");
    expect_refused("is a database of another program");
}

TEST_F(ForeignFile, GeoPackage) {
    SQLite::Database(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
        .exec("PRAGMA application_id = 1196444487; CREATE TABLE gpkg_contents (table_name TEXT)");
    expect_refused("is a database of another program");
}

TEST_F(ForeignFile, NewerVersion) {
    add(example_scene(), example_result());
    raw().exec("PRAGMA user_version = 99");
    expect_refused(
        "is of database version 99, written by a newer Runout; this Runout knows versions up to 10");
}

TEST_F(ForeignFile, ImpossibleVersion) {
    add(example_scene(), example_result());
    raw().exec("PRAGMA user_version = 0");
    expect_refused("has the impossible database version 0");
}

TEST_F(ForeignFile, SchemaFormatToCome) {
    add(example_scene(), example_result());
    constexpr std::streamoff schema_format = 47;  // last byte of that number in SQLite's header; 4 at most
    std::fstream(path, std::ios::in | std::ios::out | std::ios::binary).seekp(schema_format).put(9);
    expect_refused("cannot be read as a database (unsupported file format)");
}

TEST_F(StoreTest, DamageIsSaid) {
    add(example_scene(), example_result());
    fs::resize_file(path, fs::file_size(path) / 2);
    const std::string sentence = input_error([&] { (void)Store(path, Store::Mode::read).runs(); });
    EXPECT_TRUE(contains(sentence, path + ": is damaged"));
}

// ---- places that cannot be written

TEST_F(StoreTest, UnwritablePlacesAreFoundOnOpening) {
    std::ofstream((directory / "file").string()) << "a file, not a directory";
    const std::vector<std::pair<std::string, std::string>> places = {
        {(directory / "file" / "results.db").string(), "is in a directory that does not exist"},
        {(directory / "missing" / "results.db").string(), "is in a directory that does not exist"},
        {directory.string(), "is a directory"},
        {"/proc/results.db", "cannot be opened or created"},
    };
    for (const auto& [place, problem] : places)
        EXPECT_TRUE(contains(refusal_to_open(place, Store::Mode::write), place + ": " + problem));
    EXPECT_EQ(files(), 1U) << "nothing was left behind";
}

/// Runs `check` in a process that permissions apply to, whoever runs the tests.
void as_ordinary_user(const std::function<bool()>& check) {
    constexpr unsigned nobody = 65534;
    if (geteuid() == 0 && (setegid(nobody) != 0 || seteuid(nobody) != 0)) _exit(2);
    _exit(check() ? 0 : 1);
}

TEST_F(StoreTest, PermissionsAreFoundOnOpening) {
    add(example_scene(), example_result());
    const auto may_not_write = [this] {
        return contains(refusal_to_open(path, Store::Mode::write), "may not be written");
    };
    const auto may_not_create = [this] {
        return contains(refusal_to_open((directory / "new.db").string(), Store::Mode::write),
                        "cannot be opened or created");
    };
    const auto may_read = [this] { return Store(path, Store::Mode::read).runs().size() == 1; };

    const auto all = fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read;
    const auto enter = fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec;
    fs::permissions(path, all);
    fs::permissions(directory, all | enter);
    EXPECT_EXIT(as_ordinary_user(may_not_write), testing::ExitedWithCode(0), "")
        << "a file that is read-only";
    EXPECT_EXIT(as_ordinary_user(may_not_create), testing::ExitedWithCode(0), "")
        << "a directory that is read-only";
    EXPECT_EXIT(as_ordinary_user(may_read), testing::ExitedWithCode(0), "");

    fs::permissions(path, all | fs::perms::owner_write | fs::perms::others_write);
    EXPECT_EXIT(as_ordinary_user([this] { return !refusal_to_open(path, Store::Mode::write).empty(); }),
                testing::ExitedWithCode(0), "")
        << "a file whose journal cannot be written beside it";
    fs::permissions(directory, fs::perms::owner_all);
    EXPECT_EQ(files(), 1U);
}

TEST_F(StoreTest, AFileThatIsTakenAwayIsSaidAndNotWrittenToNowhere) {
    Store store(path, Store::Mode::write);
    fs::remove(path);
    const std::string sentence = input_error([&] { store.add(example_scene(), example_result()); });
    EXPECT_TRUE(contains(sentence, "was moved or deleted while in use"));
}

TEST_F(StoreTest, AWriteThatFailsMidwayIsSaidAndLosesNothing) {
    add(example_scene(), example_result());
    const auto size = fs::file_size(path);
    const auto write_over_limit = [this] {
        // Without a handler the signal would end the process; ignored, the limit is an error of write().
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{fs::file_size(path) + 8192, fs::file_size(path) + 8192};
        setrlimit(RLIMIT_FSIZE, &limit);
        RunResult large = example_result();
        large.series.resize(20'000);
        const std::string sentence = input_error([&] { add(example_scene(), large); });
        _exit(contains(sentence, path + ": cannot be read or written") ? 0 : 1);
    };
    EXPECT_EXIT(write_over_limit(), testing::ExitedWithCode(0), "");
    EXPECT_EQ(Store(path, Store::Mode::read).runs().size(), 1U);
    EXPECT_EQ(fs::file_size(path), size);
}

TEST_F(StoreTest, ADatabaseThatCannotBeMadeLeavesNoEmptyFile) {
    const auto create = [this] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit nothing{0, 0};
        setrlimit(RLIMIT_FSIZE, &nothing);
        _exit(refusal_to_open(path, Store::Mode::write).empty() ? 1 : 0);
    };
    EXPECT_EXIT(create(), testing::ExitedWithCode(0), "");
    EXPECT_EQ(files(), 0U);
}

TEST(StorageErrors, AreSentencesWhereTheDiskIsToBlameOnly) {
    const auto sentence = [](int code) {
        return input_error(
            [=] { throw_storage_error("results.db", SQLite::Exception("sqlite's words", code)); });
    };
    EXPECT_EQ(sentence(SQLITE_FULL), "results.db: does not fit on the disk; free some space");
    EXPECT_EQ(sentence(SQLITE_BUSY),
              "results.db: has been locked by another program for too long; close the program that holds it");
    EXPECT_THROW(sentence(SQLITE_CONSTRAINT), SQLite::Exception);
}

}  // namespace
}  // namespace runout
