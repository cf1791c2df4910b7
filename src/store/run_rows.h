#pragma once

#include <optional>
#include <string>
#include <vector>

#include "store/store.h"

namespace SQLite {
class Database;
}

namespace runout {

/// Adds run and measure of one run and returns its run_id. Call it within a transaction.
long insert_run(SQLite::Database& database, long scenario_id, const StoredRun& run);

/// Adds the rows that belong to a run. Call them within its transaction.
void insert_series(SQLite::Database& database, long run_id, const std::vector<SeriesRow>& rows);
void insert_deposit(SQLite::Database& database, long run_id, const std::vector<DepositRow>& rows);
void insert_snapshots(SQLite::Database& database, long run_id, const std::vector<Snapshot>& snapshots);
void insert_stages(SQLite::Database& database, long run_id, const std::vector<StageRow>& rows);
void insert_pilots(SQLite::Database& database, long run_id, const std::vector<PilotRow>& rows);
void insert_phases(SQLite::Database& database, long run_id, const std::vector<PhaseTime>& rows);
void insert_invariants(SQLite::Database& database, long run_id, const std::vector<InvariantRow>& rows);

/// All runs in the order of their ids; the one with this id, or none.
std::vector<StoredRun> select_runs(SQLite::Database& database);
std::vector<StoredRun> select_runs(SQLite::Database& database, long run_id);

/// All runs on this section, in the order of their ids.
std::vector<StoredRun> select_runs_on_section(SQLite::Database& database, long section_id);

/// The latest run of a scenario that was not interrupted.
std::optional<long> select_run_of(SQLite::Database& database, const std::string& scenario_hash);

std::vector<Snapshot> select_snapshots(SQLite::Database& database, long run_id);
std::vector<PilotRow> select_pilots(SQLite::Database& database, long run_id);
std::vector<StageRow> select_stages(SQLite::Database& database, long run_id);
std::vector<SeriesRow> select_series(SQLite::Database& database, long run_id);
std::vector<DepositRow> select_deposit(SQLite::Database& database, long run_id);
std::vector<PhaseTime> select_phases(SQLite::Database& database, long run_id);
std::vector<InvariantRow> select_invariants(SQLite::Database& database, long run_id);

}  // namespace runout
