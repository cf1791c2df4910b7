#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "measures/measures.h"

namespace SQLite {
class Database;
}

namespace runout {

/// Which runs are asked about a place: one, those of a study (the latest of each scenario), or all on
/// sections of one origin. None given: every run that is a result.
struct ReachQuestion {
    double chainage_m = 0;
    std::optional<long> run_id{};
    std::optional<long> study_id{};
    std::string section{};  ///< origin, as the run names it
};

/// What one run says of a place. Numbers that the run does not know are NaN.
struct ReachRow {
    long run_id = 0;
    std::string name, section_origin, status;
    bool is_result = false;
    std::string front_definition = current_front_definition;
    double from_toe_m = 0;                        ///< horizontally, of the place; negative uphill
    double section_from_m = 0, section_to_m = 0;  ///< least and greatest chainage of its section
    double run_out_m = 0, farthest_front_m = 0, front_thickness_m = 0;
    double run_out_error_m = 0;  ///< numerical, 95 %
    bool has_envelope = false;
    bool arrival_is_bound = false;  ///< it arrives then or later: the next node is not reached
    double greatest_thickness_m = 0, greatest_speed_m_s = 0, greatest_kinetic_head_m = 0,
           greatest_momentum_flux_n_m = 0, arrival_time_s = 0, final_thickness_m = 0, passed_area_m2 = 0;

    /// By the front, as docs/front.md says; of a run that knows no farthest front, by the front at rest.
    [[nodiscard]] bool reached() const;
};

void insert_envelope(SQLite::Database& database, long run_id, const Envelope& envelope);
/// None: the run is older than envelopes.
std::optional<Envelope> select_envelope(SQLite::Database& database, long run_id);
/// In the order of the runs; results and others.
std::vector<ReachRow> select_reach(SQLite::Database& database, const ReachQuestion& question);

/// Names of the arrays, as in db/schema.sql.
struct EnvelopeColumn {
    const char* name;
    std::vector<double> Envelope::*values;
    double ReachRow::*value;
};
std::span<const EnvelopeColumn> envelope_columns();

}  // namespace runout
