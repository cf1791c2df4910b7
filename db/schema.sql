-- The results database of Runout: every simulated run with the question it answers.
--
-- This file is the only place where the format is written down; the build embeds it in the program.
-- Lengths are metres, angles degrees, the plane of the section is one metre wide: areas are m2, masses
-- and energies are per metre of width. NULL stands for a number that does not exist, such as the reach
-- angle of a source that stands.
--
-- A change of the format raises user_version and adds a step to src/store/migrations.cpp.

PRAGMA application_id = 1381322319;  -- the letters RUNO
PRAGMA user_version = 10;

-- The ground along a section before the failure. Two files with the same ground share one row, so the name
-- of the file belongs to the run.
CREATE TABLE section (
    section_id              INTEGER PRIMARY KEY,
    section_hash            TEXT NOT NULL UNIQUE,   -- SHA-256 of points and frame
    toe_chainage_m          REAL NOT NULL,          -- where the origin of the local frame lies in the file
    toe_elevation_m         REAL NOT NULL,
    descends_with_chainage  INTEGER NOT NULL CHECK (descends_with_chainage IN (0, 1)),
    crest_index             INTEGER NOT NULL,       -- point_index of the upper edge of the cut
    toe_index               INTEGER NOT NULL,       -- point_index of its foot, at (0, 0)
    slope_angle_deg         REAL NOT NULL           -- mean inclination from toe to crest
) STRICT;

-- Local frame: origin at the toe, x towards the run-out, y upwards; from the uphill end to the distal end.
CREATE TABLE section_point (
    section_id   INTEGER NOT NULL REFERENCES section ON DELETE CASCADE,
    point_index  INTEGER NOT NULL,
    x_m          REAL NOT NULL,
    y_m          REAL NOT NULL,
    PRIMARY KEY (section_id, point_index)
) STRICT, WITHOUT ROWID;

-- What moves. The discontinuity angle and the datum of the drop height are part of the definition, because
-- front area and drop height mean nothing without them.
CREATE TABLE source (
    source_id                INTEGER PRIMARY KEY,
    section_id               INTEGER NOT NULL REFERENCES section,
    source_hash              TEXT NOT NULL UNIQUE,  -- SHA-256 of the section and everything below
    source_type              TEXT NOT NULL,         -- rectangle, A, B, C, polygon, slip_surface
    area_m2                  REAL NOT NULL,         -- S_0
    front_area_m2            REAL NOT NULL,         -- S_front
    discontinuity_angle_deg  REAL NOT NULL,         -- theta_id, the line that bounds S_front
    exit_x_m                 REAL NOT NULL,         -- P, where the slip surface daylights on the face
    exit_y_m                 REAL NOT NULL,
    head_x_m                 REAL NOT NULL,         -- upper end on the ground: datum of the reach angle
    head_y_m                 REAL NOT NULL,
    drop_height_m            REAL NOT NULL,         -- H_d above the toe, to its datum
    drop_height_datum        TEXT NOT NULL CHECK (drop_height_datum IN ('head', 'base'))
) STRICT;
CREATE INDEX source_of_section ON source (section_id);

-- Outline: counter-clockwise, first point not repeated. Bed: the ground left when the source has gone.
CREATE TABLE source_point (
    source_id    INTEGER NOT NULL REFERENCES source ON DELETE CASCADE,
    part         TEXT NOT NULL CHECK (part IN ('outline', 'bed')),
    point_index  INTEGER NOT NULL,
    x_m          REAL NOT NULL,
    y_m          REAL NOT NULL,
    PRIMARY KEY (source_id, part, point_index)
) STRICT, WITHOUT ROWID;

