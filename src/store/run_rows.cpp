#include "store/run_rows.h"

#include <SQLiteCpp/VariadicBind.h>

#include <array>
#include <bit>
#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "store/column_rows.h"
#include "store/known_tables.h"
#include "store/real_value.h"
#include "store/run_places.h"

namespace runout {
namespace {

using SQLite::Database;
using SQLite::Statement;

/// Words of StoredRun by their column of the table `run`, status apart.
struct TextColumn {
    const char* name;
    std::string StoredRun::*value;
};
constexpr std::array text_columns = {
    TextColumn{"name", &StoredRun::name},
    TextColumn{"section_origin", &StoredRun::section_origin},
    TextColumn{"started_utc", &StoredRun::started_utc},
    TextColumn{"ended_utc", &StoredRun::ended_utc},
    TextColumn{"program_version", &StoredRun::program_version},
    TextColumn{"program_revision", &StoredRun::program_revision},
    TextColumn{"compiler", &StoredRun::compiler},
    TextColumn{"status_detail", &StoredRun::status_detail},
    TextColumn{"machine", &StoredRun::machine},
    TextColumn{"toe_origin", &StoredRun::toe_origin},
    TextColumn{"crest_origin", &StoredRun::crest_origin},
    TextColumn{"section_read_as", &StoredRun::section_read_as},
    TextColumn{"section_doubts", &StoredRun::section_doubts},
    TextColumn{"front_definition", &StoredRun::front_definition},
};

void bind_work(Statement& statement, int& place, const RunWork& work) {
    for (const WorkColumn& column : work_columns())
        std::visit([&](auto member) { statement.bind(++place, work.*member); }, column.member);
}

void read_work(const Statement& statement, int& place, RunWork& work) {
    const auto read = [&](auto member) {
        using Number = std::remove_reference_t<decltype(work.*member)>;
        const SQLite::Column value = statement.getColumn(place++);
        if constexpr (std::is_same_v<Number, double>)
            work.*member = real_value(value);
        else
            work.*member = static_cast<Number>(value.getInt64());
    };
    for (const WorkColumn& column : work_columns()) std::visit(read, column.member);
}

void bind_appraisal(Statement& statement, int& place, const Appraisal& appraisal) {
    bind_numbers(statement, place, appraisal, appraisal_numbers());
    for (const auto& column : appraisal_texts()) statement.bind(++place, appraisal.*column.value);
}

void read_appraisal(const Statement& statement, int& place, Appraisal& appraisal) {
    read_numbers(statement, place, appraisal, appraisal_numbers());
    for (const auto& column : appraisal_texts())
        appraisal.*column.value = statement.getColumn(place++).getString();
}

RunStatus status_of(const std::string& word) {
    constexpr std::array all = {RunStatus::settled,       RunStatus::stable,     RunStatus::time_limit,
                                RunStatus::left_section,  RunStatus::diverged,   RunStatus::interrupted,
                                RunStatus::not_converged, RunStatus::not_a_body, RunStatus::running};
    for (const RunStatus status : all)
        if (to_string(status) == word) return status;
    throw DamagedData("holds a run of the unknown status " + word);
}

template <class Row>
void insert_rows(Database& database, const char* table, long run_id, const std::vector<Row>& rows,
                 std::span<const RealColumn<Row>> columns) {
    std::vector<std::string> names = {"run_id", "row_index"};
    append_names(names, columns);
    Statement statement(database, insert_sql(table, names));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        int place = 0;
        statement.bind(++place, run_id);
        statement.bind(++place, static_cast<long>(i));
        bind_numbers(statement, place, rows[i], columns);
        statement.exec();
        statement.reset();
    }
}

template <class Row>
std::vector<Row> select_rows(Database& database, const char* table, long run_id,
                             std::span<const RealColumn<Row>> columns) {
    std::vector<std::string> names;
    append_names(names, columns);
    Statement statement(database, fmt::format("SELECT {} FROM {} WHERE run_id = ? ORDER BY row_index",
                                              fmt::join(names, ", "), table));
    statement.bind(1, run_id);
    std::vector<Row> rows;
    while (statement.executeStep()) {
        Row row;
        int place = 0;
        read_numbers(statement, place, row, columns);
        rows.push_back(row);
    }
    return rows;
}

// The blobs are little-endian, and so is every machine that this is built for.
static_assert(std::endian::native == std::endian::little);

std::vector<float> floats_of(const SQLite::Column& column) {
    std::vector<float> values(static_cast<std::size_t>(column.getBytes()) / sizeof(float));
    if (!values.empty()) std::memcpy(values.data(), column.getBlob(), values.size() * sizeof(float));
    return values;
}

/// SQLite takes a null pointer for NULL, and an empty vector may have one.
void bind_floats(Statement& statement, int place, const std::vector<float>& values) {
    const void* bytes = values.empty() ? static_cast<const void*>("") : values.data();
    statement.bind(place, bytes, static_cast<int>(values.size() * sizeof(float)));
}

/// Every array has one number for each particle.
void check_snapshot(const Snapshot& snapshot, long run_id) {
    for (const SnapshotColumn& column : snapshot_columns())
        if ((snapshot.*column.value).size() != snapshot.x_m.size())
            throw DamagedData(fmt::format("has particles of run {} with parts missing", run_id));
}

void insert_measures(Database& database, long run_id, const Measures& measures) {
    std::vector<std::string> names = {"run_id"};
    append_names(names, measure_fields());
    Statement statement(database, insert_sql("measure", names));
    int place = 0;
    statement.bind(++place, run_id);
    for (const MeasureField& field : measure_fields()) statement.bind(++place, measures.*field.value);
    statement.exec();
}

// As the view section_face has it; views of a file are not trusted.
constexpr const char* crest_chainage =
    "toe_chainage_m + CASE descends_with_chainage WHEN 1 THEN crest.x_m ELSE -crest.x_m END";

std::string select_runs_sql(const char* condition) {
    std::vector<std::string> names = {"run.run_id",
                                      "run.status",
                                      "scenario.scenario_hash",
                                      "source.source_type",
                                      "source.discontinuity_angle_deg",
                                      "source.drop_height_datum",
                                      "section.slope_angle_deg",
                                      "section.toe_chainage_m",
                                      "section.toe_elevation_m",
                                      crest_chainage,
                                      "crest.y_m",
                                      "scenario.friction_angle_deg",
                                      "run.host_threads"};
    for (const auto& column : text_columns) names.push_back(fmt::format("run.{}", column.name));
    for (const auto& column : work_columns()) names.push_back(fmt::format("run.{}", column.name));
    for (const auto& column : appraisal_numbers()) names.push_back(fmt::format("run.{}", column.name));
    for (const auto& column : appraisal_texts()) names.push_back(fmt::format("run.{}", column.name));
    for (const auto& field : measure_fields()) names.push_back(fmt::format("measure.{}", field.name));
    return fmt::format(
        "SELECT {} FROM run JOIN measure USING (run_id) JOIN scenario USING (scenario_id)"
        " JOIN source USING (source_id) JOIN section USING (section_id)"
        " JOIN section_point AS crest ON crest.section_id = section.section_id AND point_index = crest_index "
        "{} ORDER BY run.run_id",
        fmt::join(names, ", "), condition);
}

/// One row of select_runs_sql().
StoredRun read_run(const Statement& row) {
    StoredRun run;
    int place = 0;
    run.run_id = row.getColumn(place++).getInt64();
    run.status = status_of(row.getColumn(place++).getString());
    run.scenario_hash = row.getColumn(place++).getString();
    run.source_type = row.getColumn(place++).getString();
    run.discontinuity_angle_deg = coordinate(row.getColumn(place++));
    run.drop_height_datum = row.getColumn(place++).getString();
    run.slope_angle_deg = coordinate(row.getColumn(place++));
    run.toe_chainage_m = coordinate(row.getColumn(place++));
    run.toe_elevation_m = coordinate(row.getColumn(place++));
    run.crest_chainage_m = coordinate(row.getColumn(place++));
    run.face_height_m = coordinate(row.getColumn(place++));
    run.friction_angle_deg = coordinate(row.getColumn(place++));
    run.host_threads = row.getColumn(place++).getInt();
    for (const auto& column : text_columns) run.*column.value = row.getColumn(place++).getString();
    read_work(row, place, run.work);
    read_appraisal(row, place, run.appraisal);
    for (const MeasureField& field : measure_fields())
        run.measures.*field.value = real_value(row.getColumn(place++));
    return run;
}

std::vector<StoredRun> read_runs(Database& database, Statement& statement) {
    std::vector<StoredRun> runs;
    while (statement.executeStep()) runs.push_back(read_run(statement));
    for (StoredRun& run : runs) run.section_attributes = select_attributes(database, run.run_id);
    return runs;
}

}  // namespace

