#include "store/database.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <filesystem>

#include "core/input_error.h"
#include "store/database_file.h"
#include "store/database_in_use.h"
#include "store/known_tables.h"
#include "store/migrations.h"
#include "store/schema_sql.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

// Longer than any transaction of ours takes on a slow disk, short enough that a forgotten lock is noticed.
constexpr int busy_timeout_ms = 30'000;

const char* const what_is_valid = "give a database written by Runout, or the name of a new file";

InputError refusal(const std::string& path, const std::string& problem, const std::string& valid) {
    return InputError({.file = path, .line = 0, .key = {}, .value = {}}, problem, valid);
}

/// What SQLite would answer with "unable to open database file", or misread: "" is a temporary database to
/// it.
void refuse_impossible_path(const std::string& path) {
    std::error_code ignored;
    if (path.empty()) throw refusal("database", "has an empty name", what_is_valid);
    if (path.find('\0') != std::string::npos) throw refusal(path, "holds a zero byte", what_is_valid);
    if (fs::is_directory(path, ignored)) throw refusal(path, "is a directory", what_is_valid);
    if (fs::exists(path, ignored) && (!fs::is_regular_file(path, ignored) || is_output_stream(path)))
        throw refusal(path, "is no ordinary file", what_is_valid);
    if (!fs::is_directory(fs::absolute(path).parent_path(), ignored))
        throw refusal(path, "is in a directory that does not exist", "create the directory first");
}

/// A database may come from anyone: nothing that is written in it runs, and its tables are no way to its
/// pages.
void harden(SQLite::Database& database) {
    sqlite3* const handle = database.getHandle();
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0, nullptr);
    database.exec("PRAGMA cell_size_check = ON; PRAGMA foreign_keys = ON");
}

/// The connection; names within `name` mean what `flags` say. The journal stays SQLite's default, a rollback
/// journal, unless WriteAheadLog says otherwise: with it the one file is complete whenever no one is writing,
/// so that it may be copied, mailed, and opened read-only in QGIS.
std::unique_ptr<SQLite::Database> connect(const std::string& name, int flags) {
    auto database = std::make_unique<SQLite::Database>(name, flags, busy_timeout_ms);
    harden(*database);
    return database;
}

int pragma(SQLite::Database& database, const std::string& name) {
    return database.execAndGet("PRAGMA " + name).getInt();
}

bool is_new(SQLite::Database& database) {
    return pragma(database, "application_id") == 0 && pragma(database, "user_version") == 0 &&
           database.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 0;
}

void check_identity(SQLite::Database& database, const std::string& path) {
    if (pragma(database, "application_id") != application_id)
        throw refusal(path, "is a database of another program", what_is_valid);
    const int version = pragma(database, "user_version");
    if (version > schema_version)
        throw refusal(path, fmt::format("is of database version {}, written by a newer Runout", version),
                      fmt::format("this Runout knows versions up to {}", schema_version));
    if (version < 1)
        throw refusal(path, fmt::format("has the impossible database version {}", version), what_is_valid);
}

/// A lock alone does not prove that a journal can be written beside the file, so a page is changed and given
/// up.
void prove_writable(SQLite::Database& database) {
    const SQLite::Transaction given_up(database, SQLite::TransactionBehavior::IMMEDIATE);
    database.exec(fmt::format("PRAGMA user_version = {}", schema_version));
}

/// A file that has not the tables of its version refuses the steps that change them.
void bring_up_to_date(SQLite::Database& database) {
    try {
        migrate(database, migrations());
    } catch (const SQLite::Exception& error) {
        if (error.getErrorCode() != SQLITE_ERROR) throw;
        throw DamagedData(fmt::format("is not what its version says ({})", error.what()));
    }
}

void make_ready(SQLite::Database& database, const std::string& path) {
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    const bool is_ready = !is_new(database) && pragma(database, "user_version") == schema_version;
    if (is_new(database)) {
        database.exec(schema_sql);
    } else {
        check_identity(database, path);
        bring_up_to_date(database);
    }
    check_tables(database);
    // Even an empty commit waits for all who read, in the middle of whose transactions a run may well begin.
    if (!is_ready) transaction.commit();
}

/// Another program may have begun to fill the file, which is then not ours to remove.
void remove_if_empty(const std::string& path) {
    std::error_code ignored;
    if (fs::is_regular_file(path, ignored) && fs::file_size(path, ignored) == 0) fs::remove(path, ignored);
}

