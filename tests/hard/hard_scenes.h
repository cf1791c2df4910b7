#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stress/stress_scene.h"

namespace runout {

/// A named scene of the stability suite. A failure that was found once becomes one and stays.
struct HardScene {
    std::string name;
    bool quick = false;           ///< part of every test run; the others belong to the full suite
    std::function<Scene()> make;  ///< with one thread
};

/// A plain slope of 60 deg with a box on it, from which each scene departs in a few numbers.
StressPoint plain_hard_point();

/// All, each as fine as it says, 100 particles or so.
std::vector<HardScene> hard_scenes();

/// Those that do not fix their spacing, with that sqrt(S)/dl.
std::vector<HardScene> hard_scenes_at(double resolution, bool quick_only);

}  // namespace runout
