#include "program/log.h"

#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>

#include "core/printable.h"

namespace runout {
namespace {

/// The message of a log line, as printable() shows it.
class PrintableMessage : public spdlog::custom_flag_formatter {
  public:
    void format(const spdlog::details::log_msg& message, const std::tm&,
                spdlog::memory_buf_t& line) override {
        const std::string text = printable({message.payload.data(), message.payload.size()});
        line.append(text.data(), text.data() + text.size());
    }
    [[nodiscard]] std::unique_ptr<custom_flag_formatter> clone() const override {
        return std::make_unique<PrintableMessage>();
    }
};

spdlog::level::level_enum spdlog_level(LogLevel level) {
    switch (level) {
        case LogLevel::info:
            return spdlog::level::info;
        case LogLevel::warning:
            return spdlog::level::warn;
        case LogLevel::error:
            break;
    }
    return spdlog::level::err;
}

}  // namespace

void start_log() {
    auto logger = spdlog::stderr_color_mt("runout");
    auto lines = std::make_unique<spdlog::pattern_formatter>();
    lines->add_flag<PrintableMessage>('*').set_pattern("runout: %^%l%$: %*");
    logger->set_formatter(std::move(lines));
    spdlog::set_default_logger(logger);
}

void log_errors_only() {
    spdlog::set_level(spdlog::level::err);
}

void log_line(LogLevel level, const std::string& message) {
    spdlog::log(spdlog_level(level), spdlog::string_view_t(message));
}

}  // namespace runout
