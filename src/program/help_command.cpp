#include <fmt/format.h>

#include <memory>
#include <optional>
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

std::string help_on(const CommandLine& program, const std::string& topic) {
    if (topic.empty()) return program.help();
    if (topic == "keys") return key_table();
    if (const std::optional<std::string> help = program.help_on(topic)) return *help;
    throw InputError({.file = {}, .line = 0, .key = "help", .value = topic}, "is not a topic",
                     "valid: keys, " + program.command_names());
}

}  // namespace

void add_help_command(CommandLine& program) {
    const auto topic = std::make_shared<std::string>();
    Command command =
        program.add_command("help", "Explain a subcommand, or all keys of a case file: runout help keys");
    command.add_option("TOPIC", topic.get(), "keys, or the name of a subcommand").value_name("");
    command.set_work([topic, &program] {
        fmt::print("{}", help_on(program, *topic));
        return exit_code::success;
    });
}

}  // namespace runout
