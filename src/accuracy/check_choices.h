#pragma once

#include <atomic>

#include "accuracy/ladder.h"
#include "scene/scene.h"
#include "store/store.h"

namespace runout {

/// Lets settings be chosen for 10, 5 and 2 %, once from pilots and the survey without this scene, as on a
/// scene that nobody has seen, and once from `ladder`; runs and stores them with their error bars and adds
/// them to the ladder's runs.
void check_choices(const Scene& scene, Ladder& ladder, Store& store, const std::atomic<bool>* interrupt);

}  // namespace runout
