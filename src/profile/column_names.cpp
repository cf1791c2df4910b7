#include "profile/column_names.h"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace runout {
namespace {

using Words = std::vector<std::string>;

constexpr LengthUnit metre = *length_unit("m");
constexpr LengthUnit foot = *length_unit("ft");
constexpr LengthUnit us_foot = *length_unit("us-ft");

/// Letters of U+00C0 to U+017F without their accents, in lower case.
constexpr std::string_view base_letters =
    "aaaaaaaceeeeiiiidnooooo*ouuuuytsaaaaaaaceeeeiiiidnooooo/ouuuuyty"
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkkllllllllllnnnnnnnnnoooooooorrrrrrsssssssstttttt"
    "uuuuu"
    "uuuuuuuwwyyyzzzzzzs";

bool is_letter_or_digit(unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c >= 0x80;
}

bool is_lower(char c) {
    return c >= 'a' && c <= 'z';
}
bool is_upper(char c) {
    return c >= 'A' && c <= 'Z';
}

/// Of the letters above: capitals have even or odd numbers, stretch by stretch.
bool is_capital(unsigned code) {
    if (code < 0x100) return code < 0xDF;
    const bool odd_are_capital = (code >= 0x139 && code <= 0x148) || (code >= 0x179 && code <= 0x17E);
    return code % 2 == (odd_are_capital ? 1U : 0U);
}

/// Accented Latin letters become plain ones; accents of their own vanish; other scripts stay.
std::string without_accents(std::string_view text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const unsigned next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
        const unsigned code = ((lead & 0x1FU) << 6U) | (next & 0x3FU);
        const bool of_two_bytes = lead >= 0xC2 && lead < 0xE0 && next != 0;
        if (!of_two_bytes) {
            plain += text[i];
            continue;
        }
        ++i;
        if (code >= 0xC0 && code < 0xC0 + base_letters.size()) {
            const char base = base_letters[code - 0xC0];
            plain += is_capital(code) && is_lower(base) ? static_cast<char>(base - 32) : base;
        } else if (code == 0xA0 || code == 0xB7 || code == 0xB0) {
            plain += code == 0xB0 ? " deg " : " ";
        } else if (code < 0x300 || code > 0x36F) {
            plain += text.substr(i - 1, 2);
        }
    }
    return plain;
}

/// Words in lower case; "FirstDist" and "first_dist" are two.
Words words_of(std::string_view text) {
    Words words;
    const std::string plain = without_accents(text);
    bool inside = false;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const char c = plain[i];
        if (!is_letter_or_digit(static_cast<unsigned char>(c))) {
            inside = false;
            continue;
        }
        const bool hump = inside && is_upper(c) && is_lower(plain[i - 1]);
        if (!inside || hump) words.emplace_back();
        words.back() += is_upper(c) ? static_cast<char>(c + 32) : c;
        inside = true;
    }
    return words;
}

std::string joined(const Words& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> list) {
    return std::ranges::find(list, word) != list.end();
}

bool is_foot_word(std::string_view word) {
    return is_one_of(word, {"ft", "feet", "ift", "usft", "ftus", "sft", "usfeet"});
}

bool is_us_word(std::string_view word) {
    return is_one_of(word, {"us", "survey", "usft", "ftus", "sft", "usfeet"});
}

bool is_strange_unit(std::string_view word) {
    return is_one_of(word, {"yd",      "yds",    "yard",    "yards", "inch",  "inches", "deg",    "degree",
                            "degrees", "rad",    "mi",      "mile",  "miles", "chain",  "chains", "link",
                            "links",   "fathom", "fathoms", "dm",    "px",    "pixel",  "percent"});
}

std::optional<LengthUnit> unit_of_word(std::string_view word) {
    if (is_foot_word(word)) return foot;
    if (is_one_of(word, {"m", "mtr", "mtrs", "meter", "meters", "metre", "metres", "metros", "metri", "mts",
                         "masl", "mamsl", "mahd", "mpd", "mslm", "msnm", "müm", "mum"}))
        return metre;
    if (is_one_of(word, {"km", "kilometre", "kilometres", "kilometer", "kilometers"}))
        return LengthUnit{"kilometres", 1000};
    if (is_one_of(word, {"cm", "centimetres", "centimeters"})) return length_unit("cm");
    if (is_one_of(word, {"mm", "millimetres", "millimeters"})) return length_unit("mm");
    return std::nullopt;
}

/// The name of a column in two parts: what it is called, and what stands in brackets or behind a slash.
struct NameParts {
    Words name;
    Words bracketed;
};

NameParts parts_of(std::string_view text) {
    NameParts parts;
    const std::size_t open = text.find_first_of("([{/<");
    parts.name = words_of(text.substr(0, open));
    if (open == std::string_view::npos) return parts;
    parts.bracketed = words_of(text.substr(open));
    return parts;
}