bool is_in_use(const SQLite::Exception& error) {
    return error.getErrorCode() == SQLITE_BUSY || error.getErrorCode() == SQLITE_LOCKED;
}

std::string problem_of(const SQLite::Exception& error) {
    if (error.getExtendedErrorCode() == SQLITE_READONLY_ROLLBACK)
        return "was left in the middle of a write by a program that was killed (-journal lies beside it)";
    if (error.getExtendedErrorCode() == SQLITE_READONLY_DBMOVED) return "was moved or deleted while in use";
    switch (error.getErrorCode()) {
        case SQLITE_NOTADB:
            return "is not a database";
        case SQLITE_CANTOPEN:
            return "cannot be opened or created";
        case SQLITE_PERM:
        case SQLITE_READONLY:
            return "may not be written";
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return "has been locked by another program for too long";
        case SQLITE_FULL:
            return "does not fit on the disk";
        case SQLITE_CORRUPT:
            return "is damaged";
        case SQLITE_IOERR:
            return "cannot be read or written (disk error)";
        default:
            return {};
    }
}

std::string remedy_of(const SQLite::Exception& error) {
    if (error.getExtendedErrorCode() == SQLITE_READONLY_ROLLBACK)
        return "the next command that writes into it (run, sweep, merge, delete) restores it";
    switch (error.getErrorCode()) {
        case SQLITE_NOTADB:
            return what_is_valid;
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return "close the program that holds it";
        case SQLITE_FULL:
            return "free some space";
        case SQLITE_CORRUPT:
            return "take a copy that is whole";
        default:
            return "give a file in a place that you may write";
    }
}

}  // namespace

void throw_storage_error(const std::string& path, const SQLite::Exception& error) {
    const std::string problem = problem_of(error);
    if (problem.empty()) throw error;
    if (is_in_use(error))
        throw DatabaseInUse({.file = path, .line = 0, .key = {}, .value = {}}, problem, remedy_of(error));
    throw refusal(path, problem, remedy_of(error));
}

namespace {

/// While a file is opened all statements are ours, so that it is the file that SQLite cannot take: the number
/// of a format to come, say.
[[noreturn]] void throw_opening_error(const std::string& path, const SQLite::Exception& error) {
    if (error.getErrorCode() == SQLITE_ERROR)
        throw refusal(path, fmt::format("cannot be read as a database ({})", error.what()), what_is_valid);
    throw_storage_error(path, error);
}

}  // namespace

std::unique_ptr<SQLite::Database> open_for_reading(const std::string& path) {
    refuse_impossible_path(path);
    std::error_code ignored;
    if (!fs::exists(path, ignored)) throw refusal(path, "no such file", "give a database written by Runout");
    check_journals(path);
    try {
        auto database = connect(read_only_uri(path), SQLite::OPEN_READONLY | SQLite::OPEN_URI);
        if (is_new(*database)) throw refusal(path, "is empty", "give a database written by Runout");
        check_identity(*database, path);
        if (pragma(*database, "user_version") < schema_version)
            throw refusal(path, "was written by an older Runout",
                          "store a run in it once to bring it up to date");
        check_tables(*database);
        return database;
    } catch (const DamagedData& damage) {
        throw refusal(path, damage.what(), what_is_valid);
    } catch (const SQLite::Exception& error) {
        throw_opening_error(path, error);
    }
}

std::vector<std::string> check_whole(const std::string& path) {
    const auto database = open_for_reading(path);
    try {
        const std::string answer = database->execAndGet("PRAGMA quick_check(1)").getString();
        if (answer != "ok") throw refusal(path, "is damaged", "take a copy that is whole");
        return foreign_objects(*database);
    } catch (const SQLite::Exception& error) {
        throw_storage_error(path, error);
    }
}

std::unique_ptr<SQLite::Database> open_for_writing(const std::string& path) {
    refuse_impossible_path(path);
    std::error_code ignored;
    const bool existed = fs::exists(path, ignored);
    check_journals(path);
    try {
        // An absolute path keeps ":memory:" and "file:" from being anything but names. Databases to merge
        // from are attached by read-only URIs.
        auto database = connect(fs::absolute(path).string(),
                                SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE | SQLite::OPEN_URI);
        make_ready(*database, path);
        prove_writable(*database);
        return database;
    } catch (const DamagedData& damage) {
        throw refusal(path, damage.what(), what_is_valid);
    } catch (const SQLite::Exception& error) {
        if (!existed) remove_if_empty(path);
        throw_opening_error(path, error);
    }
}

}  // namespace runout
