#pragma once

#include <span>
#include <string>

#include "accuracy/study.h"

namespace runout {

/// How often the error bars of runs held, by the target that they were chosen for: the share of runs whose
/// bar holds the mean of the finest rung, how long the bars are beside the errors, mean signed error, and CPU
/// time with pilots. Scenes whose finest rung is not whole, or ends uphill of the toe, are left out.
std::string coverage_table(std::span<const AccuracyStudy> studies);

}  // namespace runout