-- A question: this source, this soil, simulated like this. Zero in a setting means that the program chooses.
CREATE TABLE scenario (
    scenario_id          INTEGER PRIMARY KEY,
    scenario_hash        TEXT NOT NULL UNIQUE,      -- SHA-256 of all that determines the result
    source_id            INTEGER NOT NULL REFERENCES source,
    density_kg_m3        REAL NOT NULL,
    friction_angle_deg   REAL NOT NULL,
    particle_spacing_m   REAL NOT NULL,             -- as asked for; 0: from resolution
    resolution           REAL NOT NULL,             -- sqrt(S) / particle spacing
    gravity_m_s2         REAL NOT NULL,
    courant              REAL NOT NULL,             -- C_max of the step
    smoothing_ratio      REAL NOT NULL,             -- h / particle spacing
    friction_scheme      TEXT NOT NULL CHECK (friction_scheme IN ('projected', 'explicit')),
    friction_iterations  INTEGER NOT NULL,
    pressure_tolerance   REAL NOT NULL,             -- relative residual of the pressure equation
    time_limit_s         REAL NOT NULL,             -- simulated; 0: 60 sqrt(H/g) or more
    front_thickness_m    REAL NOT NULL,             -- threshold of the front; 0: from sqrt(S)
    lattice_seed         INTEGER NOT NULL DEFAULT 0,   -- 0: regular lattice; else start off it at random
    snapshot_times_s     TEXT NOT NULL DEFAULT '[]',   -- JSON list of the instants to keep the particles of
    base_friction_angle_deg  REAL,                  -- effect: friction of the base; NULL: absent
    release_layers           INTEGER,               -- effect: poured layers; NULL: absent
    release_layer_width_m    REAL,
    release_layer_height_m   REAL,
    sleeping                 INTEGER NOT NULL DEFAULT 0,   -- 1: nothing is solved for soil at rest
    front_window_m           REAL NOT NULL DEFAULT 0       -- half-width of the window of thickness; 0: from sqrt(S)
) STRICT;
CREATE INDEX scenario_of_source ON scenario (source_id);

-- What a scenario says of each effect that goes beyond the core, as its case file would: value in the unit of
-- the key. An effect that is absent has no rows.
CREATE TABLE effect_setting (
    scenario_id    INTEGER NOT NULL REFERENCES scenario ON DELETE CASCADE,
    setting_index  INTEGER NOT NULL,
    effect         TEXT NOT NULL,       -- "cohesion", as in [effects.cohesion]
    key            TEXT NOT NULL,
    value          TEXT NOT NULL,
    PRIMARY KEY (scenario_id, setting_index)
) STRICT, WITHOUT ROWID;

-- How a run can end. Only runs with is_result = 1 may stand in a table or on a map.
CREATE TABLE run_status (
    status     TEXT PRIMARY KEY,
    is_result  INTEGER NOT NULL CHECK (is_result IN (0, 1)),
    meaning    TEXT NOT NULL
) STRICT, WITHOUT ROWID;
INSERT INTO run_status VALUES
    ('settled',       1, 'came to rest by itself'),
    ('stable',        1, 'the source stands at this strength: no run-out'),
    ('time_limit',    0, 'still moving at the time limit'),
    ('left_section',  0, 'soil reached an end of the section'),
    ('not_converged', 0, 'the pressure equation did not reach its tolerance'),
    ('diverged',      0, 'an invariant of the physics was violated'),
    ('interrupted',   0, 'stopped by the user'),
    ('not_a_body',    0, 'came to rest as spray, or nowhere as thick as the front');

