#pragma once

#include <string>

#include "validation/case_runs.h"

namespace runout::slopes {

inline constexpr double box_length = 0.096, box_thickness = 0.045;  // m
inline constexpr double finest_spacing = 0.0006;                    // the paper's, m
inline constexpr const char* finest_run = "finest";

/// One of the two experiments.
struct Box {
    const char* name;
    const char* title;
    double slope_deg;
    double drop_height;  ///< m
    double arrival;      ///< on the bed, the paper's frame (a), s
    double last_frame;   ///< the paper's frame (d), s
    bool front_first;    ///< the front comes to rest before the soil behind it
};

/// Chainage of the toe in profiles/box-NN.csv.
double toe_of(const Box& box);
/// Of the ensemble with H_d to the head, m.
double spacing_of(bool quick);
/// Of the ensemble with H_d to the lower end, m.
double base_spacing(bool quick);
std::string at_spacing(double spacing);

/// False also when it did not end as a result, which then shows in the fronts that miss their reference.
bool finest_is_there(const CaseRuns& runs, bool quick);

/// How far the deposit reaches at each spacing, when it is at rest, and its profile.
void add_deposit(CaseReport& report, const CaseRuns& runs, const Box& box, bool quick);

}  // namespace runout::slopes
