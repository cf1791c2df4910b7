#pragma once

#include <string>
#include <vector>

#include "report/text/intensity.h"
#include "report/text/reach_probability.h"
#include "store/envelope_rows.h"

namespace runout {

/// What many runs say of a place together. Runs that are no result are left out.
struct ReachSummary {
    long runs = 0, without_result = 0, without_envelope = 0, former_fronts = 0;
    long within_error = 0;  ///< results whose front could as well be on the other side of the place
    Probability reached;
    /// With 50, 16 and 2 % at least so much; NaN where there are too few runs.
    std::vector<ReachDistance> thickness_m, speed_m_s;
};

ReachSummary summary_of(const std::vector<ReachRow>& rows);

/// A few lines for people on one run.
std::string reach_text(const ReachRow& row, double chainage_m, const Intensities& classes);
/// And on many.
std::string reach_text(const ReachSummary& summary, double chainage_m);

/// JSON objects of the same.
std::string reach_json(const ReachRow& row, double chainage_m, const Intensities& classes);
std::string reach_json(const ReachSummary& summary, double chainage_m);

}  // namespace runout
