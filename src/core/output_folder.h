#pragma once

#include <string>

namespace runout {

/// Makes a folder for outputs, with those above it, if it does not exist. Throws InputError, naming `option`.
void make_output_folder(const std::string& path, const std::string& option);

}  // namespace runout
