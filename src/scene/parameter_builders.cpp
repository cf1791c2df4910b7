#include "scene/parameter_builders.h"

#include <cmath>
#include <functional>
#include <utility>
#include <variant>

namespace runout {

namespace {

/// What puts a value into the case, from a function that takes it as a T.
template <class T, class Set>
std::function<void(CaseSpec&, const Value&)> taking(Set set) {
    return [set](CaseSpec& spec, const Value& value) { set(spec, std::get<T>(value)); };
}

}  // namespace

Parameter number(std::string_view key, std::string_view unit, Range range, std::string_view fallback,
                 std::string_view help, SetNumber set) {
    return {.key = key,
            .kind = ValueKind::number,
            .unit = unit,
            .range = range,
            .fallback = fallback,
            .help = help,
            .set = taking<double>(set)};
}

Parameter integer(std::string_view key, Range range, std::string_view fallback, std::string_view help,
                  SetInteger set) {
    const auto rounded = [set](CaseSpec& spec, double value) {
        set(spec, static_cast<int>(std::lround(value)));
    };
    return {.key = key,
            .kind = ValueKind::integer,
            .range = range,
            .fallback = fallback,
            .help = help,
            .set = taking<double>(rounded)};
}

Parameter word(std::string_view key, Words choices, std::string_view fallback, std::string_view help,
               SetText set) {
    const ValueKind kind = choices.empty() ? ValueKind::text : ValueKind::choice;
    return {.key = key,
            .kind = kind,
            .choices = std::move(choices),
            .fallback = fallback,
            .help = help,
            .set = taking<std::string>(set)};
}

Parameter place(std::string_view key, std::string_view fallback, std::string_view help, SetPlace set) {
    return {
        .key = key, .kind = ValueKind::place, .fallback = fallback, .help = help, .set = taking<Vec2>(set)};
}

Parameter points(std::string_view key, std::string_view fallback, std::string_view help, SetPoints set) {
    return {.key = key,
            .kind = ValueKind::points,
            .unit = "m",
            .fallback = fallback,
            .help = help,
            .set = taking<Polyline>(set)};
}

Parameter numbers(std::string_view key, std::string_view unit, Range range, std::string_view fallback,
                  std::string_view help, SetNumbers set) {
    return {.key = key,
            .kind = ValueKind::numbers,
            .unit = unit,
            .range = range,
            .fallback = fallback,
            .help = help,
            .set = taking<std::vector<double>>(set)};
}

Parameter rows(std::string_view key, Words columns, std::string_view fallback, std::string_view help,
               SetRows set) {
    return {.key = key,
            .kind = ValueKind::rows,
            .choices = std::move(columns),
            .fallback = fallback,
            .help = help,
            .set = taking<NumberRows>(set)};
}

}  // namespace runout
