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
ALTER TABLE run ADD COLUMN peak_memory_mb REAL NOT NULL DEFAULT 0;
ALTER TABLE run ADD COLUMN machine TEXT NOT NULL DEFAULT '';
ALTER TABLE run ADD COLUMN accuracy_asked TEXT NOT NULL DEFAULT '';
ALTER TABLE run ADD COLUMN run_out_error_m REAL;
ALTER TABLE run ADD COLUMN reach_angle_error_deg REAL;
ALTER TABLE run ADD COLUMN error_origin TEXT NOT NULL DEFAULT 'none'
    CHECK (error_origin IN ('ladder', 'pilot', 'none'));
ALTER TABLE run ADD COLUMN error_note TEXT NOT NULL DEFAULT '';
ALTER TABLE run ADD COLUMN expected_cpu_s REAL;
ALTER TABLE run ADD COLUMN choosing_cpu_s REAL NOT NULL DEFAULT 0;
CREATE TABLE pilot (
    run_id INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    row_index INTEGER NOT NULL,
    resolution REAL,
    lattice_seed REAL,
    run_out_m REAL,
    reach_angle_deg REAL,
    deposit_height_m REAL,
    particles REAL,
    steps REAL,
    pressure_iterations REAL,
    cpu_s REAL,
    PRIMARY KEY (run_id, row_index)
) STRICT, WITHOUT ROWID;
CREATE TABLE ladder (
    ladder_id INTEGER PRIMARY KEY AUTOINCREMENT,
    question_hash TEXT NOT NULL,
    name TEXT NOT NULL,
    ended_utc TEXT NOT NULL,
    target TEXT NOT NULL,
    machine TEXT NOT NULL
) STRICT;
CREATE INDEX ladder_of_question ON ladder (question_hash);
CREATE TABLE ladder_run (
    ladder_id INTEGER NOT NULL REFERENCES ladder ON DELETE CASCADE,
    row_index INTEGER NOT NULL,
    series TEXT NOT NULL,
    setting TEXT NOT NULL,
    resolution REAL NOT NULL,
    run_id INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    PRIMARY KEY (ladder_id, row_index)
) STRICT, WITHOUT ROWID;
CREATE TABLE ladder_verdict (
    ladder_id INTEGER NOT NULL REFERENCES ladder ON DELETE CASCADE,
    quantity TEXT NOT NULL,
    verdict TEXT NOT NULL,
    finest_value REAL,
    uncertainty REAL,
    lattice_scatter REAL,
    observed_order REAL,
    richardson_value REAL,
    grid_convergence_index REAL,
    fitted_order REAL,
    fitted_value REAL,
    PRIMARY KEY (ladder_id, quantity)
) STRICT;
DROP VIEW result;
CREATE VIEW result AS
SELECT run.name, run.section_origin, source.source_type, source.discontinuity_angle_deg, source.drop_height_datum,
       section.slope_angle_deg, scenario.friction_angle_deg, run.status, run.run_out_error_m,
       run.reach_angle_error_deg, run.error_origin, measure.*
FROM run
JOIN run_status USING (status)
JOIN scenario USING (scenario_id)
JOIN source USING (source_id)
JOIN section USING (section_id)
JOIN measure USING (run_id)
WHERE run_status.is_result = 1;
CREATE VIEW ladder_rung AS
SELECT ladder.ladder_id, ladder.name, ladder_run.series, ladder_run.setting, ladder_run.resolution,
       count(*) AS lattices, avg(run.particles) AS particles, avg(run.steps) AS steps, avg(run.cpu_s) AS cpu_s,
       avg(measure.run_out_m) AS run_out_m, avg(measure.reach_angle_deg) AS reach_angle_deg,
       avg(measure.deposit_height_m) AS deposit_height_m
