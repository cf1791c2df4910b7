#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "program/command_line.h"

namespace runout {

/// low <= number <= high, or low < number where `above_low`.
struct NumberRange {
    double low = 0;
    double high = std::numeric_limits<double>::infinity();
    bool above_low = false;
};

constexpr NumberRange positive_number = {.low = 0, .above_low = true};
constexpr NumberRange not_negative = {.low = 0};

// Each declares an option that takes a number as a case file has it: decimal, finite, with nothing around it.
// CLI11 by itself would take 010 for 8, nan for a number of any range, and the greatest that fits for one
// that does not fit. Throws InputError, naming the option.
CommandOption add_number_option(Command& command, const std::string& names, double& value,
                                const std::string& help, const NumberRange& range);
CommandOption add_number_option(Command& command, const std::string& names, int& value,
                                const std::string& help, const NumberRange& range);
CommandOption add_number_option(Command& command, const std::string& names, std::uint64_t& value,
                                const std::string& help, const NumberRange& range);
CommandOption add_number_option(Command& command, const std::string& names, std::vector<double>& values,
                                const std::string& help, const NumberRange& range);

/// An option that takes the number of a row in a database.
CommandOption add_id_option(Command& command, const std::string& name, std::optional<long>& id,
                            const std::string& help);
CommandOption add_id_option(Command& command, const std::string& name, std::vector<long>& ids,
                            const std::string& help);

}  // namespace runout
