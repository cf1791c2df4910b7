#pragma once

#include <string>
#include <vector>

#include "core/input_error.h"
#include "core/output_file.h"
#include "program/command_line.h"
#include "program/common_options.h"

namespace runout {

// Options that several commands have, with the same words.

/// A value on the command line, where a mistake is told of.
InputPlace option_place(const std::string& option, const std::string& value);

/// The positional DB: a database that is read.
void add_database_argument(Command& command, std::string& path);

/// `--db`: a database that takes runs and is asked first. The caller may put it into a group.
CommandOption add_database_option(Command& command, std::string& path);

/// As many runs at a time as there are cores; at least one.
int default_jobs();

/// `-j, --jobs`: how many runs go on at a time, each on one thread.
void add_jobs_option(Command& command, int& jobs);

/// `--intensity`: a class each, read by intensities_from.
CommandOption add_intensity_option(Command& command, std::vector<std::string>& classes);

/// `--overwrite`: files that the rules would spare may be replaced.
void add_overwrite_option(Command& command, OutputRules& rules);

}  // namespace runout
