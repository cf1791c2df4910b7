#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "store/store.h"

namespace runout {

/// A database and one of its runs.
struct RunChoice {
    std::string database;
    std::optional<long> run_id;
};

/// Declares DB and --run.
void add_run_choice(CLI::App& subcommand, RunChoice& choice);

/// Declares --width; `width` stays as it is when it is not given.
void add_width_option(CLI::App& subcommand, double& width);

/// The run that was named, or else the last one that is a result, or else the last one. Throws InputError
/// when there are none.
long chosen_run(const Store& store, const RunChoice& choice);

}  // namespace runout
