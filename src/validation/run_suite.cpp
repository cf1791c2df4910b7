#include "validation/run_suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "measures/run.h"
#include "scene/case_file.h"
#include "scene/scene.h"

namespace runout {
namespace {

/// A run that is not stored yet.
struct Job {
    std::string name;
    Scene scene;
    double expected_work = 0;
};

double expected_work(const Scene& scene) {
    const double spacing = scene.run.particle_spacing > 0
                               ? scene.run.particle_spacing
                               : std::sqrt(scene.source.area) / scene.run.resolution;
    const double side = std::sqrt(scene.source.area) / spacing;
    const double layers = scene.effects.release ? scene.effects.release->layers : 1.0;
    return side * side * side * std::max(1.0, layers);  // particles, times steps that grow as 1/spacing
}

Scene scene_of(const PlannedRun& run, const std::string& folder, const std::string& name) {
    CaseSpec spec = read_case(folder + "/" + run.file);
    const std::string place = "validation of " + name;
    for (const auto& [key, text] : run.set) {
        // A section is named from the case's own folder, as in the case file.
        const bool section = key == "section.file";
        const auto base = std::filesystem::path(spec.file).parent_path();
        override_value(spec, key, section ? (base / text).lexically_normal().string() : text, place);
    }
    spec.name = name;
    Scene scene = make_scene(spec);
    scene.run.threads = 1;
    return scene;
}

/// Runs of several cases, each scenario once: a coarse lattice of one ensemble may be a fine one of another.
class WorkList {
  public:
    /// Adds the runs of one case that the store lacks.
    void plan(const std::string& case_name, const std::vector<PlannedRun>& runs, const Store& store,
              const SuiteOptions& options) {
        for (const PlannedRun& run : runs) {
            const std::string name = fmt::format("{}/{}", case_name, run.id);
            add(case_name, run.id, name, scene_of(run, options.cases_folder, name), store);
        }
    }

    /// The longest first.
    [[nodiscard]] const std::vector<Job>& jobs() {
        std::ranges::stable_sort(jobs_, std::greater<>{}, &Job::expected_work);
        return jobs_;
    }

    [[nodiscard]] CaseRuns runs_of(const std::string& case_name, const Store& store) const {
        std::vector<std::pair<std::string, long>> ids;
        const auto planned = planned_.find(case_name);
        if (planned == planned_.end()) return {store, ids};
        for (const auto& [id, hash] : planned->second) ids.emplace_back(id, store.find_run(hash).value());
        return {store, ids};
    }

    [[nodiscard]] std::vector<long> ids_of(const std::string& case_name, const Store& store) const {
        std::vector<long> ids;
        for (const auto& [id, hash] : planned_.at(case_name)) ids.push_back(store.find_run(hash).value());
        return ids;
    }

  private:
    void add(const std::string& case_name, const std::string& id, const std::string& name, Scene scene,
             const Store& store) {
        const std::string hash = scenario_hash(scene);
        planned_[case_name].emplace_back(id, hash);
        if (!hashes_.insert(hash).second || store.find_run(hash)) return;
        const double work = expected_work(scene);
        jobs_.push_back({name, std::move(scene), work});
    }

    std::vector<Job> jobs_;
    std::set<std::string> hashes_;
    std::map<std::string, std::vector<std::pair<std::string, std::string>>> planned_;
};

/// Takes jobs in turn until none is left, one fails or the user stops it.
class Workers {
  public:
    Workers(const std::vector<Job>& jobs, Store& store, const SuiteOptions& options)
        : jobs_(jobs), store_(store), options_(options) {}

    void run() {
        std::vector<std::thread> threads;
        const int count = std::clamp(options_.jobs, 1, std::max(1, static_cast<int>(jobs_.size())));
        for (int k = 0; k < count; ++k) threads.emplace_back([this] { work(); });
        for (std::thread& thread : threads) thread.join();
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    [[nodiscard]] bool stopped() const {
        return failed_.load() || (options_.interrupt != nullptr && options_.interrupt->load());
    }

    void work() {
        for (std::size_t k = next_++; k < jobs_.size() && !stopped(); k = next_++) {
            try {
                simulate(jobs_[k]);
            } catch (...) {
                const std::scoped_lock lock(mutex_);
                failure_ = std::current_exception();
                failed_ = true;
            }
        }
    }

    void simulate(const Job& job) {
        RunControl control;
        control.interrupt = options_.interrupt;
        const RunResult result = run_scene(job.scene, control);
        if (result.status == RunStatus::interrupted) return;
        const std::scoped_lock lock(mutex_);
        store_.add(job.scene, result);
        ++done_;
        if (options_.on_run) options_.on_run(done_, static_cast<int>(jobs_.size()), job.name);
    }

    const std::vector<Job>& jobs_;
    Store& store_;
    const SuiteOptions& options_;
    std::atomic<std::size_t> next_{0};
    std::atomic<bool> failed_{false};
    std::mutex mutex_;
    int done_ = 0;
    std::exception_ptr failure_;
};

}  // namespace

std::vector<CaseReport> run_suite(std::span<const ValidationCase> cases, Store& store,
                                  const SuiteOptions& options) {
    WorkList list;
    for (const ValidationCase& item : cases) list.plan(item.name, item.plan(options.quick), store, options);
    Workers(list.jobs(), store, options).run();
    if (options.interrupt != nullptr && options.interrupt->load()) return {};
    std::vector<CaseReport> reports;
    for (const ValidationCase& item : cases) {
        reports.push_back(item.evaluate(list.runs_of(item.name, store),
                                        options.cases_folder + "/" + item.name, options.quick));
    }
    return reports;
}

std::vector<long> run_planned(const std::string& name, const std::vector<PlannedRun>& runs, Store& store,
                              const SuiteOptions& options) {
    WorkList list;
    list.plan(name, runs, store, options);
    Workers(list.jobs(), store, options).run();
    if (options.interrupt != nullptr && options.interrupt->load()) return {};
    return list.ids_of(name, store);
}

}  // namespace runout
