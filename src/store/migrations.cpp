#include "store/migrations.h"

#include <SQLiteCpp/Database.h>
#include <fmt/format.h>

#include <array>

namespace runout {

// db/schema.sql says the same for new files; a test holds the two against each other.
std::span<const Migration> migrations() {
    static constexpr std::array steps{
        Migration{1, R"(
ALTER TABLE scenario ADD COLUMN lattice_seed INTEGER NOT NULL DEFAULT 0;
ALTER TABLE scenario ADD COLUMN snapshot_times_s TEXT NOT NULL DEFAULT '[]';
ALTER TABLE scenario ADD COLUMN base_friction_angle_deg REAL;
ALTER TABLE scenario ADD COLUMN release_layers INTEGER;
ALTER TABLE scenario ADD COLUMN release_layer_width_m REAL;
ALTER TABLE scenario ADD COLUMN release_layer_height_m REAL;
CREATE TABLE snapshot (
    run_id INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    row_index INTEGER NOT NULL,
    time_s REAL NOT NULL,
    x_m BLOB NOT NULL,
    y_m BLOB NOT NULL,
    vx_m_s BLOB NOT NULL,
    vy_m_s BLOB NOT NULL,
    pressure_pa BLOB NOT NULL,
    PRIMARY KEY (run_id, row_index)
) STRICT;
CREATE TABLE stage (
    run_id INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    row_index INTEGER NOT NULL,
    time_s REAL,
    area_m2 REAL,
    surface_angle_deg REAL,
    deposit_height_m REAL,
    run_out_m REAL,
    PRIMARY KEY (run_id, row_index)
) STRICT, WITHOUT ROWID;
)"},
        Migration{2, R"(
CREATE TABLE map_line (
    line_id INTEGER PRIMARY KEY,
    line_hash TEXT NOT NULL UNIQUE,
    crs TEXT NOT NULL
) STRICT;
CREATE TABLE map_line_point (
    line_id INTEGER NOT NULL REFERENCES map_line ON DELETE CASCADE,
    point_index INTEGER NOT NULL,
    chainage_m REAL NOT NULL,
    x REAL NOT NULL,
    y REAL NOT NULL,
    PRIMARY KEY (line_id, point_index)
) STRICT, WITHOUT ROWID;
CREATE TABLE map_line_attribute (
    line_id INTEGER NOT NULL REFERENCES map_line ON DELETE CASCADE,
    attribute_index INTEGER NOT NULL,
    name TEXT NOT NULL,
    value ANY,
    PRIMARY KEY (line_id, attribute_index)
) STRICT, WITHOUT ROWID;
ALTER TABLE run ADD COLUMN line_id INTEGER REFERENCES map_line;
CREATE TABLE frame (
    run_id INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    row_index INTEGER NOT NULL,
    time_s REAL NOT NULL,
    x_low_m REAL NOT NULL,
    x_step_m REAL NOT NULL,
    y_low_m REAL NOT NULL,
    y_step_m REAL NOT NULL,
    speed_low_m_s REAL NOT NULL,
    speed_step_m_s REAL NOT NULL,
    pressure_low_pa REAL NOT NULL,
    pressure_step_pa REAL NOT NULL,
    x BLOB NOT NULL,
    y BLOB NOT NULL,
    speed BLOB NOT NULL,
    pressure BLOB NOT NULL,
    PRIMARY KEY (run_id, row_index)
) STRICT;
)"},
        Migration{3, R"(
CREATE TABLE invariant (
    run_id INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    invariant TEXT NOT NULL,
    invariant_index INTEGER NOT NULL,
    worst REAL,
    limit_value REAL NOT NULL,
    time_s REAL,
    x_m REAL,
    PRIMARY KEY (run_id, invariant)
) STRICT, WITHOUT ROWID;
)"},
    };
    return steps;
}

void migrate(SQLite::Database& database, std::span<const Migration> steps) {
    for (const Migration& step : steps) {
        if (database.execAndGet("PRAGMA user_version").getInt() != step.from) continue;
        database.exec(step.sql);
        database.exec(fmt::format("PRAGMA user_version = {}", step.from + 1));
    }
}

}  // namespace runout