long insert_run(Database& database, long scenario_id, const StoredRun& run) {
    std::vector<std::string> names = {"scenario_id", "status", "host_threads"};
    append_names(names, text_columns);
    append_names(names, work_columns());
    append_names(names, appraisal_numbers());
    append_names(names, appraisal_texts());
    Statement statement(database, insert_sql("run", names));
    int place = 0;
    statement.bind(++place, scenario_id);
    statement.bind(++place, std::string(to_string(run.status)));
    statement.bind(++place, run.host_threads);
    for (const auto& column : text_columns) statement.bind(++place, run.*column.value);
    bind_work(statement, place, run.work);
    bind_appraisal(statement, place, run.appraisal);
    statement.exec();
    const long run_id = database.getLastInsertRowid();
    insert_measures(database, run_id, run.measures);
    return run_id;
}

void insert_series(Database& database, long run_id, const std::vector<SeriesRow>& rows) {
    insert_rows(database, "series", run_id, rows, series_columns());
}

void insert_deposit(Database& database, long run_id, const std::vector<DepositRow>& rows) {
    insert_rows(database, "deposit_profile", run_id, rows, deposit_columns());
}

void insert_stages(Database& database, long run_id, const std::vector<StageRow>& rows) {
    insert_rows(database, "stage", run_id, rows, stage_columns());
}

