#include "store/database.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <filesystem>

#include "core/input_error.h"
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
    if (fs::is_directory(path, ignored)) throw refusal(path, "is a directory", what_is_valid);
    if (!fs::is_directory(fs::absolute(path).parent_path(), ignored))
        throw refusal(path, "is in a directory that does not exist", "create the directory first");
}

/// The connection. An absolute path keeps ":memory:" and "file:" from being anything but names.
///
/// The journal stays SQLite's default, a rollback journal: unlike with a write-ahead log, the one file is
/// complete whenever no one is writing, so that it may be copied, mailed, and opened read-only in QGIS.
std::unique_ptr<SQLite::Database> connect(const std::string& path, int flags) {
    auto database = std::make_unique<SQLite::Database>(fs::absolute(path).string(), flags, busy_timeout_ms);
    database->exec("PRAGMA foreign_keys = ON");
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

void make_ready(SQLite::Database& database, const std::string& path) {
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    if (is_new(database)) {
        database.exec(schema_sql);
    } else {
        check_identity(database, path);
        migrate(database, migrations());
    }
    transaction.commit();
}

/// Another program may have begun to fill the file, which is then not ours to remove.
void remove_if_empty(const std::string& path) {
    std::error_code ignored;
    if (fs::is_regular_file(path, ignored) && fs::file_size(path, ignored) == 0) fs::remove(path, ignored);
}

std::string problem_of(const SQLite::Exception& error) {
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
            return fmt::format("has been locked by another program for {} s", busy_timeout_ms / 1000);
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
    throw refusal(path, problem, remedy_of(error));
}

std::unique_ptr<SQLite::Database> open_for_reading(const std::string& path) {
    refuse_impossible_path(path);
    std::error_code ignored;
    if (!fs::exists(path, ignored)) throw refusal(path, "no such file", "give a database written by Runout");
    try {
        // Writable if the file lets us, because a writer that was killed leaves a journal that the next one
        // to come rolls back; without that the file could not be read. Nothing else is written.
        auto database = connect(path, SQLite::OPEN_READWRITE);
        database->exec("PRAGMA query_only = ON");
        if (is_new(*database)) throw refusal(path, "is empty", "give a database written by Runout");
        check_identity(*database, path);
        if (pragma(*database, "user_version") < schema_version)
            throw refusal(path, "was written by an older Runout",
                          "store a run in it once to bring it up to date");
        return database;
    } catch (const SQLite::Exception& error) {
        throw_storage_error(path, error);
    }
}

std::unique_ptr<SQLite::Database> open_for_writing(const std::string& path) {
    refuse_impossible_path(path);
    std::error_code ignored;
    const bool existed = fs::exists(path, ignored);
    try {
        auto database = connect(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        make_ready(*database, path);
        prove_writable(*database);
        return database;
    } catch (const SQLite::Exception& error) {
        if (!existed) remove_if_empty(path);
        throw_storage_error(path, error);
    }
}

}  // namespace runout
