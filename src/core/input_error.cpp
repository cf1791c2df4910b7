#include "core/input_error.h"

#include <fmt/format.h>

#include "core/printable.h"

namespace runout {
namespace {

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
