#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measures/measures.h"

namespace SQLite {
class Database;
}

namespace runout {

/// One scenario with what a run-out chart is drawn from: its latest run that the user did not interrupt.
struct ChartRow {
    long run_id = 0;
    long source_id = 0;
    double slope_angle_deg = 0;
    double head_height_m = 0;  ///< of the upper end of the source above the toe
    double source_area_m2 = 0;
    double front_area_m2 = 0;
    double discontinuity_angle_deg = 0;  ///< of the plane that bounds front_area_m2
    double friction_angle_deg = 0;
    double particle_spacing_m = 0;
    double run_out_m = 0;  ///< NaN where there is none
    std::string status;
    std::string effects;  ///< "cohesion.cohesion_kpa = 5, ..." in the order of the case; empty: none
    std::string front_definition = current_front_definition;
};

/// Of one study, or of the whole database; in the order of the scenarios.
std::vector<ChartRow> select_chart_rows(SQLite::Database& database, std::optional<long> study_id);
/// The statement behind it, for looking at its plan.
std::string chart_rows_sql(bool of_study);

}  // namespace runout
