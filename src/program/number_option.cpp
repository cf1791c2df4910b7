#include "program/number_option.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "core/input_error.h"

namespace runout {
namespace {

/// "--jobs" of "-j,--jobs".
std::string long_name(const std::string& names) {
    const std::string name = names.substr(names.find("--"));
    return name.substr(0, name.find(','));
}

std::string valid_text(const NumberRange& range, const char* kind) {
    std::string text = fmt::format("valid: {:.16g} {} {}", range.low, range.above_low ? "<" : "<=", kind);
    if (std::isfinite(range.high)) text += fmt::format(" <= {:.16g}", range.high);
    return text;
}

/// The help with what is valid, where it has limits that a user may meet.
std::string with_range(const std::string& help, const NumberRange& range) {
    if (std::isfinite(range.high)) return fmt::format("{}; {:.16g} to {:.16g}", help, range.low, range.high);
    return range.above_low ? fmt::format("{}; more than {:.16g}", help, range.low) : help;
}

bool is_within(const NumberRange& range, double number) {
    return number >= range.low && number <= range.high && !(range.above_low && number == range.low);
}

template <class Number>
Number number_from(const std::string& option, const std::string& text, const NumberRange& range) {
    const bool whole = std::is_integral_v<Number>;
    const std::string valid = valid_text(range, whole ? "whole number" : "number");
    const InputPlace place{.file = option, .line = 0, .key = {}, .value = text};
    Number number{};
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    if (read.ptr != end || read.ec == std::errc::invalid_argument ||
        !std::isfinite(static_cast<double>(number)))
        throw InputError(place, whole ? "is not a whole number" : "is not a number", valid);
    if (read.ec != std::errc{} || !is_within(range, static_cast<double>(number)))
        throw InputError(place, "is out of range", valid);
    return number;
}

template <class Read, class Value>
CommandOption add_single(Command& command, const std::string& names, Value& value, const std::string& help,
                         const NumberRange& range) {
    const auto take = [&value, option = long_name(names), range](const std::string& text) {
        value = static_cast<Read>(number_from<Read>(option, text, range));
    };
    return command.add_option(names, take, help).value_name("number");
}

template <class Number>
CommandOption add_list(Command& command, const std::string& names, std::vector<Number>& values,
                       const std::string& help, const NumberRange& range) {
    const auto take = [&values, option = long_name(names), range](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) values.push_back(number_from<Number>(option, text, range));
    };
    return command.add_option(names, take, help);
}

/// Ids are given out from 1; those of a database from elsewhere may be any.
constexpr NumberRange any_id = {.low = -0x1p63, .high = 0x1p63};

}  // namespace

CommandOption add_number_option(Command& command, const std::string& names, double& value,
                                const std::string& help, const NumberRange& range) {
    CommandOption option = add_single<double>(command, names, value, with_range(help, range), range);
    return std::isnan(value) ? option : option.default_text(fmt::format("{:g}", value));
}

CommandOption add_number_option(Command& command, const std::string& names, int& value,
                                const std::string& help, const NumberRange& range) {
    return add_single<int>(command, names, value, with_range(help, range), range)
        .default_text(fmt::format("{}", value));
}

CommandOption add_number_option(Command& command, const std::string& names, std::uint64_t& value,
                                const std::string& help, const NumberRange& range) {
    return add_single<std::uint64_t>(command, names, value, with_range(help, range), range)
        .default_text(fmt::format("{}", value));
}

CommandOption add_number_option(Command& command, const std::string& names, std::vector<double>& values,
                                const std::string& help, const NumberRange& range) {
    return add_list(command, names, values, with_range(help, range), range).value_name("number");
}

CommandOption add_id_option(Command& command, const std::string& name, std::optional<long>& id,
                            const std::string& help) {
    return add_single<long>(command, name, id, help, any_id).value_name("ID");
}

CommandOption add_id_option(Command& command, const std::string& name, std::vector<long>& ids,
                            const std::string& help) {
    return add_list(command, name, ids, help, any_id).value_name("ID");
}

}  // namespace runout
