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
CLI::Option* add_single(CLI::App& command, const std::string& names, Value& value, const std::string& help,
                        const NumberRange& range) {
    const auto take = [&value, option = long_name(names), range](const std::string& text) {
        value = static_cast<Read>(number_from<Read>(option, text, range));
    };
    return command.add_option_function<std::string>(names, take, help)->type_name("number");
}

template <class Number>
CLI::Option* add_list(CLI::App& command, const std::string& names, std::vector<Number>& values,
                      const std::string& help, const NumberRange& range) {
    const auto take = [&values, option = long_name(names), range](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) values.push_back(number_from<Number>(option, text, range));
    };
    return command.add_option_function<std::vector<std::string>>(names, take, help);
}

/// Ids are given out from 1; those of a database from elsewhere may be any.
constexpr NumberRange any_id = {.low = -0x1p63, .high = 0x1p63};

}  // namespace

CLI::Option* add_number_option(CLI::App& command, const std::string& names, double& value,
                               const std::string& help, const NumberRange& range) {
    CLI::Option* option = add_single<double>(command, names, value, help, range);
    return std::isnan(value) ? option : option->default_str(fmt::format("{:g}", value));
}

CLI::Option* add_number_option(CLI::App& command, const std::string& names, int& value,
                               const std::string& help, const NumberRange& range) {
    return add_single<int>(command, names, value, help, range)->default_str(fmt::format("{}", value));
}

CLI::Option* add_number_option(CLI::App& command, const std::string& names, std::uint64_t& value,
                               const std::string& help, const NumberRange& range) {
    return add_single<std::uint64_t>(command, names, value, help, range)
        ->default_str(fmt::format("{}", value));
}

CLI::Option* add_number_option(CLI::App& command, const std::string& names, std::vector<double>& values,
                               const std::string& help, const NumberRange& range) {
    return add_list(command, names, values, help, range)->type_name("number");
}

CLI::Option* add_id_option(CLI::App& command, const std::string& name, std::optional<long>& id,
                           const std::string& help) {
    return add_single<long>(command, name, id, help, any_id)->type_name("ID");
}

CLI::Option* add_id_option(CLI::App& command, const std::string& name, std::vector<long>& ids,
                           const std::string& help) {
    return add_list(command, name, ids, help, any_id)->type_name("ID");
}

}  // namespace runout
