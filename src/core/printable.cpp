#include "core/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace runout {
namespace {

constexpr char32_t no_character = 0xFFFFFFFF;
constexpr std::size_t longest_file_name = 100;  // leaves room for endings; the usual limit is 255

/// One character, or one byte that is no part of any.
struct Letter {
    char32_t code = no_character;
    std::string_view bytes;
};

/// The first letter of a text that is not empty.
Letter first_letter(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return {lead, text.substr(0, 1)};
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    const Letter stray{no_character, text.substr(0, 1)};
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return stray;
    char32_t code = lead & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) return stray;
        code = (code << 6U) | (byte(i) & 0x3FU);
    }
    constexpr std::array<char32_t, 5> least = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < least[length] || surrogate || code > 0x10FFFF) return stray;
    return {code, text.substr(0, length)};
}

bool is_harmless(char32_t code) {
    constexpr std::array<std::pair<char32_t, char32_t>, 12> harmful = {{{0x0000, 0x001F},
                                                                        {0x007F, 0x009F},
                                                                        {0x00AD, 0x00AD},
                                                                        {0x061C, 0x061C},
                                                                        {0x200B, 0x200B},
                                                                        {0x200E, 0x200F},
                                                                        {0x2028, 0x202E},
                                                                        {0x2060, 0x2064},
                                                                        {0x2066, 0x2069},
                                                                        {0xFEFF, 0xFEFF},
                                                                        {0xE0000, 0xE007F},
                                                                        {no_character, no_character}}};
    return std::ranges::none_of(
        harmful, [&](const auto& range) { return code >= range.first && code <= range.second; });
}

std::string shown(std::string_view bytes) {
    std::string text;
    for (const char c : bytes) text += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    return text;
}

std::string json_escape(char32_t code) {
    if (code == no_character) return "\\ufffd";
    const auto number = static_cast<unsigned>(code);
    if (number < 0x10000) return fmt::format("\\u{:04x}", number);
    const unsigned above = number - 0x10000;
    return fmt::format("\\u{:04x}\\u{:04x}", 0xD800 + (above >> 10U), 0xDC00 + (above & 0x3FFU));
}

/// `text` with each letter that is not harmless as `replace` has it.
template <class Replace>
std::string replaced(std::string_view text, const Replace& replace) {
    std::string result;
    while (!text.empty()) {
        const Letter letter = first_letter(text);
        result += is_harmless(letter.code) ? std::string(letter.bytes) : replace(letter);
        text.remove_prefix(letter.bytes.size());
    }
    return result;
}

}  // namespace

std::string printable(std::string_view text) {
    return replaced(text, [](const Letter& letter) { return shown(letter.bytes); });
}

std::string printable_lines(std::string_view text) {
    return replaced(text, [](const Letter& letter) {
        return letter.code == '\n' ? std::string("\n") : shown(letter.bytes);
    });
}

std::string printable_json(std::string_view json) {
    // Newlines and tabs of a valid text stand between its values only.
    return replaced(json, [](const Letter& letter) {
        const bool between = letter.code == '\n' || letter.code == '\t' || letter.code == '\r';
        return between ? std::string(letter.bytes) : json_escape(letter.code);
    });
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const Letter letter = first_letter(text);
        if (letter.code == no_character) return false;
        text.remove_prefix(letter.bytes.size());
    }
    return true;
}

std::string file_name_part(std::string_view name) {
    constexpr std::string_view refused_somewhere = "/\\:*?\"<>|";
    std::string part;
    while (!name.empty()) {
        const Letter letter = first_letter(name);
        const bool stays =
            is_harmless(letter.code) && refused_somewhere.find(name[0]) == std::string_view::npos;
        const std::string next = stays ? std::string(letter.bytes) : "_";
        if (part.size() + next.size() > longest_file_name) break;
        part += next;
        name.remove_prefix(letter.bytes.size());
    }
    if (part.empty()) return "_";
    constexpr std::string_view not_first = ".-~ ", not_last = ". ";
    if (not_first.find(part.front()) != std::string_view::npos) part.front() = '_';
    if (not_last.find(part.back()) != std::string_view::npos) part.back() = '_';
    return part;
}

std::vector<std::string> distinct_file_names(const std::vector<std::string>& names) {
    std::set<std::string> taken;
    const auto take = [&](std::string name) {
        std::ranges::transform(name, name.begin(),
                               [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; });
        return taken.insert(name).second;
    };
    std::vector<std::string> parts;
    for (const std::string& name : names) {
        const std::string first = file_name_part(name);
        std::string part = first;
        for (int number = 2; !take(part); ++number) part = fmt::format("{}-{}", first, number);
        parts.push_back(part);
    }
    return parts;
}

}  // namespace runout
