#pragma once

#include "scene/scene.h"

namespace SQLite {
class Database;
}

namespace runout {

/// scenario_id of the scene. Scenario, source and section that are already there are shared; what is missing
/// is added. Call it within a transaction.
long scenario_row(SQLite::Database& database, const Scene& scene);

}  // namespace runout
