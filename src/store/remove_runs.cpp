#include "store/remove_runs.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <filesystem>

#include "core/input_error.h"
#include "store/database.h"
#include "store/database_in_use.h"

namespace runout {
namespace {

using SQLite::Database;
using SQLite::Statement;

constexpr const char* of_study =
    " JOIN scenario USING (scenario_id) WHERE scenario_hash IN"
    " (SELECT scenario_hash FROM study_scenario WHERE study_id = ?1) AND {} EXISTS"
    " (SELECT 1 FROM study_scenario AS other WHERE other.scenario_hash = scenario.scenario_hash"
    " AND other.study_id <> ?1)";

std::vector<DoomedRun> doomed(Statement& statement) {
    std::vector<DoomedRun> runs;
    while (statement.executeStep())
        runs.push_back({statement.getColumn(0).getInt64(), statement.getColumn(1).getString(),
                        statement.getColumn(2).getString(), statement.getColumn(3).getString()});
    return runs;
}

std::vector<DoomedRun> select_doomed(Database& database, const std::string& path,
                                     const RunSelection& selection) {
    const std::string select = "SELECT run_id, run.name, status, ended_utc FROM run";
    if (selection.study_id) {
        Statement statement(database,
                            select + fmt::format(fmt::runtime(of_study), "NOT") + " ORDER BY run_id");
        statement.bind(1, static_cast<int64_t>(*selection.study_id));
        return doomed(statement);
    }
    if (!selection.ended_before_utc.empty()) {
        Statement statement(database, select + " WHERE ended_utc < ? ORDER BY run_id");
        statement.bind(1, selection.ended_before_utc);
        return doomed(statement);
    }
    std::vector<DoomedRun> runs;
    Statement statement(database, select + " WHERE run_id = ?");
    for (const long run_id : selection.run_ids) {
        statement.reset();
        statement.bind(1, static_cast<int64_t>(run_id));
        const std::vector<DoomedRun> one = doomed(statement);
        if (one.empty())
            throw InputError({.file = path, .line = 0, .key = "--run", .value = std::to_string(run_id)},
                             "is not in this database", "`runout table --list` lists the stored runs");
        runs.push_back(one.front());
    }
    return runs;
}

/// temp.doomed (run_id).
void list_doomed(Database& database, const std::vector<DoomedRun>& runs) {
    database.exec("CREATE TEMP TABLE doomed (run_id INTEGER PRIMARY KEY)");
    Statement insert(database, "INSERT OR IGNORE INTO temp.doomed VALUES (?)");
    for (const DoomedRun& run : runs) {
        insert.bind(1, static_cast<int64_t>(run.run_id));
        insert.exec();
        insert.reset();
    }
}

/// Alone with the file: a program that stores runs has it open for writing through a log.
void take_alone(Database& database, const std::string& path) {
    database.setBusyTimeout(0);
    bool alone = false;
    try {
        alone = database.execAndGet("PRAGMA journal_mode = delete").getString() == "delete";
    } catch (const SQLite::Exception&) {
        alone = false;
    }
    if (!alone)
        throw DatabaseInUse({.file = path, .line = 0, .key = {}, .value = {}}, "is in use by another program",
                            "delete from it when that has ended");
}

void remove_planned(Database& database, const Removal& removal) {
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::EXCLUSIVE);
    list_doomed(database, removal.runs);
    database.exec(
        "DELETE FROM ladder WHERE ladder_id IN (SELECT ladder_id FROM ladder_run JOIN temp.doomed USING "
        "(run_id));"
        "DELETE FROM run WHERE run_id IN (SELECT run_id FROM temp.doomed);");
    if (removal.study_id) {
        Statement study(database, "DELETE FROM study WHERE study_id = ?");
        study.bind(1, static_cast<int64_t>(*removal.study_id));
        study.exec();
    }
    database.exec(
        "DELETE FROM scenario WHERE scenario_id NOT IN (SELECT scenario_id FROM run);"
        "DELETE FROM source WHERE source_id NOT IN (SELECT source_id FROM scenario);"
        "DELETE FROM section WHERE section_id NOT IN (SELECT section_id FROM source);"
        "DELETE FROM map_line WHERE line_id NOT IN (SELECT line_id FROM run WHERE line_id IS NOT NULL)"
        " AND line_id NOT IN (SELECT line_id FROM refused_section);"
        "DROP TABLE temp.doomed");
    transaction.commit();
}

bool give_space_back(Database& database) {
    try {
        database.exec("VACUUM");
        return true;
    } catch (const SQLite::Exception&) {
        return false;  // what was to go has gone; the next removal tries again
    }
}

}  // namespace

Removal plan_removal(const std::string& path, const RunSelection& selection) {
    const auto database = open_for_reading(path);
    try {
        Removal removal;
        removal.runs = select_doomed(*database, path, selection);
        removal.study_id = selection.study_id;
        if (selection.study_id) {
            Statement name(*database, "SELECT name FROM study WHERE study_id = ?");
            name.bind(1, static_cast<int64_t>(*selection.study_id));
            if (name.executeStep()) removal.study = name.getColumn(0).getString();
            Statement shared(*database, "SELECT count(*) FROM run" + fmt::format(fmt::runtime(of_study), ""));
            shared.bind(1, static_cast<int64_t>(*selection.study_id));
            if (shared.executeStep()) removal.shared_runs = shared.getColumn(0).getInt64();
        }
        list_doomed(*database, removal.runs);
        Statement ladders(
            *database,
            "SELECT DISTINCT ladder_id, ladder.name FROM ladder JOIN ladder_run USING (ladder_id)"
            " JOIN temp.doomed USING (run_id) ORDER BY ladder_id");
        while (ladders.executeStep()) removal.ladders.push_back(ladders.getColumn(1).getString());
        return removal;
    } catch (const SQLite::Exception& error) {
        throw_storage_error(path, error);
    }
}

Removed remove_runs(const std::string& path, const Removal& removal) {
    namespace fs = std::filesystem;
    const auto database = open_for_writing(path);
    try {
        take_alone(*database, path);
        const auto before = static_cast<long>(fs::file_size(path));
        remove_planned(*database, removal);
        const bool given_back = give_space_back(*database);
        return {before - static_cast<long>(fs::file_size(path)), given_back};
    } catch (const SQLite::Exception& error) {
        throw_storage_error(path, error);
    }
}

}  // namespace runout
