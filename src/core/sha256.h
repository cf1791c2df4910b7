#pragma once

#include <string>
#include <string_view>

namespace runout {

/// SHA-256 of the bytes, as 64 hexadecimal digits.
std::string sha256_hex(std::string_view bytes);

/// The same of what a file holds; of nothing, where it cannot be read.
std::string sha256_of_file(const std::string& path);

}  // namespace runout
