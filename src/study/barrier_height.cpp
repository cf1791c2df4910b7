#include "study/barrier_height.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace runout {
namespace {

constexpr int most_trials = 16;
constexpr double least_share = 1.0 / 64;  // of the height of the case: a barrier lower than that is none

double back_of(const Barrier& barrier) {
    return barrier.x + barrier.height / std::tan(barrier.inclination) + barrier.thickness;
}

double tallest(const Scene& scene) {
    const auto [low, high] =
        std::ranges::minmax(scene.source.outline, {}, [](const Vec2& point) { return point.y(); });
    return std::max(high.y(), high.y() - low.y());
}

}  // namespace

BarrierSearch least_barrier(Scene scene, double tolerance, const std::function<RunResult(const Scene&)>& run,
                            const std::function<bool(const BarrierTrial&)>& go_on) {
    Barrier& barrier = *scene.effects.barrier;
    const double least = least_share * barrier.height, greatest = tallest(scene);
    BarrierSearch search{.trials = {}, .least_height_m = std::numeric_limits<double>::infinity()};
    double height = std::min(barrier.height, greatest);
    for (int k = 0; k < most_trials; ++k) {
        barrier.height = height;
        const RunResult result = run(scene);
        BarrierTrial trial{height, result.status};
        trial.farthest_front_m = result.measures.farthest_front_m;
        if (!result.barriers.empty()) trial.barrier = result.barriers.front();
        trial.beyond_back_m2 = trial.barrier.overtopped_area_m2;
        trial.holds = is_result(result.status) && !(trial.farthest_front_m > back_of(barrier));
        search.trials.push_back(trial);
        if (trial.holds)
            search.least_height_m = std::min(search.least_height_m, height);
        else
            search.too_low_m = std::max(search.too_low_m, height);
        if (!go_on(trial)) break;
        const bool held = std::isfinite(search.least_height_m);
        if (held && search.least_height_m - search.too_low_m <= tolerance * search.least_height_m) break;
        if (!held && height >= greatest) break;
        if (search.too_low_m == 0 && search.least_height_m <= least) break;
        height = !held ? std::min(2 * height, greatest)
                       : (search.too_low_m > 0 ? 0.5 * (search.least_height_m + search.too_low_m)
                                               : 0.5 * search.least_height_m);
    }
    if (!std::isfinite(search.least_height_m))
        search.least_height_m = std::numeric_limits<double>::quiet_NaN();
    return search;
}

}  // namespace runout
