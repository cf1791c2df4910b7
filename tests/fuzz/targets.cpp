#include "fuzz/targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "fuzz/bytes.h"
#include "profile/profile.h"
#include "profile/read_section_table.h"
#include "profile/section_file.h"
#include "scene/case_file.h"
#include "scene/case_spec.h"
#include "source/source_types.h"

namespace runout::fuzz {
namespace {

void check(const Profile& profile) {
    require(profile.ground.size() >= 2, "a profile has two points");
    require(profile.crest <= profile.toe && profile.toe < profile.ground.size(), "crest and toe are on it");
    require(profile.ground[profile.toe] == Vec2(0, 0), "the toe is the origin");
    for (std::size_t i = 0; i < profile.ground.size(); ++i) {
        require(profile.ground[i].allFinite(), "the ground is finite");
        if (i == 0) continue;
        require(profile.ground[i].x() >= profile.ground[i - 1].x(), "x never decreases");
        require(profile.ground[i] != profile.ground[i - 1], "no point is repeated");
    }
}

void check(const Source& source) {
    require(std::isfinite(source.area) && source.area > 0, "a source has an area");
    require(source.front_area >= 0 && source.front_area <= source.area * (1 + 1e-9), "S_front is part of it");
    require(source.outline.size() >= 3, "an outline has three corners");
    for (const Vec2& p : source.outline) require(p.allFinite(), "the outline is finite");
    require(source.bed.size() >= 2, "there is a bed");
    for (std::size_t i = 1; i < source.bed.size(); ++i)
        require(source.bed[i].x() >= source.bed[i - 1].x(), "the bed never goes back");
    require(std::isfinite(source.drop_height), "the drop height is finite");
}

std::vector<Vec2> points_from(Numbers& numbers, std::size_t count, bool forwards) {
    std::vector<Vec2> points;
    double x = 0;
    while (points.size() < count) {
        const double step = numbers.number();
        x = forwards ? x + std::abs(step) : step;
        points.emplace_back(x, numbers.number());
    }
    return points;
}

SourceSpec spec_from(Numbers& numbers) {
    SourceSpec spec;
    spec.type = source_types()[numbers.byte() % source_types().size()].type;
    const std::uint8_t given = numbers.byte();
    const auto set = [&](int bit, double SourceSpec::*key, double value) {
        if ((given >> bit & 1) != 0) spec.*key = value;
    };
    set(0, &SourceSpec::base_angle, numbers.size() / 100);
    set(1, &SourceSpec::scarp_angle, numbers.size() / 100);
    set(2, &SourceSpec::area, numbers.size());
    set(3, &SourceSpec::height, numbers.size());
    set(4, &SourceSpec::length, numbers.size());
    set(5, &SourceSpec::thickness, numbers.size());
    set(6, &SourceSpec::aspect, numbers.size());
    set(7, &SourceSpec::drop_height, numbers.number());
    if (numbers.byte() % 2 == 1) spec.datum = DropDatum::base;
    if (takes_points(spec.type))
        spec.points =
            section_points(points_from(numbers, numbers.byte() % 12, spec.type == SourceType::slip_surface));
    return spec;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t first = std::min(text.find_first_not_of(blanks), text.size());
    return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

/// Each line of a case as `--set section.key=value`, all of one case, until one is refused.
void override_with(std::string_view text) {
    CaseSpec spec;
    std::string section;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = trimmed(text.substr(begin, end - begin));
        begin = end + 1;
        if (line.empty() || line.starts_with('#')) continue;
        if (line.starts_with('[') && line.ends_with(']')) {
            section = fmt::format("{}.", line.substr(1, line.size() - 2));
            continue;
        }
        const std::size_t equals = std::min(line.find('='), line.size());
        const std::string key(trimmed(line.substr(0, equals)));
        const std::string value(trimmed(line.substr(std::min(equals + 1, line.size()))));
        override_value(spec, key.find('.') == key.npos ? section + key : key, value, "--set");
    }
}

}  // namespace

void read_section(std::span<const std::uint8_t> bytes) {
    const std::string path = written(bytes, ".csv");
    for (const TableOptions& said :
         {TableOptions{}, TableOptions{.columns = "2,1"}, TableOptions{.unit = "ft", .decimal = "comma"}})
        accept_input_error([&] { check(make_profile(read_section_table(path, said), {})); });
}

void read_any_section(std::span<const std::uint8_t> bytes) {
    const std::string path = written(bytes, "");
    accept_input_error([&] { check(make_profile(read_section_file(path, {}).section, {})); });
}

void read_case_file(std::span<const std::uint8_t> bytes) {
    const std::string path = written(bytes, ".toml");
    accept_input_error([&] { read_case(path); });
    accept_input_error([&] { override_with({reinterpret_cast<const char*>(bytes.data()), bytes.size()}); });
}

void derive_any_source(std::span<const std::uint8_t> bytes) {
    Numbers numbers(bytes);
    accept_input_error([&] {
        const std::vector<Vec2> points = points_from(numbers, 2 + numbers.byte() % 10, true);
        ProfileOptions options;
        const std::uint8_t given = numbers.byte();
        if (given % 4 == 1) options.toe_chainage = Chainage(numbers.number());
        if (given % 8 == 3) options.crest_chainage = Chainage(numbers.number());
        const Profile profile = make_profile({points, {}, "fuzz"}, options);
        check(profile);
        check(derive_source(profile, spec_from(numbers)));
    });
}

}  // namespace runout::fuzz
