#pragma once

#include <string>

namespace runout {

/// "0.2.0", the version of CMakeLists.txt.
std::string program_version();

/// Short git revision with "-dirty" when files differ from it; "unknown" outside a git checkout.
std::string program_revision();

/// Compiler and build type, such as "GNU 12.2.0 Release".
std::string compiler_description();

}  // namespace runout
