#pragma once

#include <string>

namespace runout {

enum class Folder { exists, may_be_made };

/// Throws InputError, naming `option`, when `path` cannot be a new or replaced file in an existing folder, or
/// in one that may be made: found out before the work.
void check_output_place(const std::string& path, const std::string& option, Folder wanted = Folder::exists);

/// Writes `text` to `path`, whole or not at all. Throws InputError, naming `option`.
void write_output_file(const std::string& path, const std::string& option, const std::string& text);

}  // namespace runout
