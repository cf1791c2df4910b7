#pragma once

#include <optional>
#include <string>

#include "estimate/held_out.h"
#include "estimate/run_out_chart.h"

namespace runout {

/// Size and place of the source that an estimate is for; without them it is in L/sqrt(S) only.
struct EstimateScale {
    double source_area_m2 = 0;
    std::optional<double> head_behind_toe_m;  ///< horizontal; not given: by eq. 11, the head on a plane face
};

/// A few lines for people.
std::string estimate_text(const RunOutChart& chart, const Estimate& estimate,
                          const std::optional<EstimateScale>& scale);

/// One JSON object; what does not exist is null.
std::string estimate_json(const RunOutChart& chart, const Estimate& estimate,
                          const std::optional<EstimateScale>& scale);

std::string held_out_text(const HeldOutCheck& check);
std::string held_out_json(const HeldOutCheck& check);

}  // namespace runout