void insert_pilots(Database& database, long run_id, const std::vector<PilotRow>& rows) {
    insert_rows(database, "pilot", run_id, rows, pilot_columns());
}

void insert_snapshots(Database& database, long run_id, const std::vector<Snapshot>& snapshots) {
    std::vector<std::string> names = {"run_id", "row_index", "time_s"};
    append_names(names, snapshot_columns());
    Statement statement(database, insert_sql("snapshot", names));
    for (std::size_t i = 0; i < snapshots.size(); ++i) {
        int place = 0;
        statement.bind(++place, run_id);
        statement.bind(++place, static_cast<long>(i));
        statement.bind(++place, snapshots[i].time_s);
        for (const SnapshotColumn& column : snapshot_columns())
            bind_floats(statement, ++place, snapshots[i].*column.value);
        statement.exec();
        statement.reset();
    }
}

void insert_phases(Database& database, long run_id, const std::vector<PhaseTime>& rows) {
    Statement statement(database,
                        "INSERT INTO phase_time (run_id, phase_index, phase, wall_s) VALUES (?, ?, ?, ?)");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        SQLite::bind(statement, run_id, static_cast<long>(i), rows[i].phase, rows[i].wall_s);
        statement.exec();
        statement.reset();
    }
}

void insert_invariants(Database& database, long run_id, const std::vector<InvariantRow>& rows) {
    Statement statement(
        database,
        "INSERT INTO invariant (run_id, invariant_index, invariant, worst, limit_value, time_s, "
        "x_m) VALUES (?, ?, ?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const InvariantRow& row = rows[i];
        SQLite::bind(statement, run_id, static_cast<long>(i), row.invariant, row.worst, row.limit, row.time_s,
                     row.x_m);
        statement.exec();
        statement.reset();
    }
}

