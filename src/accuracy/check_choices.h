#pragma once

#include <atomic>

#include "accuracy/ladder.h"
#include "scene/scene.h"
#include "store/store.h"

namespace runout {

/// Lets settings be chosen for 10, 5 and 2 %, once from pilots and the survey without this scene, as on a
/// scene that nobody has seen, and once from `ladder`; runs and stores them with their error bars and adds
/// them to the ladder's runs.
/// `longest_run_s`: CPU time that a chosen run may take; where the target would take more, the best within it
/// is checked.
void check_choices(const Scene& scene, Ladder& ladder, Store& store, double longest_run_s,
                   const std::atomic<bool>* interrupt);

}  // namespace runout
