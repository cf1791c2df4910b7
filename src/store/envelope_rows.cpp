#include "store/envelope_rows.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "store/known_tables.h"
#include "store/real_value.h"

namespace runout {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// The blobs are little-endian, and so is every machine that this is built for.
static_assert(std::endian::native == std::endian::little);

constexpr std::array columns = {
    EnvelopeColumn{"greatest_thickness_m", &Envelope::greatest_thickness_m, &ReachRow::greatest_thickness_m},
    EnvelopeColumn{"greatest_speed_m_s", &Envelope::greatest_speed_m_s, &ReachRow::greatest_speed_m_s},
    EnvelopeColumn{"greatest_kinetic_head_m", &Envelope::greatest_kinetic_head_m,
                   &ReachRow::greatest_kinetic_head_m},
    EnvelopeColumn{"greatest_momentum_flux_n_m", &Envelope::greatest_momentum_flux_n_m,
                   &ReachRow::greatest_momentum_flux_n_m},
    EnvelopeColumn{"arrival_time_s", &Envelope::arrival_time_s, &ReachRow::arrival_time_s},
    EnvelopeColumn{"final_thickness_m", &Envelope::final_thickness_m, &ReachRow::final_thickness_m},
    EnvelopeColumn{"passed_area_m2", &Envelope::passed_area_m2, &ReachRow::passed_area_m2},
};

std::string blob_names() {
    std::vector<std::string> names;
    for (const EnvelopeColumn& column : columns) names.push_back(fmt::format("envelope.{}", column.name));
    return fmt::format("{}", fmt::join(names, ", "));
}

/// An infinity of a file is read as none, as everywhere.
std::vector<double> numbers_of(const SQLite::Column& column) {
    std::vector<double> values(static_cast<std::size_t>(column.getBytes()) / sizeof(double));
    if (!values.empty()) std::memcpy(values.data(), column.getBlob(), values.size() * sizeof(double));
    for (double& value : values)
        if (!std::isfinite(value)) value = unknown;
    return values;
}

/// From `place` on: first, step and the arrays.
Envelope read_envelope(const SQLite::Statement& row, int place, long run_id) {
    Envelope envelope;
    envelope.first_m = coordinate(row.getColumn(place++));
    envelope.step_m = coordinate(row.getColumn(place++));
    for (const EnvelopeColumn& column : columns) envelope.*column.values = numbers_of(row.getColumn(place++));
    for (const EnvelopeColumn& column : columns)
        if ((envelope.*column.values).size() != envelope.greatest_thickness_m.size() ||
            !(envelope.step_m > 0))
            throw DamagedData(fmt::format("has an envelope of run {} with parts missing", run_id));
    return envelope;
}

/// Between two nodes linear; where one of them knows no number, that of the other.
double between(const std::vector<double>& values, double place) {
    const double low = std::floor(place);
    const double last = static_cast<double>(values.size()) - 1;
    if (values.empty() || !(place >= 0) || !(place <= last)) return unknown;
    const double a = values[static_cast<std::size_t>(low)];
    const double b = values[static_cast<std::size_t>(std::min(low + 1, last))];
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) ? b : a;
    return a + (place - low) * (b - a);
}

void answer(ReachRow& row, const Envelope& envelope) {
    row.has_envelope = true;
    const double place = (row.from_toe_m - envelope.first_m) / envelope.step_m;
    const bool is_passed = place > static_cast<double>(envelope.greatest_thickness_m.size()) - 1;
    for (const EnvelopeColumn& column : columns) {
        row.*column.value = between(envelope.*column.values, place);
        // No soil came near it.
        if (std::isnan(row.*column.value) && (is_passed || place < 0) &&
            column.value != &ReachRow::arrival_time_s)
            row.*column.value = 0;
    }
    if (!row.reached()) row.arrival_time_s = unknown;
    const double next = between(envelope.arrival_time_s, std::ceil(place));
    row.arrival_is_bound = std::isfinite(row.arrival_time_s) && std::isnan(next);
}

