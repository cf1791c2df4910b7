#include "core/input_error.h"

#include <fmt/format.h>

namespace runout {
namespace {

/// What a user gave may hold anything; a message is one line of text, and no zero byte ends it early.
std::string printable(const std::string& text) {
    std::string shown;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        shown += byte < 0x20 || byte == 0x7F ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
    }
    return shown;
}

std::string sentence(const InputPlace& place, const std::string& problem, const std::string& valid) {
    std::string text = place.file;
    if (place.line > 0) text += fmt::format("{}line {}", text.empty() ? "" : ", ", place.line);
    if (!place.key.empty()) text += fmt::format("{}{}", text.empty() ? "" : ": ", place.key);
    if (!place.value.empty()) text += fmt::format(" = {}", place.value);
    if (!text.empty()) text += ": ";
    text += problem;
    if (!valid.empty()) text += "; " + valid;
    return printable(text);
}

}  // namespace

InputError::InputError(const InputPlace& place, const std::string& problem, const std::string& valid)
    : std::runtime_error(sentence(place, problem, valid)) {}

}  // namespace runout