/// Reads the unit out of `words`, which may be a name with its unit behind it, and takes its words away.
void take_unit(Words& words, std::size_t first, bool bracketed, ColumnName& column) {
    Words rest(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(std::min(first, words.size())));
    const bool us = std::ranges::any_of(words, is_us_word);
    for (std::size_t i = first; i < words.size(); ++i) {
        const std::string& word = words[i];
        const bool foot_word = word == "foot" && (bracketed || us);  // else that of a slope
        std::optional<LengthUnit> unit = unit_of_word(foot_word ? "ft" : word);
        if (unit && unit->is_foot() && us) unit = us_foot;
        const bool alone_in_brackets = bracketed && word == "in" && words.size() == 1;
        if (is_strange_unit(word) || alone_in_brackets ||
            (unit && column.unit && unit->metres != column.unit->metres))
            column.strange_unit = true;
        if (unit && !column.unit) column.unit = unit;
        const bool before_unit = word == "in" && i + 1 < words.size() && unit_of_word(words[i + 1]);
        if (!unit && !bracketed && !before_unit) rest.push_back(word);
    }
    words = rest;
}

bool has_part(std::string_view word, std::initializer_list<std::string_view> parts) {
    return std::ranges::any_of(
        parts, [&](std::string_view part) { return word.find(part) != std::string_view::npos; });
}

/// Another quantity than the place of a ground point, though its name has one of the words below.
bool speaks_of_another_quantity(std::string_view word) {
    return has_part(word, {"instrument", "reflektor", "gebaude", "wasser", "unterschied", "differen",
                           "schrag", "schraeg", "groundwater"}) ||
           is_one_of(word, {"slope",       "3d",       "surface",     "delta",       "diff",    "increment",
                            "step",        "prev",     "previous",    "next",        "target",  "reflector",
                            "prism",       "antenna",  "rod",         "pole",        "geoid",   "ellipsoid",
                            "ellipsoidal", "accuracy", "error",       "std",         "stdev",   "sigma",
                            "precision",   "rms",      "quality",     "uncertainty", "depth",   "tiefe",
                            "name",        "code",     "id",          "description", "type",    "date",
                            "time",        "width",    "count",       "segment",     "partial", "teil",
                            "design",      "proposed", "finished",    "formation",   "soll",    "water",
                            "gw",          "wl",       "piezometric", "rock",        "bedrock", "fels",
                            "invert",      "cut",      "fill",        "slip",        "base",    "bottom",
                            "wall",        "tree",     "canopy",      "rail",        "agl"});
}

bool names_chainage(std::string_view word) {
    return has_part(word,
                    {"chainage", "station",   "stazion",    "estacion", "distan",    "abstand",  "entfern",
                     "afstand",  "avstand",   "vzdalenost", "tavolsag", "odleglosc", "etaisyys", "progressiv",
                     "kilometr", "kilometer", "absciss",    "里程",     "距离",      "距離"}) ||
           is_one_of(word, {"dist", "sta", "stn", "chain", "ch", "offset", "running"});
}

bool names_elevation(std::string_view word) {
    return has_part(word,
                    {"elevat", "elevac", "elevaz", "altit", "hohe", "hoehe", "height", "hoogte", "korkeus",
                     "magassag", "nadmorsk", "wysokosc", "rzedna", "高程", "标高", "標高"}) ||
           is_one_of(word, {"elev", "elv", "ele", "el", "alt", "altura", "rl", "level", "kote", "cote",
                            "cota", "quota", "hojd", "hoyde", "vyska", "visina", "kota"});
}

ColumnRole role_of(const Words& words) {
    if (words.empty() || std::ranges::any_of(words, speaks_of_another_quantity)) return ColumnRole::unknown;
    const bool chainage = std::ranges::any_of(words, names_chainage);
    const bool elevation = std::ranges::any_of(words, names_elevation);
    if (chainage && elevation) return ColumnRole::unknown;
    if (chainage) return ColumnRole::chainage;
    if (elevation) return ColumnRole::elevation;
    const std::string& last = words.back();
    if (has_part(last, {"easting", "northing", "rechtswert", "hochwert"}) ||
        is_one_of(last, {"e", "n", "east", "north", "lon", "lat", "longitude", "latitude", "ost", "nord"}))
        return ColumnRole::plan;
    if (last == "x") return ColumnRole::x;
    if (last == "y") return ColumnRole::y;
    if (is_one_of(last, {"z", "h"})) return ColumnRole::short_elevation;
    if (words.size() == 1 && is_one_of(last, {"s", "d", "l", "m", "pk", "km"}))
        return ColumnRole::short_chainage;
    return ColumnRole::unknown;
}

}  // namespace

ColumnName column_name(std::string_view cell) {
    ColumnName column;
    column.text = std::string(cell);
    NameParts parts = parts_of(cell);
    take_unit(parts.bracketed, 0, true, column);
    // The first word is the name, though it may be "m" or "km".
    take_unit(parts.name, 1, false, column);
    if (parts.name.size() == 1 && parts.name.front() == "km" && !column.unit)
        column.unit = unit_of_word("km");
    column.plain = joined(parts.name);
    const bool other = std::ranges::any_of(parts.bracketed, speaks_of_another_quantity);
    column.role = other ? ColumnRole::unknown : role_of(parts.name);
    return column;
}

ColumnName unit_cell(std::string_view cell) {
    ColumnName column;
    column.text = std::string(cell);
    Words words = words_of(cell);
    take_unit(words, 0, true, column);
    return column;
}

std::string plain_words(std::string_view text) {
    return joined(words_of(text));
}

bool mentions_feet(std::string_view text) {
    return std::ranges::any_of(words_of(text), [](const std::string& word) { return is_foot_word(word); });
}

}  // namespace runout
