#include "study/run_queue.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "core/input_error.h"
#include "run/run_scene.h"
#include "store/database_in_use.h"

namespace runout {
namespace {

/// Takes jobs in turn until none is left, one fails or the user stops it.
class Workers {
  public:
    Workers(const RunQueue& queue, Store& store) : queue_(queue), store_(store), next_(queue.first) {}

    void run() {
        std::vector<std::thread> threads;
        for (int k = 0; k < std::max(1, queue_.workers); ++k) threads.emplace_back([this] { work(); });
        for (std::thread& thread : threads) thread.join();
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    [[nodiscard]] bool stopped() const {
        return failed_.load() || (queue_.interrupt != nullptr && queue_.interrupt->load());
    }

    void work() {
        while (!stopped()) {
            const std::size_t job = next_.fetch_add(queue_.stride);
            if (job >= queue_.count) return;
            try {
                take(job);
            } catch (...) {
                const std::scoped_lock lock(store_mutex_);
                if (!failed_) failure_ = std::current_exception();
                failed_ = true;
            }
        }
    }

    void take(std::size_t job) {
        QueueEvent event{.job = job, .run_id = {}, .scenario_hash = {}, .refusal = {}};
        const std::optional<Scene> scene = scene_of(job, event);
        if (!scene) {
            const std::scoped_lock lock(store_mutex_);
            tell(event);
            return;
        }
        event.scenario_hash = scenario_hash(*scene);
        if (!is_mine(event)) return;
        RunControl control;
        control.interrupt = queue_.interrupt;
        RunResult result = run_scene(*scene, control);
        if (result.status == RunStatus::interrupted) return;
        if (!queue_.series) {
            result.series.clear();
            result.phases.clear();
        }
        event.simulated = true;
        event.status = result.status;
        const std::scoped_lock lock(store_mutex_);
        event.run_id = stored(*scene, result);
        if (!event.run_id) return;
        tell(event);
    }

    /// Its id; none when the user stopped the waiting.
    std::optional<long> stored(const Scene& scene, const RunResult& result) {
        try {
            return store_.add(scene, result);
        } catch (const DatabaseInUse&) {
            if (stopped()) return std::nullopt;
            throw;
        }
    }

    std::optional<Scene> scene_of(std::size_t job, QueueEvent& event) {
        const std::scoped_lock lock(scene_mutex_);
        try {
            Scene scene = queue_.scene(job);
            scene.run.threads = 1;
            return scene;
        } catch (const InputError& error) {
            if (!queue_.refuses) throw;
            event.refusal = error.what();
            return std::nullopt;
        }
    }

    /// Whether this job has to be simulated: the store lacks it and no other worker is at it.
    bool is_mine(QueueEvent& event) {
        const std::scoped_lock lock(store_mutex_);
        const bool first = seen_.insert(event.scenario_hash).second;
        event.run_id = store_.find_run(event.scenario_hash);
        if (!event.run_id && first) return true;
        if (event.run_id) event.status = store_.run(*event.run_id).status;
        tell(event);
        return false;
    }

    void tell(const QueueEvent& event) {
        if (queue_.on_event) queue_.on_event(event);
    }

    const RunQueue& queue_;
    Store& store_;
    std::atomic<std::size_t> next_;
    std::atomic<bool> failed_{false};
    std::mutex scene_mutex_;
    std::mutex store_mutex_;
    std::set<std::string> seen_;
    std::exception_ptr failure_;
};

}  // namespace

void run_queue(const RunQueue& queue, Store& store) {
    Workers(queue, store).run();
}

}  // namespace runout
