#pragma once

#include <string>

#include "report/page/run_data.h"

namespace runout {

/// The report of one run as a page that stands alone (html_page). A run that is not a result is shown with
/// its status, what is known of it, and no measures. `width`: of the slide across the section, m; NaN when it
/// is not known (compare_run).
std::string run_page(const RunData& run, double width);

}  // namespace runout
