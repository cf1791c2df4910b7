#include "core/csv_cell.h"

#include <charconv>
#include <cmath>
#include <string_view>

#include "core/printable.h"

namespace runout {
namespace {

bool is_number(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
}

/// Spreadsheets pass over spaces before the sign. The wide forms of the signs count as the signs.
bool looks_like_formula(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) return false;
    const std::string_view rest = text.substr(first);
    for (const std::string_view sign : {"=", "+", "-", "@", "＝", "＋", "－", "＠"})
        if (rest.starts_with(sign)) return !is_number(rest);
    return false;
}

}  // namespace

std::string csv_cell(const std::string& text) {
    // What is shown in place of a tab or a line's end begins with a backslash, so that no formula follows
    // one.
    const std::string shown = printable(text);
    const bool formula = looks_like_formula(shown);
    const std::string safe = formula ? "'" + shown : shown;
    if (!formula && safe.find_first_of(",\"") == std::string::npos) return safe;
    std::string quoted = "\"";
    for (const char letter : safe) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
    return quoted + "\"";
}

}  // namespace runout
