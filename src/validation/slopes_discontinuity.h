#pragma once

#include <vector>

#include "validation/case_runs.h"

namespace runout::slopes {

/// Runs of the source of the paper's Fig. 15, its particles kept at 0.045 s.
void plan_discontinuity(std::vector<PlannedRun>& runs);

/// The plane between its fast and its slow part.
void add_discontinuity(CaseReport& report, const CaseRuns& runs);

}  // namespace runout::slopes
