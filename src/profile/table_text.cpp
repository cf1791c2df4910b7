#include "profile/table_text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "core/input_error.h"

namespace runout {
namespace {

constexpr const char* save_as_text = "save the section as text: CSV in UTF-8";

void append_utf8(std::string& text, std::uint32_t code) {
    const auto byte = [&text](std::uint32_t value) { text += static_cast<char>(value); };
    if (code < 0x80) {
        byte(code);
    } else if (code < 0x800) {
        byte(0xC0 | (code >> 6));
        byte(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        byte(0xE0 | (code >> 12));
        byte(0x80 | ((code >> 6) & 0x3F));
        byte(0x80 | (code & 0x3F));
    } else {
        byte(0xF0 | (code >> 18));
        byte(0x80 | ((code >> 12) & 0x3F));
        byte(0x80 | ((code >> 6) & 0x3F));
        byte(0x80 | (code & 0x3F));
    }
}

/// What is written in many ways becomes one; 0 for a mark that nobody sees.
std::uint32_t plain(std::uint32_t code) {
    if (code < 0x80) return code;
    if (code == 0x2212 || (code >= 0x2010 && code <= 0x2014) || code == 0xFE63 || code == 0xFF0D) return '-';
    if (code == 0x2018 || code == 0x2019 || code == 0x02BC) return '\'';
    if (code == 0x202F || (code >= 0x2000 && code <= 0x200A) || code == 0x3000) return 0xA0;
    if (code == 0xFEFF || (code >= 0x200B && code <= 0x200F) || code == 0x2060) return 0;
    return code == 0x2028 || code == 0x2029 || code == 0x85 ? '\n' : code;
}

void append(std::string& text, std::uint32_t code) {
    const std::uint32_t shown = plain(code);
    if (shown != 0) append_utf8(text, shown);
}

/// Code points of the bytes 0x80 to 0x9F; the others are their own.
constexpr std::array<std::uint16_t, 32> windows_1252 = {
    0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0x8D,   0x017D, 0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};

std::string from_windows_1252(std::string_view bytes) {
    std::string text;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        append(text, byte >= 0x80 && byte < 0xA0 ? windows_1252[byte - 0x80U] : byte);
    }
    return text;
}

/// Length of the UTF-8 sequence that begins with this byte; 0 for one that begins none.
std::size_t sequence_length(unsigned char lead) {
    if (lead < 0x80) return 1;
    if (lead >= 0xC2 && lead < 0xE0) return 2;
    if (lead >= 0xE0 && lead < 0xF0) return 3;
    return lead >= 0xF0 && lead < 0xF5 ? 4 : 0;
}

/// False: it is not UTF-8.
bool from_utf8(std::string_view bytes, std::string& text) {
    for (std::size_t i = 0; i < bytes.size();) {
        const auto lead = static_cast<unsigned char>(bytes[i]);
        const std::size_t length = sequence_length(lead);
        if (length == 0 || i + length > bytes.size()) return false;
        std::uint32_t code = length == 1 ? lead : lead & (0xFFU >> (length + 1));
        for (std::size_t k = 1; k < length; ++k) {
            const auto next = static_cast<unsigned char>(bytes[i + k]);
            if ((next & 0xC0U) != 0x80) return false;
            code = (code << 6U) | (next & 0x3FU);
        }
        append(text, code);
        i += length;
    }
    return true;
}

std::string from_utf16(std::string_view bytes, bool little_endian, const InputPlace& place) {
    if (bytes.size() % 2 != 0)
        throw InputError(place, "is UTF-16 with half a character at its end", save_as_text);
    std::string text;
    std::uint32_t high = 0;
    for (std::size_t i = 0; i < bytes.size(); i += 2) {
        const auto first = static_cast<unsigned char>(bytes[i]);
        const auto second = static_cast<unsigned char>(bytes[i + 1]);
        const std::uint32_t unit = little_endian ? first | (second << 8U) : second | (first << 8U);
        if (unit == 0) throw InputError(place, "holds a zero character, so it is no text", save_as_text);
        if (unit >= 0xD800 && unit < 0xDC00) {
            high = unit;
        } else if (unit >= 0xDC00 && unit < 0xE000) {
            append(text, high == 0 ? 0xFFFD : 0x10000 + ((high - 0xD800) << 10U) + (unit - 0xDC00));
            high = 0;
        } else {
            append(text, unit);
        }
    }
    return text;
}

/// UTF-16 without a mark is certain where each character of the beginning has one zero byte, always on the
/// same side.
bool zeros_at(std::string_view bytes, std::size_t side) {
    const std::string_view head = bytes.substr(0, std::min<std::size_t>(bytes.size(), 256));
    std::size_t zeros = 0;
    for (std::size_t i = side; i < head.size(); i += 2) zeros += head[i] == '\0' ? 1 : 0;
    const bool other_side = [&] {
        for (std::size_t i = 1 - side; i < head.size(); i += 2)
            if (head[i] == '\0') return true;
        return false;
    }();
    return head.size() >= 4 && !other_side && 10 * zeros >= 9 * (head.size() / 2);
}

void refuse_known_binary(std::string_view bytes, const InputPlace& place) {
    if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("\xD0\xCF\x11\xE0"))
        throw InputError(place, "is a workbook or an archive, and no text", save_as_text);
    if (bytes.starts_with("%PDF")) throw InputError(place, "is a PDF, and no text", save_as_text);
    if (bytes.find('\0') != std::string_view::npos)
        throw InputError(place, "holds a zero byte, so it is no text", save_as_text);
}

void unify_line_ends(std::string& text) {
    if (text.find('\r') == std::string::npos) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
        text[kept++] = text[i] == '\r' ? '\n' : text[i];
    }
    text.resize(kept);
}

bool is_ascii(std::string_view bytes) {
    return std::ranges::all_of(bytes, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

std::string decoded(std::string bytes, const InputPlace& place) {
    constexpr std::string_view marks_little_endian = "\xFF\xFE";
    constexpr std::string_view marks_big_endian = "\xFE\xFF";
    const std::string_view view = bytes;
    if (view.starts_with(marks_little_endian)) return from_utf16(view.substr(2), true, place);
    if (view.starts_with(marks_big_endian)) return from_utf16(view.substr(2), false, place);
    if (zeros_at(view, 1)) return from_utf16(view, true, place);
    if (zeros_at(view, 0)) return from_utf16(view, false, place);
    refuse_known_binary(view, place);
    if (is_ascii(view)) return bytes;
    std::string text;
    text.reserve(view.size());
    return from_utf8(view, text) ? text : from_windows_1252(view);
}

}  // namespace

std::string table_text(std::string bytes, const std::string& path) {
    std::string text = decoded(std::move(bytes), {path, 0, "", ""});
    unify_line_ends(text);
    return text;
}

}  // namespace runout
