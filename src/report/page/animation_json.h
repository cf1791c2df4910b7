#pragma once

#include <string>

#include "report/page/run_data.h"

namespace runout {

/// What report/page/animation.js plays, as JSON; empty without frames. Frames are left out evenly until the
/// text has at most `most_bytes`; the first and the last stay.
std::string animation_json(const RunData& run, std::size_t most_bytes = 3'500'000);

}  // namespace runout
