#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "store/store.h"

namespace runout {

/// What has become of one job of a queue.
struct QueueEvent {
    std::size_t job = 0;
    std::optional<long> run_id;  ///< none: refused
    std::string scenario_hash;
    std::string refusal;     ///< why there is no scene; empty when there is one
    bool simulated = false;  ///< false: the store had it already, or it was refused
    RunStatus status = RunStatus::running;
};

/// Jobs that are simulated side by side, each on one thread.
struct RunQueue {
    std::size_t first = 0, stride = 1, count = 0;  ///< jobs first, first + stride, ... below count
    /// The scene of a job. An InputError refuses the job where `refuses`, and ends the queue otherwise. Never
    /// called twice at once.
    std::function<Scene(std::size_t job)> scene;
    bool refuses = false;
    bool series = true;  ///< store series and times too, and not only measures and deposit
    int workers = 1;
    /// Called for each job, never twice at once.
    std::function<void(const QueueEvent&)> on_event;
    const std::atomic<bool>* interrupt = nullptr;  ///< set to true to stop; what has ended is stored
};

/// Runs what `store` lacks, in the order of the jobs, and stores each run as it ends: a program that is
/// killed loses only what it was at. While another program holds the store, a run that has ended waits as the
/// store was told (Store::set_on_wait). Of jobs with one scenario the first is simulated. Throws what a scene
/// threw first.
void run_queue(const RunQueue& queue, Store& store);

}  // namespace runout
