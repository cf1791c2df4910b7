#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace runout {

/// Slopes to learn numerical errors from, and to test what was learned on. Of each three, two are ordinary
/// cuts: boxes and sources of type A, B and C on plain faces of 45 to 80 deg, friction 28 to 42 deg, 1 to 8
/// times sqrt(S) high. The third is any scene of `runout stress`. The same seed makes the same slopes; those
/// that make no valid scene are left out, so that there are exactly `count`. Each has one thread.
std::vector<Scene> random_slopes(int count, std::uint64_t seed);

}  // namespace runout
