#pragma once

#include "scene/scene.h"
#include "store/store.h"

namespace SQLite {
class Database;
}

namespace runout {

/// Adds what a scenario says of its effects and places. Call it within the scenario's transaction.
void insert_effect_settings(SQLite::Database& database, long scenario_id, const Scene& scene);

/// Adds effects, advice, places and barrier of a run. Call it within the run's transaction.
void insert_effects(SQLite::Database& database, long run_id, const StoredRun& run);

/// The places of many runs, by rising run_id, without their rows over time.
void select_places(SQLite::Database& database, std::vector<StoredRun>& runs);

/// Reads the same back.
void select_effects(SQLite::Database& database, StoredRun& run);

}  // namespace runout
