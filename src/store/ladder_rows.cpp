#include "store/ladder_rows.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/VariadicBind.h>

#include <array>
#include <limits>

#include "store/real_value.h"

namespace runout {
namespace {

using SQLite::Database;
using SQLite::Statement;

constexpr std::array verdict_numbers = {
    &LadderVerdict::finest_value,   &LadderVerdict::uncertainty,      &LadderVerdict::lattice_scatter,
    &LadderVerdict::observed_order, &LadderVerdict::richardson_value, &LadderVerdict::grid_convergence_index,
    &LadderVerdict::fitted_order,   &LadderVerdict::fitted_value,
};
static_assert(sizeof(LadderVerdict) == 2 * sizeof(std::string) + verdict_numbers.size() * sizeof(double));

constexpr const char* verdict_columns =
    "quantity, verdict, finest_value, uncertainty, lattice_scatter, observed_order, richardson_value,"
    " grid_convergence_index, fitted_order, fitted_value";

void insert_ladder_runs(Database& database, long ladder_id, const std::vector<LadderRun>& runs) {
    Statement statement(database,
                        "INSERT INTO ladder_run (ladder_id, row_index, series, setting, resolution, run_id)"
                        " VALUES (?, ?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < runs.size(); ++i) {
        SQLite::bind(statement, ladder_id, static_cast<long>(i), runs[i].series, runs[i].setting,
                     runs[i].resolution, runs[i].run_id);
        statement.exec();
        statement.reset();
    }
}

void insert_verdicts(Database& database, long ladder_id, const std::vector<LadderVerdict>& verdicts) {
    Statement statement(database, std::string("INSERT INTO ladder_verdict (") + verdict_columns +
                                      ", ladder_id) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    for (const LadderVerdict& verdict : verdicts) {
        int place = 0;
        statement.bind(++place, verdict.quantity);
        statement.bind(++place, verdict.verdict);
        for (const auto number : verdict_numbers) statement.bind(++place, verdict.*number);
        statement.bind(++place, ladder_id);
        statement.exec();
        statement.reset();
    }
}

std::vector<LadderRun> select_ladder_runs(Database& database, long ladder_id) {
    Statement statement(database,
                        "SELECT series, setting, resolution, run_id FROM ladder_run WHERE ladder_id = ?"
                        " ORDER BY row_index");
    statement.bind(1, ladder_id);
    std::vector<LadderRun> runs;
    while (statement.executeStep())
        runs.push_back({statement.getColumn(0).getString(), statement.getColumn(1).getString(),
                        real_value(statement.getColumn(2)), statement.getColumn(3).getInt64()});
    return runs;
}

std::vector<LadderVerdict> select_verdicts(Database& database, long ladder_id) {
    Statement statement(database, std::string("SELECT ") + verdict_columns +
                                      " FROM ladder_verdict WHERE ladder_id = ? ORDER BY rowid");
    statement.bind(1, ladder_id);
    std::vector<LadderVerdict> verdicts;
    while (statement.executeStep()) {
        LadderVerdict& verdict = verdicts.emplace_back();
        int place = 0;
        verdict.quantity = statement.getColumn(place++).getString();
        verdict.verdict = statement.getColumn(place++).getString();
        for (const auto number : verdict_numbers) {
            const SQLite::Column column = statement.getColumn(place++);
            verdict.*number = real_value(column);
        }
    }
    return verdicts;
}

std::vector<StoredLadder> read_ladders(Database& database, Statement& statement) {
    std::vector<StoredLadder> ladders;
    while (statement.executeStep()) {
        StoredLadder& ladder = ladders.emplace_back();
        ladder.ladder_id = statement.getColumn(0).getInt64();
        ladder.question_hash = statement.getColumn(1).getString();
        ladder.name = statement.getColumn(2).getString();
        ladder.ended_utc = statement.getColumn(3).getString();
        ladder.target = statement.getColumn(4).getString();
        ladder.machine = statement.getColumn(5).getString();
    }
    for (StoredLadder& ladder : ladders) {
        ladder.runs = select_ladder_runs(database, ladder.ladder_id);
        ladder.verdicts = select_verdicts(database, ladder.ladder_id);
    }
    return ladders;
}

constexpr const char* ladder_columns = "ladder_id, question_hash, name, ended_utc, target, machine";

}  // namespace

long insert_ladder(Database& database, const StoredLadder& ladder) {
    Statement statement(
        database,
        "INSERT INTO ladder (question_hash, name, ended_utc, target, machine)"
        " VALUES (?, ?, coalesce(nullif(?, ''), strftime('%Y-%m-%dT%H:%M:%SZ', 'now')), ?, ?)");
    SQLite::bind(statement, ladder.question_hash, ladder.name, ladder.ended_utc, ladder.target,
                 ladder.machine);
    statement.exec();
    const long ladder_id = database.getLastInsertRowid();
    insert_ladder_runs(database, ladder_id, ladder.runs);
    insert_verdicts(database, ladder_id, ladder.verdicts);
    return ladder_id;
}

std::vector<StoredLadder> select_ladders(Database& database) {
    Statement statement(database,
                        std::string("SELECT ") + ladder_columns + " FROM ladder ORDER BY ladder_id");
    return read_ladders(database, statement);
}

std::optional<StoredLadder> select_ladder_of(Database& database, const std::string& question_hash) {
    Statement statement(database, std::string("SELECT ") + ladder_columns +
                                      " FROM ladder WHERE question_hash = ? ORDER BY ladder_id DESC LIMIT 1");
    statement.bind(1, question_hash);
    std::vector<StoredLadder> found = read_ladders(database, statement);
    if (found.empty()) return std::nullopt;
    return found.front();
}

}  // namespace runout