std::vector<StoredRun> select_runs(Database& database) {
    Statement statement(database, select_runs_sql(""));
    return read_runs(database, statement);
}

std::vector<StoredRun> select_runs(Database& database, long run_id) {
    Statement statement(database, select_runs_sql("WHERE run.run_id = ?"));
    statement.bind(1, run_id);
    return read_runs(database, statement);
}

std::vector<StoredRun> select_runs_on_section(Database& database, long section_id) {
    Statement statement(database, select_runs_sql("WHERE section.section_id = ?"));
    statement.bind(1, section_id);
    return read_runs(database, statement);
}

std::optional<long> select_run_of(Database& database, const std::string& scenario_hash) {
    Statement statement(database,
                        "SELECT max(run.run_id) FROM run JOIN scenario USING (scenario_id)"
                        " WHERE scenario_hash = ? AND status <> 'interrupted'");
    statement.bind(1, scenario_hash);
    statement.executeStep();
    const SQLite::Column found = statement.getColumn(0);
    if (found.isNull()) return std::nullopt;
    return found.getInt64();
}

std::vector<Snapshot> select_snapshots(Database& database, long run_id) {
    std::vector<std::string> names = {"time_s"};
    append_names(names, snapshot_columns());
    Statement statement(database, fmt::format("SELECT {} FROM snapshot WHERE run_id = ? ORDER BY row_index",
                                              fmt::join(names, ", ")));
    statement.bind(1, run_id);
    std::vector<Snapshot> snapshots;
    while (statement.executeStep()) {
        Snapshot snapshot;
        int place = 0;
        snapshot.time_s = coordinate(statement.getColumn(place++));
        for (const SnapshotColumn& column : snapshot_columns())
            snapshot.*column.value = floats_of(statement.getColumn(place++));
        check_snapshot(snapshot, run_id);
        snapshots.push_back(std::move(snapshot));
    }
    return snapshots;
}

std::vector<PilotRow> select_pilots(Database& database, long run_id) {
    return select_rows(database, "pilot", run_id, pilot_columns());
}

std::vector<StageRow> select_stages(Database& database, long run_id) {
    return select_rows(database, "stage", run_id, stage_columns());
}

std::vector<SeriesRow> select_series(Database& database, long run_id) {
    return select_rows(database, "series", run_id, series_columns());
}

std::vector<DepositRow> select_deposit(Database& database, long run_id) {
    return select_rows(database, "deposit_profile", run_id, deposit_columns());
}

std::vector<PhaseTime> select_phases(Database& database, long run_id) {
    Statement statement(database,
                        "SELECT phase, wall_s FROM phase_time WHERE run_id = ? ORDER BY phase_index");
    statement.bind(1, run_id);
    std::vector<PhaseTime> rows;
    while (statement.executeStep())
        rows.push_back({statement.getColumn(0).getString(), real_value(statement.getColumn(1))});
    return rows;
}

std::vector<InvariantRow> select_invariants(Database& database, long run_id) {
    Statement statement(database,
                        "SELECT invariant, worst, limit_value, time_s, x_m FROM invariant WHERE run_id = ?"
                        " ORDER BY invariant_index");
    statement.bind(1, run_id);
    std::vector<InvariantRow> rows;
    while (statement.executeStep())
        rows.push_back({statement.getColumn(0).getString(), real_value(statement.getColumn(1)),
                        real_value(statement.getColumn(2)), real_value(statement.getColumn(3)),
                        real_value(statement.getColumn(4))});
    return rows;
}

}  // namespace runout
