#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace runout {

// What the shell gets to see.
namespace exit_code {
constexpr int success = 0;         ///< settled or stable, or nothing to run
constexpr int not_a_result = 1;    ///< the run ended by a limit or a failure of the method
constexpr int input_error = 2;     ///< nothing was written
constexpr int internal_error = 3;  ///< a defect of the program or of the machine
constexpr int stored_elsewhere =
    4;  ///< the run has ended, and its database could not take it: a side database did
constexpr int interrupted = 130;  ///< Ctrl-C; the run is stored as such
}  // namespace exit_code

/// The work of the subcommand that was named: set while the command line is parsed, called once after it.
/// Returns the exit code, throws InputError.
using Command = std::function<int()>;

// Each declares one subcommand with its options, and sets `command` when it is the one that was named.
void add_run_command(CLI::App& app, Command& command);
void add_new_command(CLI::App& app, Command& command);
void add_profile_command(CLI::App& app, Command& command);
void add_map_command(CLI::App& app, Command& command);
void add_source_command(CLI::App& app, Command& command);
void add_effects_command(CLI::App& app, Command& command);
void add_accuracy_command(CLI::App& app, Command& command);
void add_sweep_command(CLI::App& app, Command& command);
void add_merge_command(CLI::App& app, Command& command);
void add_delete_command(CLI::App& app, Command& command);
void add_table_command(CLI::App& app, Command& command);
void add_estimate_command(CLI::App& app, Command& command);
void add_report_command(CLI::App& app, Command& command);
void add_compare_command(CLI::App& app, Command& command);
void add_export_command(CLI::App& app, Command& command);
void add_back_analysis_command(CLI::App& app, Command& command);
void add_validate_command(CLI::App& app, Command& command);
void add_stress_command(CLI::App& app, Command& command);
void add_help_command(CLI::App& app, Command& command);

}  // namespace runout
