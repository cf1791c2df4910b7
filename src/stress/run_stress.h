#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "measures/measures.h"
#include "stress/stress_point.h"

namespace runout {

class Store;

/// What became of one random scene.
struct StressOutcome {
    int index = 0;  ///< among the points, from 0
    StressPoint point;
    std::string refusal;              ///< why it is no valid input; empty: it ran
    std::optional<RunResult> result;  ///< absent when refused, or when the user stopped before its turn
};

struct StressOptions {
    int jobs = 1;
    std::optional<int> only = std::nullopt;  ///< index of the one scene to run; absent: all
    /// Keys "run.*" of a case file and their values, for all scenes; in place of the defaults.
    std::vector<std::pair<std::string, std::string>> settings;
    const std::atomic<bool>* interrupt = nullptr;
    std::function<void(int done, int total)> on_run;  ///< may be empty; called by one thread at a time
};

/// "stress-<seed>-<index>", the name of a scene.
std::string stress_name(std::uint64_t seed, int index);

/// Runs every point that is valid input and stores it in `store` under the name "stress-<seed>-<index>".
/// Throws InputError when a setting is not one of a run.
std::vector<StressOutcome> run_stress(const std::vector<StressPoint>& points, std::uint64_t seed,
                                      Store& store, const StressOptions& options);

/// Came to rest, though it be as spray, or was refused as invalid input.
bool is_sound(const StressOutcome& outcome);

}  // namespace runout
