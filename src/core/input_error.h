#pragma once

#include <stdexcept>
#include <string>

namespace runout {

/// Where a wrong input stands. Empty parts are left out of the sentence.
struct InputPlace {
    std::string file;
    int line = 0;       ///< 1-based; 0 = unknown
    std::string key;    ///< column, case-file key or option
    std::string value;  ///< as the user wrote it
};

/// A mistake in what the user gave, said as one sentence that names the place and what would be valid.
/// The program prints it and ends with exit code 2; nothing has been written.
class InputError : public std::runtime_error {
  public:
    /// `problem` completes the place ("is not a number"); `valid` says what would be accepted ("give metres,
    /// such as 12.5").
    InputError(const InputPlace& place, const std::string& problem, const std::string& valid);
};

}  // namespace runout