FROM ladder
JOIN ladder_run USING (ladder_id)
JOIN run USING (run_id)
JOIN run_status USING (status)
JOIN measure USING (run_id)
WHERE run_status.is_result = 1
GROUP BY ladder.ladder_id, ladder_run.series, ladder_run.setting, ladder_run.resolution;
)"},
        Migration{4, R"(
CREATE TABLE study (
    study_id INTEGER PRIMARY KEY,
    name TEXT NOT NULL UNIQUE,
    text TEXT NOT NULL
) STRICT;
CREATE TABLE study_scenario (
    study_id INTEGER NOT NULL REFERENCES study ON DELETE CASCADE,
    scenario_index INTEGER NOT NULL,
    scenario_hash TEXT NOT NULL,
    inputs TEXT NOT NULL,
    refusal TEXT NOT NULL,
    PRIMARY KEY (study_id, scenario_index)
) STRICT, WITHOUT ROWID;
)"},
        Migration{5, R"(
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
        Migration{6, R"(
ALTER TABLE measure ADD COLUMN eroded_area_m2 REAL;
ALTER TABLE run ADD COLUMN spared_share REAL;
CREATE TABLE effect_setting (
    scenario_id    INTEGER NOT NULL REFERENCES scenario ON DELETE CASCADE,
    setting_index  INTEGER NOT NULL,
    effect         TEXT NOT NULL,
    key            TEXT NOT NULL,
    value          TEXT NOT NULL,
    PRIMARY KEY (scenario_id, setting_index)
) STRICT, WITHOUT ROWID;
CREATE TABLE run_effect (
    run_id     INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    row_index  INTEGER NOT NULL,
    effect     TEXT NOT NULL,
    why        TEXT NOT NULL,
    cost_s     REAL,
    PRIMARY KEY (run_id, row_index)
) STRICT, WITHOUT ROWID;
CREATE TABLE advice (
    run_id     INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    row_index  INTEGER NOT NULL,
    sentence   TEXT NOT NULL,
    PRIMARY KEY (run_id, row_index)
) STRICT, WITHOUT ROWID;
CREATE TABLE gauge (
    run_id                   INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    gauge_index              INTEGER NOT NULL,
    name                     TEXT NOT NULL,
    chainage_m               REAL,
    arrival_time_s           REAL,
    greatest_thickness_m     REAL,
    greatest_speed_m_s       REAL,
    greatest_kinetic_head_m  REAL,
    passed_area_m2           REAL,
    PRIMARY KEY (run_id, gauge_index)
) STRICT, WITHOUT ROWID;
CREATE TABLE gauge_series (
    run_id          INTEGER NOT NULL,
    gauge_index     INTEGER NOT NULL,
    row_index       INTEGER NOT NULL,
    time_s          REAL,
    thickness_m     REAL,
    speed_m_s       REAL,
    kinetic_head_m  REAL,
    passed_area_m2  REAL,
    PRIMARY KEY (run_id, gauge_index, row_index),
    FOREIGN KEY (run_id, gauge_index) REFERENCES gauge ON DELETE CASCADE
) STRICT, WITHOUT ROWID;
CREATE TABLE barrier (
    run_id                 INTEGER PRIMARY KEY REFERENCES run ON DELETE CASCADE,
    arrival_time_s         REAL,
    greatest_force_n_m     REAL,
    greatest_force_time_s  REAL,
    greatest_moment_n      REAL,
    impulse_n_s_m          REAL,
    last_force_n_m         REAL,
    run_up_m               REAL,
    overtopped_area_m2     REAL,
    approach_speed_m_s     REAL,
    approach_thickness_m   REAL,
    design_force_n_m       REAL
) STRICT;
CREATE TABLE barrier_series (
    run_id           INTEGER NOT NULL REFERENCES barrier ON DELETE CASCADE,
    row_index        INTEGER NOT NULL,
    time_s           REAL,
    force_x_n_m      REAL,
    force_y_n_m      REAL,
    moment_n         REAL,
    impulse_x_n_s_m  REAL,
    PRIMARY KEY (run_id, row_index)
) STRICT, WITHOUT ROWID;
INSERT INTO effect_setting
SELECT scenario_id, 0, 'base_friction', 'angle_deg', CAST(base_friction_angle_deg AS TEXT) FROM scenario
WHERE base_friction_angle_deg IS NOT NULL
UNION ALL SELECT scenario_id, 1, 'release', 'layers', CAST(release_layers AS TEXT) FROM scenario
WHERE release_layers IS NOT NULL
UNION ALL SELECT scenario_id, 2, 'release', 'layer_width_m', CAST(release_layer_width_m AS TEXT) FROM scenario
WHERE release_layers IS NOT NULL
UNION ALL SELECT scenario_id, 3, 'release', 'layer_height_m', CAST(release_layer_height_m AS TEXT) FROM scenario
WHERE release_layers IS NOT NULL;
INSERT INTO run_effect
SELECT run_id, 0, 'base_friction', 'the bed has a friction of its own', NULL FROM run JOIN scenario USING (scenario_id)
WHERE base_friction_angle_deg IS NOT NULL
UNION ALL SELECT run_id, 1, 'release', 'several releases, one after the other', NULL
FROM run JOIN scenario USING (scenario_id) WHERE release_layers IS NOT NULL;
)"},
        Migration{7, R"(
ALTER TABLE scenario ADD COLUMN sleeping INTEGER NOT NULL DEFAULT 0;
)"},
        Migration{8, R"(
ALTER TABLE run ADD COLUMN toe_origin TEXT NOT NULL DEFAULT '' CHECK (toe_origin IN ('found', 'given', ''));
ALTER TABLE run ADD COLUMN crest_origin TEXT NOT NULL DEFAULT '' CHECK (crest_origin IN ('found', 'given', ''));
ALTER TABLE run ADD COLUMN section_read_as TEXT NOT NULL DEFAULT '';
ALTER TABLE run ADD COLUMN section_doubts TEXT NOT NULL DEFAULT '';
CREATE VIEW section_face AS
SELECT section_id, toe_chainage_m, toe_elevation_m,
       toe_chainage_m + CASE descends_with_chainage WHEN 1 THEN x_m ELSE -x_m END AS crest_chainage_m,
       y_m AS face_height_m, slope_angle_deg
FROM section JOIN section_point USING (section_id)
WHERE point_index = crest_index;
DROP VIEW result;
CREATE VIEW result AS
SELECT run.name, run.section_origin, source.source_type, source.discontinuity_angle_deg, source.drop_height_datum,
       section.slope_angle_deg, section_face.toe_chainage_m, section_face.crest_chainage_m,
       section_face.face_height_m, run.toe_origin, run.crest_origin, run.section_doubts,
       scenario.friction_angle_deg, run.status, run.run_out_error_m, run.reach_angle_error_deg, run.error_origin,
       measure.*
FROM run
JOIN run_status USING (status)
JOIN scenario USING (scenario_id)
JOIN source USING (source_id)
JOIN section USING (section_id)
JOIN section_face USING (section_id)
JOIN measure USING (run_id)
WHERE run_status.is_result = 1;
CREATE TABLE refused_section (
    origin TEXT NOT NULL,
    feature_id INTEGER NOT NULL,
    name TEXT NOT NULL,
    reason TEXT NOT NULL,
    line_id INTEGER NOT NULL REFERENCES map_line,
    PRIMARY KEY (origin, feature_id)
) STRICT, WITHOUT ROWID;
)"},
        Migration{9, R"(
DROP VIEW result;
INSERT INTO run_status VALUES ('not_a_body', 0, 'came to rest as spray, or nowhere as thick as the front');
ALTER TABLE scenario ADD COLUMN front_window_m REAL NOT NULL DEFAULT 0;
ALTER TABLE run ADD COLUMN front_definition TEXT NOT NULL DEFAULT 'top'
    CHECK (front_definition IN ('thickness', 'top'));
ALTER TABLE measure ADD COLUMN run_out_along_bed_m REAL;
ALTER TABLE measure ADD COLUMN farthest_front_m REAL;
ALTER TABLE measure ADD COLUMN front_window_m REAL;
ALTER TABLE measure ADD COLUMN front_by_top_m REAL;
ALTER TABLE measure ADD COLUMN peak_mass_995_speed_m_s REAL;
ALTER TABLE measure ADD COLUMN farthest_soil_m REAL;
ALTER TABLE measure ADD COLUMN beyond_front_area_m2 REAL;
ALTER TABLE measure ADD COLUMN beyond_front_speed_m_s REAL;
ALTER TABLE series RENAME COLUMN front_m TO front_mass_995_m;
ALTER TABLE series ADD COLUMN front_m REAL;
ALTER TABLE gauge RENAME TO place;
ALTER TABLE place RENAME COLUMN gauge_index TO place_index;
ALTER TABLE place ADD COLUMN kind TEXT NOT NULL DEFAULT '';
ALTER TABLE place ADD COLUMN width_m REAL;
ALTER TABLE place ADD COLUMN greatest_momentum_flux_n_m REAL;
ALTER TABLE place ADD COLUMN final_thickness_m REAL;
ALTER TABLE gauge_series RENAME TO place_series;
ALTER TABLE place_series RENAME COLUMN gauge_index TO place_index;
CREATE TABLE envelope (
    run_id INTEGER PRIMARY KEY REFERENCES run ON DELETE CASCADE,
    first_m REAL NOT NULL,
    step_m REAL NOT NULL,
    greatest_thickness_m BLOB NOT NULL,
    greatest_speed_m_s BLOB NOT NULL,
    greatest_kinetic_head_m BLOB NOT NULL,
    greatest_momentum_flux_n_m BLOB NOT NULL,
    arrival_time_s BLOB NOT NULL,
    final_thickness_m BLOB NOT NULL,
    passed_area_m2 BLOB NOT NULL
) STRICT;
CREATE VIEW result AS
SELECT run.name, run.section_origin, source.source_type, source.discontinuity_angle_deg, source.drop_height_datum,
       section.slope_angle_deg, section_face.toe_chainage_m, section_face.crest_chainage_m,
       section_face.face_height_m, run.toe_origin, run.crest_origin, run.section_doubts,
       scenario.friction_angle_deg, run.status, run.front_definition, run.run_out_error_m,
       run.reach_angle_error_deg, run.error_origin, measure.*
FROM run
JOIN run_status USING (status)
JOIN scenario USING (scenario_id)
JOIN source USING (source_id)
JOIN section USING (section_id)
JOIN section_face USING (section_id)
JOIN measure USING (run_id)
WHERE run_status.is_result = 1;
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
