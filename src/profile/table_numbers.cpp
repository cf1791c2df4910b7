#include "profile/table_numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "core/words.h"

namespace runout {
namespace {

constexpr std::size_t longest_number = 60;
constexpr std::string_view hard_blank = "\xC2\xA0";

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::size_t digits_at(std::string_view text, std::size_t begin) {
    std::size_t end = begin;
    while (end < text.size() && is_digit(text[end])) ++end;
    return end - begin;
}

/// "1'234" has one thousands mark of length 1 at 1; 0 where none stands.
std::size_t thousands_mark_length(std::string_view text, std::size_t at, char other_mark) {
    if (at >= text.size()) return 0;
    const std::string_view rest = text.substr(at);
    if (rest.starts_with(hard_blank)) return 2;
    return rest.front() == other_mark || rest.front() == ' ' || rest.front() == '\'' ? 1 : 0;
}

/// Writes the number as std::from_chars wants it. False: it is none.
bool rewrite(std::string_view cell, char mark, std::string& plain) {
    if (cell.empty() || cell.size() > longest_number) return false;
    const char other = mark == '.' ? ',' : '.';
    std::size_t at = 0;
    if (cell[at] == '-' || cell[at] == '+') {
        if (cell[at] == '-') plain += '-';
        ++at;
    }
    const std::size_t leading = digits_at(cell, at);
    plain += cell.substr(at, leading);
    const bool may_group = leading >= 1 && leading <= 3 && cell[at] != '0';
    at += leading;
    for (std::string_view first; may_group;) {
        const std::size_t length = thousands_mark_length(cell, at, other);
        if (length == 0 || digits_at(cell, at + length) != 3) break;
        if (!first.empty() && cell.substr(at, length) != first) return false;
        first = cell.substr(at, length);
        plain += cell.substr(at + length, 3);
        at += length + 3;
    }
    if (at < cell.size() && cell[at] == mark) {
        const std::size_t decimals = digits_at(cell, at + 1);
        if (decimals == 0 && (leading == 0 || mark == ',')) return false;
        plain += '.';
        plain += cell.substr(at + 1, decimals);
        at += 1 + decimals;
    } else if (leading == 0) {
        return false;
    }
    if (at < cell.size() && (cell[at] == 'e' || cell[at] == 'E')) {
        plain += 'e';
        ++at;
        if (at < cell.size() && (cell[at] == '-' || cell[at] == '+')) plain += cell[at++] == '-' ? "-" : "";
        const std::size_t digits = digits_at(cell, at);
        if (digits == 0) return false;
        plain += cell.substr(at, digits);
        at += digits;
    }
    return at == cell.size();
}

bool is_number(std::string_view cell, char mark) {
    std::string ignored;
    return rewrite(cell, mark, ignored);
}

/// What may stand before a station: Km, Sta, and the letters of railway lines.
std::string_view without_station_word(std::string_view cell) {
    std::size_t end = 0;
    while (end < cell.size() && !is_digit(cell[end]) && cell[end] != '-' && cell[end] != '+') ++end;
    std::string word = lower_case(cell.substr(0, end));
    std::erase_if(word, [](char c) { return c == ' ' || c == '.' || c == ':'; });
    constexpr std::array<std::string_view, 8> known = {"sta", "stn", "station", "ch", "km", "k", "dk", "pk"};
    return word.empty() || std::ranges::find(known, word) != known.end() ? cell.substr(end)
                                                                         : std::string_view{};
}

}  // namespace

MarkEvidence mark_evidence(std::string_view cell) {
    const bool point = is_number(cell, '.');
    const bool comma = is_number(cell, ',');
    if (!point && !comma) return MarkEvidence::no_number;
    if (point && comma) {
        if (cell.find('.') != std::string_view::npos) return MarkEvidence::point_or_thousands;
        return cell.find(',') != std::string_view::npos ? MarkEvidence::comma_or_thousands
                                                        : MarkEvidence::none;
    }
    return point ? MarkEvidence::point : MarkEvidence::comma;
}

bool proves_thousands(std::string_view cell) {
    const MarkEvidence evidence = mark_evidence(cell);
    if (evidence == MarkEvidence::point) return cell.find(',') != std::string_view::npos;
    return evidence == MarkEvidence::comma && cell.find('.') != std::string_view::npos;
}

std::optional<double> number_of(std::string_view cell, DecimalMark mark) {
    std::string plain;
    if (!rewrite(cell, mark == DecimalMark::point ? '.' : ',', plain)) return std::nullopt;
    double value = 0;
    const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
    if (error != std::errc{} || end != plain.data() + plain.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::optional<StationText> station_text(std::string_view cell) {
    const std::size_t plus = cell.rfind('+');
    if (plus == std::string_view::npos || plus == 0) return std::nullopt;
    StationText station;
    std::string_view before = trimmed(without_station_word(cell.substr(0, plus)), " ");
    if (before.starts_with('-')) {
        station.sign = before.substr(0, 1);
        before = trimmed(before.substr(1), " ");
    }
    station.before = before;
    station.after = trimmed(cell.substr(plus + 1), " ");
    const std::size_t digits = digits_at(station.after, 0);
    const bool whole = digits == station.after.size();
    const bool decimal = !whole && (station.after[digits] == '.' || station.after[digits] == ',') &&
                         digits + 1 + digits_at(station.after, digits + 1) == station.after.size();
    if (before.empty() || before.size() > 6 || digits_at(before, 0) != before.size() ||
        (digits != 2 && digits != 3) || (!whole && !decimal))
        return std::nullopt;
    station.digits_after = static_cast<int>(digits);
    return station;
}

bool says_nothing(std::string_view cell) {
    if (cell.empty() || cell.front() == '#') return true;
    if (cell.size() > 12) return false;
    if (cell.find_first_not_of("-*?/. ") == std::string_view::npos) return true;
    constexpr std::array<std::string_view, 20> words = {
        "nan",    "-nan",   "+nan",    "null", "none",    "na",  "n/a",  "nd",   "n.d.",     "nil",
        "<null>", "nodata", "no data", "k.a.", "missing", "inf", "-inf", "+inf", "infinity", "void"};
    return std::ranges::find(words, lower_case(cell)) != words.end();
}

bool is_nodata_number(double value) {
    constexpr std::array marks = {-999.0,   -999.9,    -999.99,  -999.25, -9999.0,
                                  -99999.0, -999999.0, -32767.0, -32768.0};
    return std::abs(value) >= 1e10 || std::ranges::find(marks, value) != marks.end();
}

}  // namespace runout
