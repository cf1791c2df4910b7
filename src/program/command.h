#pragma once

#include "program/command_line.h"

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

// Each adds one command with its options.
void add_run_command(CommandLine& program);
void add_new_command(CommandLine& program);
void add_profile_command(CommandLine& program);
void add_map_command(CommandLine& program);
void add_source_command(CommandLine& program);
void add_effects_command(CommandLine& program);
void add_accuracy_command(CommandLine& program);
void add_sweep_command(CommandLine& program);
void add_merge_command(CommandLine& program);
void add_delete_command(CommandLine& program);
void add_table_command(CommandLine& program);
void add_at_command(CommandLine& program);
void add_barrier_command(CommandLine& program);
void add_estimate_command(CommandLine& program);
void add_report_command(CommandLine& program);
void add_compare_command(CommandLine& program);
void add_export_command(CommandLine& program);
void add_back_analysis_command(CommandLine& program);
void add_validate_command(CommandLine& program);
void add_stress_command(CommandLine& program);
void add_help_command(CommandLine& program);

}  // namespace runout
