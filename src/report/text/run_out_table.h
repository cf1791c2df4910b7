#pragma once

#include <string>
#include <vector>

#include "store/store.h"

namespace runout {

/// How the table of a study is laid out. rows and columns: a key that the study varies
/// ("material.friction_angle_deg"), or section, source_type, slope_angle_deg, drop_height_m,
/// friction_angle_deg; empty: chosen by what varies.
struct RunOutTableOptions {
    std::string rows;
    std::string columns;
    std::vector<double> distances;  ///< m; the probability of reaching each is told
};

enum class RunOutTableFormat { text, markdown, csv, json };

/// The run-out table of a study. A cell is one run, with its error bar, or many, with the distances that 50,
/// 16 and 2 % of them reach or pass. Below it stand the probabilities of reaching `distances`, how much each
/// varied number matters, and the scenarios that gave no result, which are in no cell. The text depends on
/// the runs alone, not on when and in what order they were made. Throws InputError: a word for rows or
/// columns that is not known, or that has one value for each scenario.
std::string run_out_table(const std::string& study, const std::vector<StudyRow>& rows,
                          const RunOutTableOptions& options, RunOutTableFormat format);

}  // namespace runout
