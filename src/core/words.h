#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

namespace runout {

/// Without the blanks at both ends.
inline std::string_view trimmed(std::string_view text, std::string_view blanks = " \t\r") {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

/// Latin letters in lower case, whatever the locale; all else as it is.
inline std::string lower_case(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return lower;
}

/// ".dxf" of "cut/Section.DXF"; empty where the name has no ending.
inline std::string lower_ending(const std::string& path) {
    return lower_case(std::filesystem::path(path).extension().string());
}

}  // namespace runout
