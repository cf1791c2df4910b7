#pragma once

#include <string>
#include <vector>

#include "program/command_line.h"
#include "scene/case_spec.h"

namespace runout {

/// One key given on the command line.
struct Override {
    std::string option;  ///< "--friction-angle" or "--set"
    std::string key;
    std::string text;
};

/// FILE and everything that changes it.
struct CaseArguments {
    std::string file;
    std::vector<Override> overrides;
};

/// Declares FILE, `--set` and an option for each of the keys that are used most. The FILE can be described
/// further: it is not required yet.
CommandOption add_case_arguments(Command& command, CaseArguments& arguments);

/// Declares `--set` alone.
void add_set_option(Command& command, CaseArguments& arguments);

/// The case with the command line's keys in place. Throws InputError.
CaseSpec case_from(const CaseArguments& arguments);

/// Says on standard error how the section's file was understood, where it left a choice.
void log_reading(const Profile& profile);

/// Says on standard error what had to be assumed.
void log_assumptions(const std::vector<std::string>& assumed);

}  // namespace runout