-- One simulation of a scenario: how it ended, who computed it, and what it took.
CREATE TABLE run (
    run_id                  INTEGER PRIMARY KEY AUTOINCREMENT,  -- the id of a deleted run is not given again
    scenario_id             INTEGER NOT NULL REFERENCES scenario,
    name                    TEXT NOT NULL,
    section_origin          TEXT NOT NULL,          -- file the section was read from
    started_utc             TEXT NOT NULL,          -- ISO 8601
    ended_utc               TEXT NOT NULL,
    status                  TEXT NOT NULL REFERENCES run_status,
    status_detail           TEXT NOT NULL,          -- what went wrong, when and where; empty when it settled
    program_version         TEXT NOT NULL,
    program_revision        TEXT NOT NULL,
    compiler                TEXT NOT NULL,
    host_threads            INTEGER NOT NULL,       -- hardware threads of the machine
    particles               INTEGER NOT NULL,
    boundary_particles      INTEGER NOT NULL,
    particle_spacing_m      REAL,                   -- effective: particles * spacing^2 = source area
    steps                   INTEGER NOT NULL,
    pressure_iterations     INTEGER NOT NULL,       -- CG iterations of all steps
    wall_guard_activations  INTEGER NOT NULL,
    highest_density_ratio   REAL,                   -- densest particle at any instant / rho_0
    simulated_s             REAL,
    wall_s                  REAL,
    cpu_s                   REAL,
    threads                 INTEGER NOT NULL,       -- used by this run
    line_id                 INTEGER REFERENCES map_line,  -- where it lies; NULL: the section came from a CSV
    peak_memory_mb          REAL NOT NULL DEFAULT 0,         -- resident memory of the program; 0: not known
    machine                 TEXT NOT NULL DEFAULT '',        -- processor and hardware threads
    accuracy_asked          TEXT NOT NULL DEFAULT '',        -- "5 %"; empty: the spacing was given
    run_out_error_m         REAL,                            -- numerical uncertainty of run_out_m, 95 %; NULL: not estimated
    reach_angle_error_deg   REAL,                            -- and of reach_angle_deg
    error_origin            TEXT NOT NULL DEFAULT 'none' CHECK (error_origin IN ('ladder', 'pilot', 'none')),
    error_note              TEXT NOT NULL DEFAULT '',        -- how they were found, one sentence
    expected_cpu_s          REAL,                            -- as the cost model foretold it; NULL: it did not
    choosing_cpu_s          REAL NOT NULL DEFAULT 0,         -- spent on pilot runs for this run
    spared_share            REAL,   -- of the particle steps: at rest or in free flight, without friction and pressure
    toe_origin              TEXT NOT NULL DEFAULT '' CHECK (toe_origin IN ('found', 'given', '')),
    crest_origin            TEXT NOT NULL DEFAULT '' CHECK (crest_origin IN ('found', 'given', '')),
    section_read_as         TEXT NOT NULL DEFAULT '',        -- columns and units that were found in the file; empty: its form leaves no choice
    section_doubts          TEXT NOT NULL DEFAULT '',        -- what speaks against the toe and crest that were taken, a line each
    front_definition        TEXT NOT NULL DEFAULT 'top' CHECK (front_definition IN ('thickness', 'top'))  -- of run_out_m, reach angle and series; top: before version 10
) STRICT;
CREATE INDEX run_of_scenario ON run (scenario_id);

-- Coarse runs of the same scene that were made for choosing the spacing of a run and for its error bar.
CREATE TABLE pilot (
    run_id               INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    row_index            INTEGER NOT NULL,
    resolution           REAL,      -- sqrt(S) / particle spacing
    lattice_seed         REAL,
    run_out_m            REAL,      -- NULL: did not end as a result
    reach_angle_deg      REAL,
    deposit_height_m     REAL,
    particles            REAL,
    steps                REAL,
    pressure_iterations  REAL,
    cpu_s                REAL,
    PRIMARY KEY (run_id, row_index)
) STRICT, WITHOUT ROWID;

-- A study of what accuracy costs: one question asked with several spacings and settings.
CREATE TABLE ladder (
    ladder_id      INTEGER PRIMARY KEY AUTOINCREMENT,
    question_hash  TEXT NOT NULL,      -- SHA-256 of all that determines the result but spacing and lattice
    name           TEXT NOT NULL,
    ended_utc      TEXT NOT NULL,
    target         TEXT NOT NULL,      -- "5 %"
    machine        TEXT NOT NULL
) STRICT;
CREATE INDEX ladder_of_question ON ladder (question_hash);

-- The runs of a study. series: what was varied, 'spacing' for the ladder proper; setting: its value.
CREATE TABLE ladder_run (
    ladder_id   INTEGER NOT NULL REFERENCES ladder ON DELETE CASCADE,
    row_index   INTEGER NOT NULL,
    series      TEXT NOT NULL,
    setting     TEXT NOT NULL,
    resolution  REAL NOT NULL,         -- sqrt(S) / particle spacing
    run_id      INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    PRIMARY KEY (ladder_id, row_index)
) STRICT, WITHOUT ROWID;

