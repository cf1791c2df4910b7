#pragma once

#include <CLI/CLI.hpp>

#include "core/output_file.h"

namespace runout {

void add_overwrite_option(CLI::App& subcommand, OutputRules& rules);

}  // namespace runout
