#include "stress/run_stress.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>

#include "core/input_error.h"
#include "run/run_scene.h"
#include "scene/case_file.h"
#include "store/store.h"
#include "stress/stress_scene.h"

namespace runout {
namespace {

/// The settings of a run as a case file would give them.
RunSettings settings_for(RunSettings run, const StressOptions& options) {
    CaseSpec spec;
    spec.run = std::move(run);
    for (const auto& [key, value] : options.settings) {
        if (!key.starts_with("run."))
            throw InputError({.file = "--set", .line = 0, .key = key, .value = value},
                             "is not a key of a run", "give one that begins with run.");
        override_value(spec, key, value, "--set");
    }
    return spec.run;
}

std::optional<Scene> scene_or_refusal(StressOutcome& outcome, std::uint64_t seed) {
    try {
        return stress_scene(outcome.point, stress_name(seed, outcome.index));
    } catch (const InputError& error) {
        outcome.refusal = error.what();
        return std::nullopt;
    }
}

}  // namespace

std::string stress_name(std::uint64_t seed, int index) {
    return fmt::format("stress-{}-{}", seed, index);
}

bool is_sound(const StressOutcome& outcome) {
    if (!outcome.refusal.empty()) return true;
    if (!outcome.result) return false;
    const RunStatus status = outcome.result->status;
    return is_result(status) || status == RunStatus::not_a_body;
}

std::vector<StressOutcome> run_stress(const std::vector<StressPoint>& points, std::uint64_t seed,
                                      Store& store, const StressOptions& options) {
    settings_for({}, options);  // a mistake is found before the first run
    const int count = static_cast<int>(points.size());
    std::vector<StressOutcome> outcomes(points.size());
    std::atomic<int> next{0};
    std::mutex mutex;
    int done = 0;
    std::exception_ptr failure;
    const auto one = [&](int k) {
        StressOutcome& outcome = outcomes[k];
        outcome.index = k;
        outcome.point = points[k];
        if (options.only && *options.only != k) return;
        RunControl control;
        control.interrupt = options.interrupt;
        std::optional<Scene> scene = scene_or_refusal(outcome, seed);
        if (scene) scene->run = settings_for(scene->run, options);
        if (scene) outcome.result = run_scene(*scene, control);
        const std::scoped_lock lock(mutex);
        if (outcome.result) {
            store.add(*scene, *outcome.result);
            outcome.result->series.clear();  // stored; a thousand of them are much to carry
        }
        if (options.on_run) options.on_run(++done, count);
    };
    const auto work = [&] {
        const auto stopped = [&] { return options.interrupt != nullptr && options.interrupt->load(); };
        for (int k = next++; k < count && !stopped(); k = next++) {
            try {
                one(k);
            } catch (...) {
                const std::scoped_lock lock(mutex);
                failure = std::current_exception();
                next = count;
            }
        }
    };
    std::vector<std::thread> threads;
    for (int k = 0; k < std::clamp(options.jobs, 1, std::max(1, count)); ++k) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    if (failure) std::rethrow_exception(failure);
    return outcomes;
}

}  // namespace runout