-- What the ladder says of one quantity.
CREATE TABLE ladder_verdict (
    ladder_id               INTEGER NOT NULL REFERENCES ladder ON DELETE CASCADE,
    quantity                TEXT NOT NULL,  -- column of measure
    verdict                 TEXT NOT NULL,  -- converged, floor reached, oscillating, not converging, refining, too few rungs
    finest_value            REAL,           -- mean over the lattices of the finest rung
    uncertainty             REAL,           -- of one run on that rung, 95 %
    lattice_scatter         REAL,           -- standard deviation of one lattice
    observed_order          REAL,           -- of the three finest rungs
    richardson_value        REAL,
    grid_convergence_index  REAL,           -- of the finest value, a share of it; safety factor 1.25
    fitted_order            REAL,           -- least squares over the finest rungs
    fitted_value            REAL,           -- extrapolated to spacing zero
    PRIMARY KEY (ladder_id, quantity)
) STRICT;

-- Where a section lies on a map. Two sections with the same ground may lie in two places, so the line belongs
-- to the run and is no part of the identity of its scenario.
CREATE TABLE map_line (
    line_id    INTEGER PRIMARY KEY,
    line_hash  TEXT NOT NULL UNIQUE,    -- SHA-256 of all of it
    crs        TEXT NOT NULL            -- coordinate system, WKT 2
) STRICT;

-- Between two points the line is straight, and chainage grows in proportion.
CREATE TABLE map_line_point (
    line_id      INTEGER NOT NULL REFERENCES map_line ON DELETE CASCADE,
    point_index  INTEGER NOT NULL,
    chainage_m   REAL NOT NULL,         -- as in the section
    x            REAL NOT NULL,         -- easting or longitude, in units of the coordinate system
    y            REAL NOT NULL,         -- northing or latitude
    PRIMARY KEY (line_id, point_index)
) STRICT, WITHOUT ROWID;

-- What the map said of the line, such as the number of the slope.
CREATE TABLE map_line_attribute (
    line_id          INTEGER NOT NULL REFERENCES map_line ON DELETE CASCADE,
    attribute_index  INTEGER NOT NULL,
    name             TEXT NOT NULL,
    value            ANY,
    PRIMARY KEY (line_id, attribute_index)
) STRICT, WITHOUT ROWID;

-- Lines of a layer that were asked for and refused as input, so that none is missing unsaid. One that is taken later is
-- struck off.
CREATE TABLE refused_section (
    origin      TEXT NOT NULL,         -- file and layer
    feature_id  INTEGER NOT NULL,
    name        TEXT NOT NULL,
    reason      TEXT NOT NULL,         -- one sentence
    line_id     INTEGER NOT NULL REFERENCES map_line,  -- a line without points where nothing of it can be drawn
    PRIMARY KEY (origin, feature_id)
) STRICT, WITHOUT ROWID;

-- Many scenarios that were asked for together. A run may belong to several studies: what links them is the scenario.
CREATE TABLE study (
    study_id  INTEGER PRIMARY KEY,
    name      TEXT NOT NULL UNIQUE,
    text      TEXT NOT NULL          -- the study file as it stood
) STRICT;

CREATE TABLE study_scenario (
    study_id        INTEGER NOT NULL REFERENCES study ON DELETE CASCADE,
    scenario_index  INTEGER NOT NULL,   -- place in the study, from 0
    scenario_hash   TEXT NOT NULL,      -- of the scenario; empty: refused
    inputs          TEXT NOT NULL,      -- JSON: what the study varied
    refusal         TEXT NOT NULL,      -- why the scenario was refused as input; empty when it was not
    PRIMARY KEY (study_id, scenario_index)
) STRICT, WITHOUT ROWID;

-- Seconds spent in each phase of the step.
CREATE TABLE phase_time (
    run_id       INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    phase        TEXT NOT NULL,
    phase_index  INTEGER NOT NULL,      -- its place in the step
    wall_s       REAL,
    PRIMARY KEY (run_id, phase)
) STRICT, WITHOUT ROWID;

-- How near a run came to violating what must hold in every step; it ends as diverged when worst exceeds limit_value.
-- Pure numbers; docs/stability.md says of what.
CREATE TABLE invariant (
    run_id           INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    invariant        TEXT NOT NULL,
    invariant_index  INTEGER NOT NULL,
    worst            REAL,
    limit_value      REAL NOT NULL,
    time_s           REAL,              -- of the worst
    x_m              REAL,              -- where, local frame
    PRIMARY KEY (run_id, invariant)
) STRICT, WITHOUT ROWID;

