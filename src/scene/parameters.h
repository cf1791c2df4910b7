#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/geometry.h"
#include "scene/case_spec.h"

namespace runout {

enum class ValueKind { number, integer, text, choice, place, points, numbers, rows };

/// Rows of numbers, all of one length.
using NumberRows = std::vector<std::vector<double>>;

/// Interval of valid numbers; an end that is not included is excluded.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_included = false;
    bool high_included = false;

    [[nodiscard]] bool contains(double value) const;
};

/// A value as read, in the units of the file (degrees, metres). A place on a map is a Vec2.
using Value = std::variant<double, std::string, Vec2, Polyline, std::vector<double>, NumberRows>;

/// One key of a case file: all that reading, checking and explaining it takes.
struct Parameter {
    std::string_view key{};  ///< "material.friction_angle_deg"
    ValueKind kind{};
    std::string_view unit{};                  ///< "" for pure numbers and words
    Range range{};                            ///< of numbers, integers and each of a list of numbers
    std::vector<std::string_view> choices{};  ///< valid words; of rows: what each number of a row is
    std::string_view fallback{};              ///< what holds when the key is absent, in words
    std::string_view help{};                  ///< one sentence
    std::vector<SourceType> applies_to{};     ///< source types that know this key; empty: all
    std::function<void(CaseSpec&, const Value&)> set{};
};

/// The table of all keys, in the order of the documentation.
std::span<const Parameter> parameters();

/// Sections that may stand several times in a case, as [[place]] does: their keys belong to the latest entry.
bool is_list_section(std::string_view section);

/// Begins one more entry of such a section.
void begin_entry(CaseSpec& spec, std::string_view section);

/// nullptr when there is no such key.
const Parameter* find_parameter(std::string_view key);

/// The sentence for a key that is not in the table, with the nearest one that is.
InputError unknown_key(const InputPlace& place);

/// The parameter named by `place.key`. Throws unknown_key.
const Parameter& known_parameter(const InputPlace& place);

/// Checks `value` against the parameter's range or choices and puts it into the case. Throws InputError.
void assign(CaseSpec& spec, const Parameter& parameter, const Value& value, const InputPlace& place);

/// "0 <= value < 80 deg", "one of rectangle, A, B": for messages and for `runout help keys`.
std::string valid_values(const Parameter& parameter);

}  // namespace runout
