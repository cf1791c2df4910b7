#include "scene/parameter_builders.h"

#include <cmath>
#include <utility>

namespace runout {

Parameter number(std::string_view key, std::string_view unit, Range range, std::string_view fallback,
                 std::string_view help, SetNumber set) {
    return {key,
            ValueKind::number,
            unit,
            range,
            {},
            fallback,
            help,
            {},
            [set](CaseSpec& spec, const Value& value) { set(spec, std::get<double>(value)); }};
}

Parameter integer(std::string_view key, Range range, std::string_view fallback, std::string_view help,
                  SetInteger set) {
    return {key,
            ValueKind::integer,
            "",
            range,
            {},
            fallback,
            help,
            {},
            [set](CaseSpec& spec, const Value& value) {
                set(spec, static_cast<int>(std::lround(std::get<double>(value))));
            }};
}

Parameter word(std::string_view key, Words choices, std::string_view fallback, std::string_view help,
               SetText set) {
    return {key,
            choices.empty() ? ValueKind::text : ValueKind::choice,
            "",
            {},
            std::move(choices),
            fallback,
            help,
            {},
            [set](CaseSpec& spec, const Value& value) { set(spec, std::get<std::string>(value)); }};
}

Parameter place(std::string_view key, std::string_view fallback, std::string_view help, SetPlace set) {
    return {key,
            ValueKind::place,
            "",
            any_number,
            {},
            fallback,
            help,
            {},
            [set](CaseSpec& spec, const Value& value) { set(spec, std::get<Vec2>(value)); }};
}

Parameter points(std::string_view key, std::string_view fallback, std::string_view help, SetPoints set) {
    return {
        key, ValueKind::points, "m", {}, {}, fallback, help, {}, [set](CaseSpec& spec, const Value& value) {
            set(spec, std::get<Polyline>(value));
        }};
}

Parameter numbers(std::string_view key, std::string_view unit, Range range, std::string_view fallback,
                  std::string_view help, SetNumbers set) {
    return {key,
            ValueKind::numbers,
            unit,
            range,
            {},
            fallback,
            help,
            {},
            [set](CaseSpec& spec, const Value& value) { set(spec, std::get<std::vector<double>>(value)); }};
}

Parameter rows(std::string_view key, Words columns, std::string_view fallback, std::string_view help,
               SetRows set) {
    return {key,
            ValueKind::rows,
            "",
            {},
            std::move(columns),
            fallback,
            help,
            {},
            [set](CaseSpec& spec, const Value& value) { set(spec, std::get<NumberRows>(value)); }};
}

}  // namespace runout
