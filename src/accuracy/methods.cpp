#include "accuracy/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

namespace runout {
namespace {

constexpr double patience = 3;  // times the simulated time of the scene's own settings
constexpr double finest_for_methods = 23;

MethodSetting number_setting(const char* key, double value, double resolution, double RunSettings::*member) {
    return {key, fmt::format("{:g}", value), resolution, [=](RunSettings& run) { run.*member = value; }};
}

void add_threads(std::vector<MethodSetting>& settings, double resolution) {
    const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    for (int threads = 1; threads <= cores; threads *= 2)
        settings.push_back({"run.threads", std::to_string(threads), resolution,
                            [=](RunSettings& run) { run.threads = threads; }});
}

/// Errors of single runs against the reference.
MethodPoint point_of(const std::string& series, const std::string& setting, double resolution,
                     const std::vector<StoredRun>& runs, const Reference& reference) {
    MethodPoint point{series, setting, resolution, 0, 0, 0, std::numeric_limits<double>::quiet_NaN(), {}};
    double squares = 0;
    int results = 0;
    const double count = static_cast<double>(runs.size());
    for (const StoredRun& run : runs) {
        point.cpu_s += run.work.cpu_s / count;
        point.wall_s += run.work.wall_s / count;
        if (!is_result(run.status)) {
            point.failure = std::string(to_string(run.status));
            if (!run.status_detail.empty()) point.failure += ": " + run.status_detail;
            continue;
        }
        ++results;
        point.run_out_m += run.measures.run_out_m;
        squares += std::pow(run.measures.run_out_m - reference.run_out_m, 2);
    }
    if (results == 0) return point;
    point.run_out_m /= results;
    if (point.failure.empty()) point.error = std::sqrt(squares / results) / reference.scale_m;
    return point;
}

/// The longest that a run of the ladder simulated near this resolution.
double usual_simulated_time(const Ladder& ladder, const Store& store, double resolution) {
    double time = 0, nearest = std::numeric_limits<double>::infinity();
    for (const LadderRun& entry : ladder.runs) {
        if (entry.series != "spacing") continue;
        const double distance = std::abs(std::log(entry.resolution / resolution));
        if (distance > nearest) continue;
        if (distance < nearest) time = 0;
        nearest = distance;
        time = std::max(time, store.run(entry.run_id).work.simulated_s);
    }
    return time;
}

}  // namespace

std::vector<MethodSetting> method_settings(double resolution) {
    std::vector<MethodSetting> settings;
    for (const double courant : {0.05, 0.1, 0.15, 0.3, 0.4})
        settings.push_back(number_setting("run.courant", courant, resolution, &RunSettings::courant));
    for (const int count : {1, 2, 10, 20})
        settings.push_back({"run.friction_iterations", std::to_string(count), resolution,
                            [=](RunSettings& run) { run.friction_iterations = count; }});
    for (const double tolerance : {0.1, 0.03, 1e-3, 1e-5})
        settings.push_back(number_setting("run.pressure_tolerance", tolerance, resolution,
                                          &RunSettings::pressure_tolerance));
    for (const double ratio : {1.15, 1.5, 1.8})
        settings.push_back(
            number_setting("run.smoothing_ratio", ratio, resolution, &RunSettings::smoothing_ratio));
    for (int index = 0; rung_resolution(index) <= resolution; ++index)
        settings.push_back({"run.friction", fmt::format("explicit at {:g}", rung_resolution(index)),
                            rung_resolution(index),
                            [](RunSettings& run) { run.friction = FrictionScheme::explicit_; }});
    add_threads(settings, resolution);
    return settings;
}

std::vector<MethodPoint> compare_methods(const Scene& scene, Ladder& ladder, Store& store,
                                         const MethodOptions& options) {
    const Reference reference = reference_of(ladder);
    double resolution = rung_resolution(0);
    for (const RungSummary& rung : ladder.rungs)
        if (rung.results > 0 && rung.resolution <= finest_for_methods) resolution = rung.resolution;
    std::vector<MethodPoint> points;
    for (const MethodSetting& setting : method_settings(resolution)) {
        std::vector<StoredRun> runs;
        for (int lattice = 0; lattice < options.lattices; ++lattice) {
            if (options.interrupt != nullptr && options.interrupt->load()) return points;
            Scene other = with_resolution(scene, setting.resolution, lattice);
            other.run.time_limit = patience * usual_simulated_time(ladder, store, setting.resolution);
            setting.apply(other.run);
            const bool threads = setting.series == "run.threads";
            // Threads do not change the result, so the store would give back the run of another number of
            // them.
            const StoredRun run = threads ? run_and_store(other, store, options.interrupt)
                                          : find_or_run(other, store, options.interrupt);
            if (run.status == RunStatus::interrupted) return points;
            runs.push_back(run);
            ladder.runs.push_back({setting.series, setting.setting, setting.resolution, run.run_id});
        }
        points.push_back(point_of(setting.series, setting.setting, setting.resolution, runs, reference));
        if (options.on_point) options.on_point(points.back());
    }
    return points;
}

std::vector<MethodPoint> read_methods(const StoredLadder& stored, const Ladder& ladder, const Store& store) {
    const Reference reference = reference_of(ladder);
    std::vector<MethodPoint> points;
    for (std::size_t i = 0; i < stored.runs.size();) {
        const LadderRun& first = stored.runs[i];
        std::vector<StoredRun> runs;
        for (; i < stored.runs.size() && stored.runs[i].series == first.series &&
               stored.runs[i].setting == first.setting;
             ++i)
            runs.push_back(store.run(stored.runs[i].run_id));
        points.push_back(point_of(first.series, first.setting, first.resolution, runs, reference));
    }
    return points;
}

}  // namespace runout
