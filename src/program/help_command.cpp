#include <fmt/format.h>

#include <memory>
#include <string>

#include "core/input_error.h"
#include "program/command.h"
#include "scene/parameters.h"

namespace runout {
namespace {

std::string source_types(const Parameter& parameter) {
    std::string names;
    for (const SourceType type : parameter.applies_to) names += (names.empty() ? "" : ", ") + to_string(type);
    return names.empty() ? "" : fmt::format("\n      Only for source.type {}.", names);
}

/// The parameter table for reading: each key with what is valid, what holds without it, and what it means.
std::string key_table() {
    std::string text = "Keys of a case file (TOML), also for --set key=value.\n";
    std::string section;
    for (const Parameter& parameter : parameters()) {
        const std::string key(parameter.key);
        const std::size_t dot = key.find('.');
        if (key.substr(0, dot) != section) {
            section = key.substr(0, dot);
            text += fmt::format("\n[{}]\n", section);
        }
        text +=
            fmt::format("  {}  ({}; default: {})\n      {}{}\n", key.substr(dot + 1), valid_values(parameter),
                        parameter.fallback, parameter.help, source_types(parameter));
    }
    return text;
}

std::string topics(const CLI::App& app) {
    std::string names = "keys";
    for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
        names += ", " + sub->get_name();
    return names;
}

std::string help_on(const CLI::App& app, const std::string& topic) {
    // Not app.help(): that would explain the subcommand at hand, which is `help`.
    if (topic.empty())
        return app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal);
    if (topic == "keys") return key_table();
    for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
        if (sub->get_name() == topic) return sub->help(app.get_name());
    throw InputError({.file = {}, .line = 0, .key = "help", .value = topic}, "is not a topic",
                     "valid: " + topics(app));
}

}  // namespace

void add_help_command(CLI::App& app, Command& command) {
    const auto topic = std::make_shared<std::string>();
    CLI::App* sub =
        app.add_subcommand("help", "Explain a subcommand, or all keys of a case file: runout help keys");
    sub->add_option("TOPIC", *topic, "keys, or the name of a subcommand")->type_name("");
    sub->callback([topic, &app, &command] {
        command = [topic, &app] {
            fmt::print("{}", help_on(app, *topic));
            return exit_code::success;
        };
    });
}

}  // namespace runout