-- What is said of a run, one row each. For a run that is not a result these are the last readings only. Distances are
-- horizontal, from the toe. Where run.front_definition is top, run_out_m, front_by_mass_m and front_mass_995_m are
-- lengths along the bed, run_out_m is the contiguous front by top, and peak_front_speed_m_s that of the mass point.
CREATE TABLE measure (
    run_id                   INTEGER PRIMARY KEY REFERENCES run ON DELETE CASCADE,
    run_out_m                REAL,   -- L_inf: front at rest, the farthest place where all soil is front_thickness_m thick
    run_out_normalised       REAL,   -- L_inf / sqrt(S_inf)
    front_by_mass_m          REAL,   -- contiguous front by mass
    front_mass_995_m         REAL,   -- distance from the toe that 99.5 % of the mass does not pass
    front_thickness_m        REAL,   -- threshold of the front
    reach_angle_deg          REAL,   -- from the head of the source to the distal margin
    source_area_m2           REAL,   -- S_0
    deposit_area_m2          REAL,   -- S_inf
    front_area_m2            REAL,   -- S_front
    front_area_ratio         REAL,   -- S_front / S_0
    drop_height_m            REAL,   -- H_d to its datum
    drop_height_normalised   REAL,   -- H_d / sqrt(S_inf)
    deposit_height_m         REAL,   -- greatest thickness by top
    toe_thickness_m          REAL,   -- thickness by top at the toe of the cut
    peak_front_speed_m_s     REAL,   -- greatest speed of the soil at the front, mean over depth and window
    time_to_rest_s           REAL,   -- simulated time at which motion ended
    stray_particles          REAL,   -- particles not connected to the deposit
    eroded_area_m2           REAL,   -- soil of an erodible bed that has moved; NULL: the bed is rigid
    run_out_along_bed_m      REAL,   -- L_inf along the bed
    farthest_front_m         REAL,   -- farthest front at any instant
    front_window_m           REAL,   -- half-width of the window that thickness and speed are taken in
    front_by_top_m           REAL,   -- contiguous front by top
    peak_mass_995_speed_m_s  REAL,   -- greatest speed of the 99.5 % mass point
    farthest_soil_m          REAL,   -- farthest single grain at any instant
    beyond_front_area_m2     REAL,   -- soil at rest beyond the front, thinner than its threshold
    beyond_front_speed_m_s   REAL    -- greatest speed of a grain beyond the front of its instant
) STRICT;

-- The whole mass over simulated time.
CREATE TABLE series (
    run_id                INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    row_index             INTEGER NOT NULL,
    time_s                REAL,
    front_mass_995_m      REAL,     -- 99.5 % mass point from the toe; horizontal, but along the bed before version 10
    kinetic_energy_j_m    REAL,
    potential_energy_j_m  REAL,     -- above the toe
    plastic_work_j_m      REAL,     -- dissipated by friction since release
    mass_kg_m             REAL,
    front_m               REAL,     -- front, horizontal, from the toe; NULL: none, or not known
    PRIMARY KEY (run_id, row_index)
) STRICT, WITHOUT ROWID;

-- The deposit when the run ended, chainage and elevation as in the section file.
CREATE TABLE deposit_profile (
    run_id               INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    row_index            INTEGER NOT NULL,
    chainage_m           REAL,
    bed_elevation_m      REAL,
    thickness_by_mass_m  REAL,      -- soil area per width of the bin
    thickness_by_top_m   REAL,      -- highest particle of the connected deposit + half a spacing
    PRIMARY KEY (run_id, row_index)
) STRICT, WITHOUT ROWID;

-- Particles at one instant, local frame. Each blob is one IEEE-754 float32, little-endian, per particle, in
-- the order of packing. With a rowid, because blobs this large make a slow tree of keys.
CREATE TABLE snapshot (
    run_id       INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    row_index    INTEGER NOT NULL,
    time_s       REAL NOT NULL,
    x_m          BLOB NOT NULL,
    y_m          BLOB NOT NULL,
    vx_m_s       BLOB NOT NULL,
    vy_m_s       BLOB NOT NULL,
    pressure_pa  BLOB NOT NULL,
    PRIMARY KEY (run_id, row_index)
) STRICT;

