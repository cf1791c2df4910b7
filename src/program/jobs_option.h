#pragma once

#include <CLI/CLI.hpp>

namespace runout {

/// As many runs at a time as there are cores; at least one.
int default_jobs();

/// `-j, --jobs`: how many runs go on at a time, each on one thread.
void add_jobs_option(CLI::App& command, int& jobs);

}  // namespace runout
