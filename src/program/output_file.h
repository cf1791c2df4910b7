#pragma once

#include <string>

namespace runout {

/// Throws InputError, naming `option`, when `path` cannot be a new or replaced file: found out before the
/// work.
void check_output_place(const std::string& path, const std::string& option);

/// Writes `text` to `path`, whole or not at all. Throws InputError, naming `option`.
void write_output_file(const std::string& path, const std::string& option, const std::string& text);

}  // namespace runout
