#pragma once

#include <functional>
#include <vector>

#include "measures/measures.h"
#include "scene/scene.h"

namespace runout {

/// One height that was tried.
struct BarrierTrial {
    double height_m = 0;
    RunStatus status = RunStatus::running;
    bool holds = false;           ///< a result in which the front stays before the barrier's back
    double farthest_front_m = 0;  ///< from the toe
    double beyond_back_m2 = 0;    ///< soil beyond the barrier at the end, grains included
    BarrierRecord barrier{};      ///< its load
};

/// The search for the least height of a barrier at which nothing as thick as the front passes.
struct BarrierSearch {
    std::vector<BarrierTrial> trials;  ///< in the order they were made
    double least_height_m = 0;         ///< the least that held; NaN: none did up to the greatest
    double too_low_m = 0;              ///< greatest that did not hold; 0: every height tried held
};

/// Doubles or halves the height of the case until one holds and one does not, then halves the interval
/// between them to `tolerance` of the height. `run` simulates a scene. At most 16 runs; no height above the
/// drop of the source. Ends early where `go_on` says no.
BarrierSearch least_barrier(Scene scene, double tolerance, const std::function<RunResult(const Scene&)>& run,
                            const std::function<bool(const BarrierTrial&)>& go_on);

}  // namespace runout
