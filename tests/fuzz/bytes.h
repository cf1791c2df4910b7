#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>

#include "core/input_error.h"

namespace runout::fuzz {

/// Aborts, which a fuzzer takes for a finding, where a promise does not hold.
void require(bool holds, const char* promise);

/// Path of a file of this process that holds the bytes: the readers take a path.
std::string written(std::span<const std::uint8_t> bytes, const char* extension);

/// Bad input ends with a sentence; any other exception is a finding.
template <class Action>
void accept_input_error(const Action& action) {
    try {
        action();
    } catch (const InputError& error) {
        require(std::strlen(error.what()) > 20, "an InputError is a sentence");
    }
}

/// Numbers and texts from bytes, zeros when they run out.
class Numbers {
  public:
    explicit Numbers(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    [[nodiscard]] bool empty() const { return at_ >= bytes_.size(); }
    std::uint8_t byte() { return empty() ? std::uint8_t{0} : bytes_[at_++]; }
    /// Most are short decimals, as in a section; some are any double.
    double number();
    double size();
    /// Up to 255 bytes.
    std::string text();

  private:
    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

}  // namespace runout::fuzz
