#pragma once

#include <optional>
#include <string>

#include "program/command_line.h"
#include "store/store.h"

namespace runout {

/// A database and one of its runs.
struct RunChoice {
    std::string database;
    std::optional<long> run_id;
};

/// Declares DB and --run.
void add_run_choice(Command& command, RunChoice& choice);

/// Declares --width; `width` stays as it is when it is not given.
void add_width_option(Command& command, double& width);

/// The run that was named, or else the last one that is a result, or else the last one. Throws InputError
/// when there are none.
long chosen_run(const Store& store, const RunChoice& choice);

}  // namespace runout
