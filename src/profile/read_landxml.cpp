#include "profile/read_landxml.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "core/input_error.h"
#include "core/length_unit.h"
#include "profile/check_elevations.h"
#include "profile/join_lines.h"
#include "profile/landxml_sections.h"

namespace runout {
namespace {

// A message that lists more is not read.
constexpr std::size_t most_listed = 12;

std::optional<double> number_in(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// 120.5 of "120.5", "0+120.5" and, in stations of 100 ft, "1+20.5".
std::optional<double> station_number(const std::string& text) {
    const std::size_t plus = text.find('+');
    if (plus == std::string::npos) return number_in(text);
    const std::string rest = text.substr(plus + 1);
    const auto whole = number_in(text.substr(0, plus));
    const auto part = number_in(rest);
    const std::size_t digits = std::min(rest.find('.'), rest.size());
    if (!whole || !part || (digits != 2 && digits != 3)) return std::nullopt;
    return *whole * std::pow(10.0, static_cast<double>(digits)) + *part;
}

bool is_station(const std::string& written, const std::string& asked) {
    if (written == asked) return true;
    const auto a = station_number(written);
    const auto b = station_number(asked);
    return a && b && std::abs(*a - *b) <= 1e-6 * std::max(1.0, std::abs(*a));
}

/// One thing that tells sections apart, with the key that chooses.
struct Trait {
    const char* key;
    const char* name;
    std::string LandXmlSection::*written;
    std::string LandXmlChoice::*asked;
    bool (*is)(const std::string& written, const std::string& asked);
};

bool is_name(const std::string& written, const std::string& asked) {
    return written == asked;
}

constexpr std::array<Trait, 3> traits = {{
    {"section.alignment", "alignments", &LandXmlSection::alignment, &LandXmlChoice::alignment, is_name},
    {"section.station", "stations", &LandXmlSection::station, &LandXmlChoice::station, is_station},
    {"section.surface", "surfaces", &LandXmlSection::surface, &LandXmlChoice::surface, is_name},
}};

/// Each once, in the order of the file.
std::vector<std::string> values_of(const std::vector<const LandXmlSection*>& sections, const Trait& trait) {
    std::set<std::string_view> seen;
    std::vector<std::string> values;
    for (const LandXmlSection* section : sections)
        if (seen.insert(section->*trait.written).second) values.push_back(section->*trait.written);
    return values;
}

std::string list_of(const std::vector<std::string>& values) {
    std::string text;
    for (std::size_t i = 0; i < std::min(values.size(), most_listed); ++i)
        text += (i == 0 ? "" : ", ") + (values[i].empty() ? "(without a name)" : values[i]);
    if (values.size() > most_listed) text += fmt::format(" and {} more", values.size() - most_listed);
    return text;
}

const LandXmlSection& chosen(const LandXmlFile& file, const LandXmlChoice& choice, const std::string& path) {
    std::vector<const LandXmlSection*> left;
    for (const LandXmlSection& section : file.sections) left.push_back(&section);
    if (left.empty())
        throw InputError(
            {path, 0, "", ""}, "has no cross-section and no long profile",
            "export CrossSectSurf or ProfSurf with PntList2D; a surface (TIN) is a raster's place");
    for (const Trait& trait : traits) {
        const std::string& asked = choice.*trait.asked;
        if (asked.empty()) continue;
        const std::vector<std::string> values = values_of(left, trait);
        std::erase_if(left, [&](const LandXmlSection* s) { return !trait.is(s->*trait.written, asked); });
        if (left.empty())
            throw InputError({path, 0, trait.key, asked}, "is not in the file",
                             fmt::format("give one of {}", list_of(values)));
    }
    for (const Trait& trait : traits) {
        const std::vector<std::string> values = values_of(left, trait);
        if (values.size() > 1)
            throw InputError(
                {path, 0, trait.key, choice.*trait.asked},
                fmt::format("must be said: the file has sections with {} {}", values.size(), trait.name),
                fmt::format("give one of {}", list_of(values)));
    }
    if (left.size() > 1)
        throw InputError(
            {path, 0, "", ""},
            fmt::format("has {} sections of the same alignment, station and surface", left.size()),
            "leave one of them in the file");
    return *left.front();
}

LengthUnit unit_of(const LandXmlFile& file, const LandXmlChoice& choice, const std::string& path) {
    if (!choice.unit.empty()) return known_length_unit(choice.unit);
    if (file.unit.empty())
        throw InputError({path, 0, "section.unit", ""}, "is missing: the file names no linear unit",
                         "give m, cm, mm, ft, us-ft or in");
    return *length_unit(file.unit);
}

std::string how_it_was_read(const LandXmlSection& section, const LandXmlFile& file, const LengthUnit& unit,
                            const LandXmlChoice& choice) {
    const bool profile = section.station == "profile";
    std::string text = profile ? "read as: long profile"
                               : fmt::format("read as: cross-section at station {}", section.station);
    if (!section.surface.empty()) text += fmt::format(", surface {}", section.surface);
    if (!section.alignment.empty()) text += fmt::format(", alignment {}", section.alignment);
    text += fmt::format("; {} = chainage, in {}", profile ? "station" : "offset", unit.name);
    if (!choice.unit.empty() && choice.unit != file.unit) text += " (as section.unit says)";
    return text;
}

/// A surface in one part keeps the lines of its points.
void take_single_part(const LandXmlSection& section, SectionPoints& taken) {
    const Polyline& part = section.parts.front();
    const std::vector<int>& lines = section.lines.front();
    for (std::size_t i = 0; i < part.size(); ++i) {
        if (i > 0 && part[i] == part[i - 1]) continue;
        taken.points.push_back(part[i]);
        if (i < lines.size()) taken.lines.push_back(lines[i]);
    }
    if (taken.points.front().x() > taken.points.back().x()) {
        std::ranges::reverse(taken.points);
        std::ranges::reverse(taken.lines);
    }
}

}  // namespace

SectionPoints read_landxml(const std::string& path, const LandXmlChoice& choice) {
    const LandXmlFile file = load_landxml(path);
    const LandXmlSection& found = chosen(file, choice, path);
    const LengthUnit unit = unit_of(file, choice, path);
    LandXmlSection section = found;
    for (Polyline& part : section.parts)
        for (Vec2& p : part) p *= unit.metres;
    for (std::size_t i = 0; i < section.parts.size(); ++i)
        check_elevations({section.parts[i], section.lines[i], path, {}, {}});
    SectionPoints taken;
    taken.origin = path;
    taken.read_as = how_it_was_read(found, file, unit, choice);
    if (section.parts.size() == 1)
        take_single_part(section, taken);
    else
        taken.points =
            join_lines(section.parts, Course::open, {path, fmt::format("surface {}", section.surface)});
    return taken;
}

}  // namespace runout
