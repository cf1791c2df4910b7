#include "scene/parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace runout {
namespace {

/// Levenshtein distance: insertions, deletions and replacements that turn one word into the other.
std::size_t edit_distance(std::string_view from, std::string_view to) {
    std::vector<std::size_t> row(to.size() + 1);
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= from.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= to.size(); ++j) {
            const std::size_t replaced = diagonal + (from[i - 1] == to[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
        }
    }
    return row.back();
}

/// "density_kg_m3" of "material.density_kg_m3".
std::string_view last_part(std::string_view key) {
    return key.substr(key.rfind('.') + 1);
}

/// A key in the wrong section is as near as a key with a typing error, so the last parts are compared too;
/// and a key without its unit ("friction_angle") is nearer than any typing error.
std::size_t key_distance(std::string_view typed, std::string_view known) {
    if (last_part(known).starts_with(last_part(typed)) && !last_part(typed).empty()) return 1;
    return std::min(edit_distance(typed, known), edit_distance(last_part(typed), last_part(known)) + 1);
}

const Parameter& nearest_parameter(std::string_view typed) {
    return *std::ranges::min_element(
        parameters(), {}, [&](const Parameter& parameter) { return key_distance(typed, parameter.key); });
}

constexpr std::size_t longest_word = 4096;    // as long as a path may be
constexpr std::size_t longest_list = 10'000;  // a polygon of more would take hours

void check_number(const Parameter& parameter, double value, const InputPlace& place) {
    if (!std::isfinite(value))
        throw InputError(place, "is not a finite number", "valid: " + valid_values(parameter));
    if (parameter.kind == ValueKind::integer && value != std::floor(value))
        throw InputError(place, "is not a whole number", "valid: " + valid_values(parameter));
    if (!parameter.range.contains(value))
        throw InputError(place, "is out of range", "valid: " + valid_values(parameter));
}

void check_word(const Parameter& parameter, const std::string& value, const InputPlace& place) {
    if (value.empty()) throw InputError(place, "is empty", "valid: " + valid_values(parameter));
    // A path would be opened up to there, under a name that nobody sees.
    if (value.find('\0') != std::string::npos)
        throw InputError(place, "holds a zero byte", "valid: " + valid_values(parameter));
    if (value.size() > longest_word)
        throw InputError(place, fmt::format("is longer than {} characters", longest_word),
                         "valid: " + valid_values(parameter));
    if (parameter.kind == ValueKind::choice &&
        std::ranges::find(parameter.choices, value) == parameter.choices.end())
        throw InputError(place, "is not known", "valid: " + valid_values(parameter));
}

void check_length(std::size_t entries, const InputPlace& place) {
    if (entries > longest_list)
        throw InputError(place, fmt::format("has {} entries", entries),
                         fmt::format("give at most {}", longest_list));
}

/// Rising, so that a reader sees at once what is asked.
void check_numbers(const Parameter& parameter, const std::vector<double>& values, const InputPlace& place) {
    check_length(values.size(), place);
    for (const double value : values) check_number(parameter, value, place);
    if (std::ranges::adjacent_find(values, std::greater_equal<>{}) != values.end())
        throw InputError(place, "is not a rising list", "valid: " + valid_values(parameter));
}

void check_points(const Polyline& points, const InputPlace& place) {
    check_length(points.size(), place);
    for (const Vec2& point : points)
        if (!point.allFinite()) throw InputError(place, "has a coordinate that is not finite", "give metres");
}

void check_rows(const Parameter& parameter, const NumberRows& rows, const InputPlace& place) {
    if (rows.empty()) throw InputError(place, "is an empty list", "valid: " + valid_values(parameter));
    check_length(rows.size(), place);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool complete = rows[i].size() == parameter.choices.size() &&
                              std::ranges::all_of(rows[i], [](double v) { return std::isfinite(v); });
        if (!complete)
            throw InputError(place, fmt::format("has a row {} that is not complete", i + 1),
                             "valid: " + valid_values(parameter));
    }
}

}  // namespace

bool Range::contains(double value) const {
    const bool above = low_included ? value >= low : value > low;
    const bool below = high_included ? value <= high : value < high;
    return above && below;
}

const Parameter* find_parameter(std::string_view key) {
    const auto found = std::ranges::find(parameters(), key, &Parameter::key);
    return found == parameters().end() ? nullptr : &*found;
}

InputError unknown_key(const InputPlace& place) {
    return {place, "is not a known key",
            fmt::format("the nearest is {} (runout help keys lists all)", nearest_parameter(place.key).key)};
}

const Parameter& known_parameter(const InputPlace& place) {
    if (const Parameter* parameter = find_parameter(place.key)) return *parameter;
    throw unknown_key(place);
}

void assign(CaseSpec& spec, const Parameter& parameter, const Value& value, const InputPlace& place) {
    if (const double* number = std::get_if<double>(&value)) check_number(parameter, *number, place);
    if (const std::string* word = std::get_if<std::string>(&value)) check_word(parameter, *word, place);
    if (const Vec2* at = std::get_if<Vec2>(&value)) check_points({*at}, place);
    if (const Polyline* points = std::get_if<Polyline>(&value)) check_points(*points, place);
    if (const auto* list = std::get_if<std::vector<double>>(&value)) check_numbers(parameter, *list, place);
    if (const auto* table = std::get_if<NumberRows>(&value)) check_rows(parameter, *table, place);
    parameter.set(spec, value);
    spec.given.insert_or_assign(std::string(parameter.key), place);
}

std::string valid_values(const Parameter& parameter) {
    const std::string unit = parameter.unit.empty() ? "" : fmt::format(" {}", parameter.unit);
    const Range& range = parameter.range;
    switch (parameter.kind) {
        case ValueKind::choice:
            return fmt::format("one of {}", fmt::join(parameter.choices, ", "));
        case ValueKind::text:
            return "a text";
        case ValueKind::place:
            return "[easting, northing] or [longitude, latitude]";
        case ValueKind::points:
            return "a list of [chainage, elevation] pairs in metres";
        case ValueKind::numbers:
            return fmt::format("a rising list of numbers{}{}", unit.empty() ? "" : " in", unit);
        case ValueKind::rows:
            return fmt::format("a list of rows [{}]", fmt::join(parameter.choices, ", "));
        case ValueKind::integer:
        case ValueKind::number:
            break;
    }
    const std::string noun = parameter.kind == ValueKind::integer ? "whole number" : "number";
    if (std::isinf(range.low) && std::isinf(range.high))
        return fmt::format("any {}{}", noun, parameter.unit.empty() ? "" : " in" + unit);
    if (std::isinf(range.high))
        return fmt::format("a {} {} {}{}", noun, range.low_included ? ">=" : ">", range.low, unit);
    return fmt::format("{} {} {} {} {}{}", range.low, range.low_included ? "<=" : "<", noun,
                       range.high_included ? "<=" : "<", range.high, unit);
}

}  // namespace runout
