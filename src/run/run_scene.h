#pragma once

#include <atomic>
#include <functional>

#include "measures/measures.h"
#include "scene/scene.h"

namespace runout {

/// How far a run has come, for a progress bar.
struct Progress {
    double time_s = 0;  ///< simulated
    double time_limit_s = 0;
    double fraction = 0;  ///< of the expected run, 0 to 1, from the energy still to be lost
    long steps = 0;
    double wall_s = 0;
    double most_left_s = 0;  ///< wall-clock time until the time limit at the pace so far
};

/// Links of a run to whoever started it, who may leave all of them as they are.
struct RunControl {
    std::function<void(const Progress&)> on_progress;  ///< called about ten times a second
    const std::atomic<bool>* interrupt = nullptr;      ///< set to true to end the run as `interrupted`
    int frames = 0;  ///< most pictures of the particles to keep for an animation; they do not change the run
};

/// Simulates the scene to its end and reads off the measures. Never throws for what the physics does: the
/// status says it.
RunResult run_scene(const Scene& scene, const RunControl& control = {});

}  // namespace runout
