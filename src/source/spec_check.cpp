#include "source/spec_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace runout {
namespace {

// Of lengths, areas and ratios: what lies outside is a slip of the pen.
constexpr double least_size = 1e-9;
constexpr double greatest_size = 1e8;

constexpr const char* points_key = "source.points";

enum class Quantity { angle, size, elevation, ratio };

struct KeyInfo {
    SpecKey key;
    std::string_view name;
    Quantity quantity;
};

constexpr std::array<KeyInfo, 8> known_keys{{
    {&SourceSpec::base_angle, "source.base_angle_deg", Quantity::angle},
    {&SourceSpec::scarp_angle, "source.scarp_angle_deg", Quantity::angle},
    {&SourceSpec::area, "source.area_m2", Quantity::size},
    {&SourceSpec::height, "source.height_m", Quantity::size},
    {&SourceSpec::length, "source.length_m", Quantity::size},
    {&SourceSpec::thickness, "source.thickness_m", Quantity::size},
    {&SourceSpec::aspect, "source.aspect_ratio", Quantity::ratio},
    {&SourceSpec::drop_height, "source.drop_height_m", Quantity::elevation},
}};

const KeyInfo& info(SpecKey key) {
    return *std::ranges::find(known_keys, key, &KeyInfo::key);
}

std::string keys_of(SourceType type) {
    std::string list = takes_points(type) ? points_key : "";
    for (const KeyInfo& k : known_keys)
        if (uses(type, k.key)) list += fmt::format("{}{}", list.empty() ? "" : ", ", k.name);
    return list;
}

InputPlace place_of(const SourceSpec& spec, const std::string& key, const std::string& value) {
    const auto found = spec.places.find(key);
    InputPlace place = found != spec.places.end() ? found->second : InputPlace{};
    place.key = key;
    if (place.value.empty()) place.value = value;
    return place;
}

std::string as_written(const SourceSpec& spec, const KeyInfo& k) {
    const double value = spec.*k.key;
    if (!given(value)) return "";
    return figure(k.quantity == Quantity::angle ? degrees(value) : value);
}

void check_range(const SourceSpec& spec, const KeyInfo& k) {
    const double value = spec.*k.key;
    switch (k.quantity) {
        case Quantity::angle:
            if (!(value >= 0 && value <= radians(90)))
                refuse(spec, k.key, "is out of range", "give degrees from 0 to 90");
            return;
        case Quantity::elevation:
            if (!(value >= 0 && value <= greatest_size))
                refuse(spec, k.key, "is out of range", "give metres above the toe, 0 or more");
            return;
        case Quantity::size:
        case Quantity::ratio:
            if (!(value >= least_size && value <= greatest_size))
                refuse(spec, k.key, "is out of range",
                       fmt::format("give a number from {:g} to {:g}", least_size, greatest_size));
    }
}

void check_points(const SourceSpec& spec) {
    const std::string type = to_string(spec.type);
    if (!takes_points(spec.type)) {
        if (!spec.points.empty())
            refuse(spec, points_key, "is not used by a source of type " + type,
                   fmt::format("leave it out; this type takes {}", keys_of(spec.type)));
        return;
    }
    const std::size_t least = row_of(spec.type).fewest_points;
    if (spec.points.size() < least)
        refuse(spec, points_key, fmt::format("has {} points", spec.points.size()),
               fmt::format("a {} needs at least {} of [chainage, elevation]", type, least));
    const auto is_sound = [](double metres) { return std::abs(metres) <= greatest_size; };
    for (const SectionPoint& p : spec.points)
        if (!is_sound(p.chainage.m) || !is_sound(p.elevation))
            refuse(spec, points_key, "has a coordinate that is not finite or beyond 1e8 m",
                   "give metres, such as [12.5, 3.0]");
}

}  // namespace

std::vector<SourceType> types_using(std::string_view key) {
    const auto known = std::ranges::find(known_keys, key, &KeyInfo::name);
    std::vector<SourceType> types;
    for (const auto& row : source_types()) {
        const bool used = known == known_keys.end() ? key == points_key && takes_points(row.type)
                                                    : uses(row.type, known->key);
        if (used) types.push_back(row.type);
    }
    return types;
}

void check_spec(const SourceSpec& spec) {
    for (const KeyInfo& k : known_keys) {
        if (!given(spec.*k.key)) continue;
        if (!uses(spec.type, k.key))
            refuse(spec, k.key, "is not used by a source of type " + to_string(spec.type),
                   fmt::format("leave it out; this type takes {}", keys_of(spec.type)));
        check_range(spec, k);
    }
    check_points(spec);
    if (!(spec.discontinuity_angle > 0 && spec.discontinuity_angle <= radians(90)))
        throw InputError(
            place_of(spec, "source.discontinuity_angle_deg", figure(degrees(spec.discontinuity_angle))),
            "is out of range", "give degrees above 0 and up to 90");
    if (spec.scarp_angle <= spec.base_angle)
        refuse(spec, &SourceSpec::scarp_angle, "is not steeper than the base",
               fmt::format("give more than {} and at most 90 degrees", figure(degrees(spec.base_angle))));
}

double required(const SourceSpec& spec, SpecKey key, const std::string& valid) {
    if (!given(spec.*key))
        refuse(spec, key, "is missing for a source of type " + to_string(spec.type), valid);
    return spec.*key;
}

void refuse(const SourceSpec& spec, SpecKey key, const std::string& problem, const std::string& valid) {
    const KeyInfo& k = info(key);
    throw InputError(place_of(spec, std::string(k.name), as_written(spec, k)), problem, valid);
}

void refuse(const SourceSpec& spec, const std::string& key, const std::string& problem,
            const std::string& valid) {
    throw InputError(place_of(spec, key, ""), problem, valid);
}

bool agree(double a, double b) {
    return std::abs(a - b) <= 1e-6 * std::max(std::abs(a), std::abs(b));
}

std::string shown(const Profile& profile, const Vec2& local) {
    const Vec2 p = profile.to_section(local);
    return fmt::format("[{:.10g}, {:.10g}]", p.x(), p.y());
}

std::string figure(double value) {
    return fmt::format("{:.6g}", value);
}

}  // namespace runout