std::string reach_sql(const ReachQuestion& question) {
    std::string which = "run_status.is_result = 1";
    if (question.run_id) which = "run.run_id = ?1";
    if (!question.section.empty()) which = "run.section_origin = ?1";
    std::string from = "run";
    if (question.study_id) {
        which = "study_scenario.study_id = ?1";
        from =
            "study_scenario JOIN scenario AS asked ON asked.scenario_hash = study_scenario.scenario_hash"
            " JOIN run ON run.run_id = (SELECT max(latest.run_id) FROM run AS latest"
            " WHERE latest.scenario_id = asked.scenario_id AND latest.status <> 'interrupted')";
    }
    return fmt::format(
        "SELECT run.run_id, run.name, run.section_origin, run.status, run_status.is_result, "
        "run.front_definition,"
        " section.toe_chainage_m, section.descends_with_chainage,"
        " (SELECT min(x_m) FROM section_point WHERE section_point.section_id = section.section_id),"
        " (SELECT max(x_m) FROM section_point WHERE section_point.section_id = section.section_id),"
        " measure.run_out_m, measure.farthest_front_m, measure.front_thickness_m, run.run_out_error_m,"
        " envelope.run_id IS NOT NULL, envelope.first_m, envelope.step_m, {}"
        " FROM {} JOIN run_status ON run_status.status = run.status"
        " JOIN measure ON measure.run_id = run.run_id"
        " JOIN scenario ON scenario.scenario_id = run.scenario_id"
        " JOIN source ON source.source_id = scenario.source_id"
        " JOIN section ON section.section_id = source.section_id"
        " LEFT JOIN envelope ON envelope.run_id = run.run_id WHERE {} ORDER BY run.run_id",
        blob_names(), from, which);
}

ReachRow read_row(const SQLite::Statement& statement, double chainage) {
    ReachRow row;
    int place = 0;
    row.run_id = statement.getColumn(place++).getInt64();
    for (std::string* text : {&row.name, &row.section_origin, &row.status})
        *text = statement.getColumn(place++).getString();
    row.is_result = statement.getColumn(place++).getInt() != 0;
    row.front_definition = statement.getColumn(place++).getString();
    const double toe = coordinate(statement.getColumn(place++));
    const double sign = statement.getColumn(place++).getInt() != 0 ? 1.0 : -1.0;
    row.from_toe_m = sign * (chainage - toe);
    const double first = toe + sign * coordinate(statement.getColumn(place++));
    const double last = toe + sign * coordinate(statement.getColumn(place++));
    row.section_from_m = std::min(first, last);
    row.section_to_m = std::max(first, last);
    row.run_out_m = real_value(statement.getColumn(place++));
    row.farthest_front_m = real_value(statement.getColumn(place++));
    row.front_thickness_m = real_value(statement.getColumn(place++));
    row.run_out_error_m = real_value(statement.getColumn(place++));
    for (const EnvelopeColumn& column : columns) row.*column.value = unknown;
    if (statement.getColumn(place++).getInt() != 0) answer(row, read_envelope(statement, place, row.run_id));
    return row;
}

}  // namespace

bool ReachRow::reached() const {
    if (status == "stable") return false;
    if (std::isfinite(farthest_front_m)) return farthest_front_m >= from_toe_m;
    return run_out_m > 0 && run_out_m >= from_toe_m;
}

std::span<const EnvelopeColumn> envelope_columns() {
    return columns;
}

void insert_envelope(SQLite::Database& database, long run_id, const Envelope& envelope) {
    if (envelope.greatest_thickness_m.empty()) return;
    std::string names = "run_id, first_m, step_m", places = "?, ?, ?";
    for (const EnvelopeColumn& column : columns) {
        names += fmt::format(", {}", column.name);
        places += ", ?";
    }
    SQLite::Statement statement(database,
                                fmt::format("INSERT INTO envelope ({}) VALUES ({})", names, places));
    int place = 0;
    statement.bind(++place, run_id);
    statement.bind(++place, envelope.first_m);
    statement.bind(++place, envelope.step_m);
    for (const EnvelopeColumn& column : columns) {
        const std::vector<double>& values = envelope.*column.values;
        statement.bind(++place, static_cast<const void*>(values.data()),
                       static_cast<int>(values.size() * sizeof(double)));
    }
    statement.exec();
}

std::optional<Envelope> select_envelope(SQLite::Database& database, long run_id) {
    SQLite::Statement statement(
        database, fmt::format("SELECT first_m, step_m, {} FROM envelope WHERE run_id = ?", blob_names()));
    statement.bind(1, run_id);
    if (!statement.executeStep()) return std::nullopt;
    return read_envelope(statement, 0, run_id);
}

std::vector<ReachRow> select_reach(SQLite::Database& database, const ReachQuestion& question) {
    SQLite::Statement statement(database, reach_sql(question));
    if (question.run_id) statement.bind(1, *question.run_id);
    if (question.study_id) statement.bind(1, *question.study_id);
    if (!question.section.empty()) statement.bind(1, question.section);
    std::vector<ReachRow> rows;
    while (statement.executeStep()) rows.push_back(read_row(statement, question.chainage_m));
    return rows;
}

}  // namespace runout
