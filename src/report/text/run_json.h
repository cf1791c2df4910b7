#pragma once

#include <string>
#include <vector>

#include "store/store.h"

namespace runout {

/// A JSON array with one object a run, each as run_json() makes it.
std::string runs_json(const std::vector<StoredRun>& runs);

}  // namespace runout
