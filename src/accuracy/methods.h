#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "accuracy/ladder.h"
#include "scene/scene.h"
#include "store/store.h"

namespace runout {

/// One setting of one knob of the method.
struct MethodSetting {
    std::string series;   ///< key of a case file: "run.courant"
    std::string setting;  ///< its value there
    double resolution = 0;
    std::function<void(RunSettings&)> apply;
};

/// The knobs that are turned one at a time while the others keep what the scene has: Courant number, friction
/// iterations, pressure tolerance, smoothing length and number of threads at `resolution`; the explicit
/// friction of the paper on all rungs up to it.
std::vector<MethodSetting> method_settings(double resolution);

/// What a setting costs, and how far one run with it is from the finest rung of the ladder.
struct MethodPoint {
    std::string series;
    std::string setting;
    double resolution = 0;
    double cpu_s = 0;  ///< of one run
    double wall_s = 0;
    double run_out_m = 0;  ///< mean over lattices
    double error =
        0;  ///< root mean square of (run-out of a run - reference), a share of the run-out; NaN: failed
    std::string failure;  ///< why it has no result; empty when it has
};

struct MethodOptions {
    int lattices = 2;
    std::function<void(const MethodPoint&)> on_point;
    const std::atomic<bool>* interrupt = nullptr;
};

/// Runs every setting, within three times the simulated time that the scene's own settings took: a setting
/// under which the mass does not come to rest by then has failed, which is said. Adds the runs to `ladder`.
std::vector<MethodPoint> compare_methods(const Scene& scene, Ladder& ladder, Store& store,
                                         const MethodOptions& options);

/// The points of a stored study: the ladder itself as series "spacing", then each setting.
std::vector<MethodPoint> read_methods(const StoredLadder& stored, const Ladder& ladder, const Store& store);

}  // namespace runout
