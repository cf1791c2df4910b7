#pragma once

#include "scene/scene.h"
#include "store/store.h"

namespace SQLite {
class Database;
}

namespace runout {

/// Adds what a scenario says of its effects and gauges. Call it within the scenario's transaction.
void insert_effect_settings(SQLite::Database& database, long scenario_id, const Scene& scene);

/// Adds effects, advice, gauges and barrier of a run. Call it within the run's transaction.
void insert_effects(SQLite::Database& database, long run_id, const StoredRun& run);

/// Reads the same back.
void select_effects(SQLite::Database& database, StoredRun& run);

}  // namespace runout
