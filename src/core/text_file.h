#pragma once

#include <cstddef>
#include <string>

namespace runout {

/// A longer file is no table that a person made, and is refused before it fills the memory.
constexpr std::size_t longest_text_bytes = std::size_t{128} << 20U;

/// All bytes of a regular file. Throws InputError: a path with a zero byte, no file, a folder, a pipe or
/// device (which may never end), no permission, an error while reading, more than longest_text_bytes. `valid`
/// says what to give instead.
std::string read_text_file(const std::string& path, const std::string& valid);

}  // namespace runout
