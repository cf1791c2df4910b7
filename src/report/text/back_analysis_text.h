#pragma once

#include <string>
#include <vector>

#include "validation/back_analysis.h"

namespace runout {

/// For a terminal, in Markdown: what was varied, what the model gives over all of it, what was observed, and
/// what the model leaves out.
std::string back_analysis_text(const BackAnalysis& analysis, const std::vector<StoredRun>& runs);

}  // namespace runout
