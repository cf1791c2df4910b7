#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/parameters.h"

namespace runout {

// What the tables of keys are written with.

constexpr Range any_number{};
constexpr Range positive{.low = 0};
constexpr Range zero_or_more{.low = 0, .low_included = true};

constexpr Range above_zero_up_to(double high) {
    return {.low = 0, .high = high, .low_included = false, .high_included = true};
}
constexpr Range between(double low, double high) {
    return {.low = low, .high = high, .low_included = true, .high_included = true};
}
constexpr Range from_to_below(double low, double high) {
    return {.low = low, .high = high, .low_included = true, .high_included = false};
}

using Words = std::vector<std::string_view>;
using SetNumber = void (*)(CaseSpec&, double);
using SetInteger = void (*)(CaseSpec&, int);
using SetText = void (*)(CaseSpec&, const std::string&);
using SetNumbers = void (*)(CaseSpec&, const std::vector<double>&);
using SetPlace = void (*)(CaseSpec&, const Vec2&);
using SetPoints = void (*)(CaseSpec&, const Polyline&);
using SetRows = void (*)(CaseSpec&, const NumberRows&);

// Each makes one Parameter; `set` gets the value in the units of the file.
Parameter number(std::string_view key, std::string_view unit, Range range, std::string_view fallback,
                 std::string_view help, SetNumber set);
Parameter integer(std::string_view key, Range range, std::string_view fallback, std::string_view help,
                  SetInteger set);
/// A word of `choices`, or any text where there are none.
Parameter word(std::string_view key, Words choices, std::string_view fallback, std::string_view help,
               SetText set);
/// A place on a map, two numbers.
Parameter place(std::string_view key, std::string_view fallback, std::string_view help, SetPlace set);
Parameter points(std::string_view key, std::string_view fallback, std::string_view help, SetPoints set);
Parameter numbers(std::string_view key, std::string_view unit, Range range, std::string_view fallback,
                  std::string_view help, SetNumbers set);
/// A list of rows of equal length; `columns` names their numbers.
Parameter rows(std::string_view key, Words columns, std::string_view fallback, std::string_view help,
               SetRows set);

/// Keys of the effects and of the places.
std::vector<Parameter> effect_parameters();

}  // namespace runout
