#include "program/answer.h"

#include <fmt/format.h>

#include "core/printable.h"

namespace runout {

void print_text(const std::string& text) {
    fmt::print("{}", printable_lines(text));
}

void print_json(const std::string& json) {
    fmt::print("{}", printable_json(json));
}

}  // namespace runout
