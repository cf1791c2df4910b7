#include "store/write_scenario.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>
#include <string>

#include "core/units.h"
#include "store/effect_rows.h"
#include "store/scenario_hash.h"

namespace runout {
namespace {

using SQLite::Database;
using SQLite::Statement;

std::optional<long> id_of(Database& database, const char* query, const std::string& hash) {
    Statement statement(database, query);
    statement.bind(1, hash);
    if (!statement.executeStep()) return std::nullopt;
    return statement.getColumn(0).getInt64();
}

long insert(Database& database, Statement& statement) {
    statement.exec();
    return database.getLastInsertRowid();
}

void insert_section_points(Database& database, long section_id, const Polyline& ground) {
    Statement statement(database,
                        "INSERT INTO section_point (section_id, point_index, x_m, y_m) VALUES (?, ?, ?, ?)");
    for (std::size_t i = 0; i < ground.size(); ++i) {
        SQLite::bind(statement, section_id, static_cast<long>(i), ground[i].x(), ground[i].y());
        statement.exec();
        statement.reset();
    }
}

void insert_source_points(Database& database, long source_id, const char* part,
                          const std::vector<Vec2>& points) {
    Statement statement(
        database, "INSERT INTO source_point (source_id, part, point_index, x_m, y_m) VALUES (?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < points.size(); ++i) {
        SQLite::bind(statement, source_id, part, static_cast<long>(i), points[i].x(), points[i].y());
        statement.exec();
        statement.reset();
    }
}

long insert_section(Database& database, const Profile& profile, const std::string& hash) {
    Statement statement(
        database,
        "INSERT INTO section (section_hash, toe_chainage_m, toe_elevation_m, descends_with_chainage,"
        " crest_index, toe_index, slope_angle_deg) VALUES (?, ?, ?, ?, ?, ?, ?)");
    SQLite::bind(statement, hash, profile.toe_chainage_m, profile.toe_elevation_m,
                 static_cast<int>(profile.descends_with_chainage), static_cast<long>(profile.crest),
                 static_cast<long>(profile.toe), degrees(profile.slope_angle));
    const long section_id = insert(database, statement);
    insert_section_points(database, section_id, profile.ground);
    return section_id;
}

long insert_source(Database& database, long section_id, const Source& source, const std::string& hash) {
    Statement statement(
        database,
        "INSERT INTO source (section_id, source_hash, source_type, area_m2, front_area_m2,"
        " discontinuity_angle_deg, exit_x_m, exit_y_m, head_x_m, head_y_m, drop_height_m, drop_height_datum)"
        " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    SQLite::bind(statement, section_id, hash, to_string(source.type), source.area, source.front_area,
                 degrees(source.discontinuity_angle), source.exit_point.x(), source.exit_point.y(),
                 source.head.x(), source.head.y(), source.drop_height, to_string(source.datum));
    const long source_id = insert(database, statement);
    insert_source_points(database, source_id, "outline", source.outline);
    insert_source_points(database, source_id, "bed", source.bed);
    return source_id;
}

/// Columns of version 2, kept for those who read them; all effects are in effect_setting. An absent effect
/// leaves its columns NULL.
void write_effects(Database& database, long scenario_id, const Effects& effects) {
    if (effects.base_friction && std::isfinite(effects.base_friction->angle)) {
        Statement statement(database,
                            "UPDATE scenario SET base_friction_angle_deg = ? WHERE scenario_id = ?");
        SQLite::bind(statement, degrees(effects.base_friction->angle), scenario_id);
        statement.exec();
    }
    if (effects.release) {
        Statement statement(database,
                            "UPDATE scenario SET release_layers = ?, release_layer_width_m = ?,"
                            " release_layer_height_m = ? WHERE scenario_id = ?");
        SQLite::bind(statement, effects.release->layers, effects.release->layer_width,
                     effects.release->layer_height, scenario_id);
        statement.exec();
    }
}

long insert_scenario(Database& database, long source_id, const Scene& scene, const std::string& hash) {
    Statement statement(
        database,
        "INSERT INTO scenario (scenario_hash, source_id, density_kg_m3, friction_angle_deg,"
        " particle_spacing_m, resolution, gravity_m_s2, courant, smoothing_ratio, friction_scheme,"
        " friction_iterations, pressure_tolerance, time_limit_s, front_thickness_m, sleeping, lattice_seed,"
        " snapshot_times_s, front_window_m) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    const RunSettings& run = scene.run;
    SQLite::bind(statement, hash, source_id, scene.material.density, degrees(scene.material.friction_angle),
                 run.particle_spacing, run.resolution, run.gravity, run.courant, run.smoothing_ratio,
                 friction_scheme_name(run.friction), run.friction_iterations, run.pressure_tolerance,
                 run.time_limit, run.front_thickness, run.sleeping ? 1 : 0, run.lattice_seed,
                 fmt::format("[{}]", fmt::join(run.snapshot_times, ", ")), run.front_window);
    const long scenario_id = insert(database, statement);
    write_effects(database, scenario_id, scene.effects);
    insert_effect_settings(database, scenario_id, scene);
    return scenario_id;
}

long section_row(Database& database, const Profile& profile, const std::string& hash) {
    const auto known = id_of(database, "SELECT section_id FROM section WHERE section_hash = ?", hash);
    return known ? *known : insert_section(database, profile, hash);
}

long source_row(Database& database, const Scene& scene, const SceneIdentity& identity) {
    const auto known = id_of(database, "SELECT source_id FROM source WHERE source_hash = ?", identity.source);
    if (known) return *known;
    const long section_id = section_row(database, scene.profile, identity.section);
    return insert_source(database, section_id, scene.source, identity.source);
}

}  // namespace

long scenario_row(Database& database, const Scene& scene) {
    const SceneIdentity identity = scene_identity(scene);
    const auto known =
        id_of(database, "SELECT scenario_id FROM scenario WHERE scenario_hash = ?", identity.scenario);
    if (known) return *known;
    const long source_id = source_row(database, scene, identity);
    return insert_scenario(database, source_id, scene, identity.scenario);
}

}  // namespace runout
