#include "validation/run_suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "scene/case_file.h"
#include "scene/scene.h"
#include "study/run_queue.h"

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

/// Simulates the jobs side by side and stores each as it ends.
void simulate(const std::vector<Job>& jobs, Store& store, const SuiteOptions& options) {
    RunQueue queue;
    queue.count = jobs.size();
    queue.scene = [&](std::size_t k) { return jobs[k].scene; };
    queue.workers = std::min(options.jobs, std::max(1, static_cast<int>(jobs.size())));
    queue.interrupt = options.interrupt;
    int done = 0;
    queue.on_event = [&](const QueueEvent& event) {
        ++done;
        if (options.on_run) options.on_run(done, static_cast<int>(jobs.size()), jobs[event.job].name);
    };
    run_queue(queue, store);
}

}  // namespace

std::vector<CaseReport> run_suite(std::span<const ValidationCase> cases, Store& store,
                                  const SuiteOptions& options) {
    WorkList list;
    for (const ValidationCase& item : cases) list.plan(item.name, item.plan(options.quick), store, options);
    simulate(list.jobs(), store, options);
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
    simulate(list.jobs(), store, options);
    if (options.interrupt != nullptr && options.interrupt->load()) return {};
    return list.ids_of(name, store);
}

}  // namespace runout
