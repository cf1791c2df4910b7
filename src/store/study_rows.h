#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measures/measures.h"

namespace SQLite {
class Database;
}

namespace runout {

/// A study as its file said it.
struct StoredStudy {
    long study_id = 0;
    std::string name;
    std::string text;
    long scenarios = 0;  ///< rows it has, with a run or without
};

/// One scenario of a study.
struct StudyScenario {
    long index = 0;
    std::string scenario_hash;  ///< empty: refused
    std::string inputs;         ///< JSON of what the study varied
    std::string refusal;        ///< why there is no scene
};

/// One line of a study's table: a scenario with the latest run of it. Numbers that do not exist are NaN.
struct StudyRow {
    StudyScenario scenario;
    std::optional<long> run_id;  ///< none: refused, or not run yet
    std::string name;
    std::string section_origin;
    std::string source_type;
    std::string status, status_detail;
    std::string front_definition = current_front_definition;
    bool is_result = false;
    double slope_angle_deg = 0, friction_angle_deg = 0;
    double source_area_m2 = 0, front_area_m2 = 0, drop_height_m = 0;
    double farthest_front_m = 0;  ///< at any instant; NaN: not known
    double run_out_m = 0, run_out_normalised = 0, reach_angle_deg = 0, deposit_height_m = 0;
    double run_out_error_m = 0, reach_angle_error_deg = 0;
};

/// The study of that name, made if absent. What it said of scenarios is forgotten when its text has changed.
long study_row(SQLite::Database& database, const std::string& name, const std::string& text);
void set_study_scenarios(SQLite::Database& database, long study_id, const std::vector<StudyScenario>& rows);

std::vector<StoredStudy> select_studies(SQLite::Database& database);
/// In the order of the study.
std::vector<StudyRow> select_study_rows(SQLite::Database& database, long study_id);
/// The statement behind select_study_rows, for looking at its plan.
std::string study_rows_sql();

}  // namespace runout