-- Pictures of the moving mass, local frame, for the animation of a report: six bytes a particle, at most about
-- 4000 particles, enough to look at and not to compute with. value = low + code * step. A particle has the same
-- place in every picture of a run. In x and y a code is an unsigned 16-bit integer, little-endian, in speed and
-- pressure an unsigned byte.
CREATE TABLE frame (
    run_id             INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    row_index          INTEGER NOT NULL,
    time_s             REAL NOT NULL,
    x_low_m            REAL NOT NULL,
    x_step_m           REAL NOT NULL,
    y_low_m            REAL NOT NULL,
    y_step_m           REAL NOT NULL,
    speed_low_m_s      REAL NOT NULL,
    speed_step_m_s     REAL NOT NULL,
    pressure_low_pa    REAL NOT NULL,
    pressure_step_pa   REAL NOT NULL,
    x                  BLOB NOT NULL,
    y                  BLOB NOT NULL,
    speed              BLOB NOT NULL,
    pressure           BLOB NOT NULL,
    PRIMARY KEY (run_id, row_index)
) STRICT;

-- The heap at rest after each release of a staged run; row 0 is the source alone.
CREATE TABLE stage (
    run_id             INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    row_index          INTEGER NOT NULL,
    time_s             REAL,
    area_m2            REAL,     -- released so far
    surface_angle_deg  REAL,     -- of the free surface in the middle part of the deposit
    deposit_height_m   REAL,
    run_out_m          REAL,
    PRIMARY KEY (run_id, row_index)
) STRICT, WITHOUT ROWID;

-- The effects that were on in a run, what that means, and what each cost. One that has no row was off.
CREATE TABLE run_effect (
    run_id     INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    row_index  INTEGER NOT NULL,
    effect     TEXT NOT NULL,
    why        TEXT NOT NULL,
    cost_s     REAL,               -- wall seconds of work of its own; NULL: none apart from the rest of the step
    PRIMARY KEY (run_id, row_index)
) STRICT, WITHOUT ROWID;

-- Sentences about effects that were off and may matter.
CREATE TABLE advice (
    run_id     INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    row_index  INTEGER NOT NULL,
    sentence   TEXT NOT NULL,
    PRIMARY KEY (run_id, row_index)
) STRICT, WITHOUT ROWID;

-- What passed the places that the case names. Thickness and speed are the greatest on its width, the rest is of its near edge.
CREATE TABLE place (
    run_id                      INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
    place_index                 INTEGER NOT NULL,
    name                        TEXT NOT NULL,
    chainage_m                  REAL,     -- of its near edge
    arrival_time_s              REAL,     -- first instant at which the front is at or beyond it; NULL: not reached
    greatest_thickness_m        REAL,
    greatest_speed_m_s          REAL,     -- mean over depth, of soil as thick as the front
    greatest_kinetic_head_m     REAL,     -- speed^2 / 2g
    passed_area_m2              REAL,     -- soil that has passed, net
    kind                        TEXT NOT NULL DEFAULT '',     -- building, road, ... as the case says
    width_m                     REAL,     -- from the near edge away from the cut
    greatest_momentum_flux_n_m  REAL,     -- rho v^2 h
    final_thickness_m           REAL,
    PRIMARY KEY (run_id, place_index)
) STRICT, WITHOUT ROWID;

CREATE TABLE place_series (
    run_id          INTEGER NOT NULL,
    place_index     INTEGER NOT NULL,
    row_index       INTEGER NOT NULL,
    time_s          REAL,
    thickness_m     REAL,
    speed_m_s       REAL,
    kinetic_head_m  REAL,
    passed_area_m2  REAL,
    PRIMARY KEY (run_id, place_index, row_index),
    FOREIGN KEY (run_id, place_index) REFERENCES place ON DELETE CASCADE
) STRICT, WITHOUT ROWID;

