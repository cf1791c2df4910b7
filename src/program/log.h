#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

namespace runout {

// What the program says on standard error while it works; standard output belongs to the answer. spdlog
// writes the lines, behind this header: only log.cpp includes it.

enum class LogLevel { info, warning, error };

/// Sends the log to standard error, a line a message, as printable() shows it. Call it once, first of all.
void start_log();

/// From now on errors only: what `--quiet` asks for.
void log_errors_only();

void log_line(LogLevel level, const std::string& message);

template <class... Values>
void log_info(fmt::format_string<Values...> format, Values&&... values) {
    log_line(LogLevel::info, fmt::format(format, std::forward<Values>(values)...));
}

template <class... Values>
void log_warning(fmt::format_string<Values...> format, Values&&... values) {
    log_line(LogLevel::warning, fmt::format(format, std::forward<Values>(values)...));
}

template <class... Values>
void log_error(fmt::format_string<Values...> format, Values&&... values) {
    log_line(LogLevel::error, fmt::format(format, std::forward<Values>(values)...));
}

}  // namespace runout
