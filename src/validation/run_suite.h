#pragma once

#include <atomic>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "store/store.h"
#include "validation/case_runs.h"

namespace runout {

/// How the suite is to be run.
struct SuiteOptions {
    std::string cases_folder = "cases";
    bool quick = false;  ///< only the part that fits into a test
    int jobs = 1;        ///< runs at a time, each on one thread
    /// Called after each run, never twice at once: how many of how many have been simulated, and which.
    std::function<void(int done, int total, const std::string& name)> on_run;
    const std::atomic<bool>* interrupt = nullptr;  ///< set to true to stop; what has ended is stored
};

/// Simulates the runs of `cases` that `store` does not hold yet, the longest first, and stores each as it
/// ends; then says what the stored runs mean. Empty when interrupted. Throws InputError when a case cannot be
/// read.
std::vector<CaseReport> run_suite(std::span<const ValidationCase> cases, Store& store,
                                  const SuiteOptions& options);

/// Simulates planned runs that `store` does not hold yet and returns the ids of all, in their order; they are
/// named `name`/id. Files are relative to options.cases_folder. Empty when interrupted. Throws InputError as
/// run_suite.
std::vector<long> run_planned(const std::string& name, const std::vector<PlannedRun>& runs, Store& store,
                              const SuiteOptions& options);

}  // namespace runout