-- What passed along the section, at first_m + i step_m: horizontal distances from the toe, towards the run-out. Each blob is one
-- IEEE-754 float64, little-endian, per node; NaN: none. Speeds, heads and fluxes are of soil as thick as the front.
CREATE TABLE envelope (
    run_id                      INTEGER PRIMARY KEY REFERENCES run ON DELETE CASCADE,
    first_m                     REAL NOT NULL,
    step_m                      REAL NOT NULL,    -- a third of front_window_m
    greatest_thickness_m        BLOB NOT NULL,
    greatest_speed_m_s          BLOB NOT NULL,    -- mean over depth and window
    greatest_kinetic_head_m     BLOB NOT NULL,    -- speed^2 / 2g
    greatest_momentum_flux_n_m  BLOB NOT NULL,    -- rho v^2 h, per metre of width
    arrival_time_s              BLOB NOT NULL,    -- of the front
    final_thickness_m           BLOB NOT NULL,
    passed_area_m2              BLOB NOT NULL     -- soil that has passed since release, net
) STRICT;

-- What the debris did to the barrier, per metre of width; x towards the run-out.
CREATE TABLE barrier (
    run_id                 INTEGER PRIMARY KEY REFERENCES run ON DELETE CASCADE,
    arrival_time_s         REAL,    -- NULL: nothing arrived
    greatest_force_n_m     REAL,    -- horizontal, mean over an interval of barrier_series
    greatest_force_time_s  REAL,
    greatest_moment_n      REAL,    -- about the foot of its face, overturning towards the run-out
    impulse_n_s_m          REAL,    -- horizontal, of the whole run
    last_force_n_m         REAL,    -- horizontal, when the run ended
    run_up_m               REAL,    -- above the foot
    overtopped_area_m2     REAL,    -- beyond the barrier when the run ended
    approach_speed_m_s     REAL,
    approach_thickness_m   REAL,
    design_force_n_m       REAL     -- alpha rho v^2 h of the approach
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

-- For people who open this file in a database browser or QGIS: the ground in the coordinates of its file.
CREATE VIEW section_ground AS
SELECT section_id,
       point_index,
       toe_chainage_m + CASE descends_with_chainage WHEN 1 THEN x_m ELSE -x_m END AS chainage_m,
       toe_elevation_m + y_m AS elevation_m
FROM section_point JOIN section USING (section_id);

-- Where the cut of each section is.
CREATE VIEW section_face AS
SELECT section_id,
       toe_chainage_m,
       toe_elevation_m,
       toe_chainage_m + CASE descends_with_chainage WHEN 1 THEN x_m ELSE -x_m END AS crest_chainage_m,
       y_m AS face_height_m,
       slope_angle_deg
FROM section JOIN section_point USING (section_id)
WHERE point_index = crest_index;

-- And the runs whose numbers may be used, with the words that say what was asked.
CREATE VIEW result AS
SELECT run.name,
       run.section_origin,
       source.source_type,
       source.discontinuity_angle_deg,
       source.drop_height_datum,
       section.slope_angle_deg,
       section_face.toe_chainage_m,
       section_face.crest_chainage_m,
       section_face.face_height_m,
       run.toe_origin,
       run.crest_origin,
       run.section_doubts,
       scenario.friction_angle_deg,
       run.status,
       run.front_definition,
       run.run_out_error_m,
       run.reach_angle_error_deg,
       run.error_origin,
       measure.*
FROM run
JOIN run_status USING (status)
JOIN scenario USING (scenario_id)
JOIN source USING (source_id)
JOIN section USING (section_id)
JOIN section_face USING (section_id)
JOIN measure USING (run_id)
WHERE run_status.is_result = 1;

-- Each rung of each study: means over the lattices that ended as results.
CREATE VIEW ladder_rung AS
SELECT ladder.ladder_id,
       ladder.name,
       ladder_run.series,
       ladder_run.setting,
       ladder_run.resolution,
       count(*) AS lattices,
       avg(run.particles) AS particles,
       avg(run.steps) AS steps,
       avg(run.cpu_s) AS cpu_s,
       avg(measure.run_out_m) AS run_out_m,
       avg(measure.reach_angle_deg) AS reach_angle_deg,
       avg(measure.deposit_height_m) AS deposit_height_m
FROM ladder
JOIN ladder_run USING (ladder_id)
JOIN run USING (run_id)
JOIN run_status USING (status)
JOIN measure USING (run_id)
WHERE run_status.is_result = 1
GROUP BY ladder.ladder_id, ladder_run.series, ladder_run.setting, ladder_run.resolution;
