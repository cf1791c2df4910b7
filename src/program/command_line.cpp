#include "program/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/input_error.h"

namespace runout {

CommandOption& CommandOption::required() {
    option_->required();
    return *this;
}

CommandOption& CommandOption::value_name(const std::string& name) {
    option_->type_name(name);
    return *this;
}

CommandOption& CommandOption::group(const std::string& heading) {
    option_->group(heading);
    return *this;
}

CommandOption& CommandOption::show_default() {
    option_->capture_default_str();
    return *this;
}

CommandOption& CommandOption::one_value_a_use() {
    option_->allow_extra_args(false);
    return *this;
}

CommandOption& CommandOption::excludes(const std::string& name) {
    option_->excludes(name);
    return *this;
}

CommandOption& CommandOption::default_text(const std::string& text) {
    option_->default_str(text);
    return *this;
}

CommandOption Command::add_option(const std::string& names, OptionTarget target, const std::string& help) {
    const auto add = [&]<class Target>(Target& to) -> CLI::Option* {
        if constexpr (std::is_pointer_v<Target>)
            return app_->add_option(names, *to, help);
        else if constexpr (std::is_same_v<Target, std::function<void(const std::string&)>>)
            return app_->add_option_function<std::string>(names, to, help);
        else
            return app_->add_option_function<std::vector<std::string>>(names, to, help);
    };
    return CommandOption(*std::visit(add, target));
}

CommandOption Command::add_flag(const std::string& name, FlagTarget target, const std::string& help) {
    if (bool* const* given = std::get_if<bool*>(&target))
        return CommandOption(*app_->add_flag(name, **given, help));
    return CommandOption(*app_->add_flag_callback(name, std::get<std::function<void()>>(target), help));
}

void Command::set_footer(const std::string& text) {
    app_->footer(text);
}

void Command::set_work(Work work) {
    app_->callback([chosen = chosen_, work = std::move(work)] { *chosen = work; });
}

struct CommandLine::Parser {
    CLI::App app;
    Command::Work chosen;  ///< of the command that was named; set while the words are read
};

namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App*) { return true; });
}

const CLI::App* command_named(const CLI::App& app, const std::string& name) {
    for (const CLI::App* command : commands_of(app))
        if (command->get_name() == name) return command;
    return nullptr;
}

/// What is wrong with the words, of which this is the first.
std::string sentence(const CLI::App& app, const CLI::ParseError& error, const std::string& names,
                     const std::string& first_word) {
    const bool is_word = !first_word.empty() && !first_word.starts_with('-');
    if (is_word && command_named(app, first_word) == nullptr)
        return fmt::format("{} is not a subcommand; known are {}", first_word, names);
    return fmt::format("{}; see runout --help", error.what());
}

/// "-o=page.html" would write a file of the name "=page.html".
void refuse_short_assignments(int argc, char** argv) {
    for (int i = 1; i < argc && std::string_view(argv[i]) != "--"; ++i) {
        const std::string word = argv[i];
        if (word.size() < 3 || word[0] != '-' || word[1] == '-' || word[2] != '=') continue;
        throw InputError({.file = {}, .line = 0, .key = {}, .value = word},
                         "has = after an option of one letter",
                         fmt::format("write {} {}", word.substr(0, 2), word.substr(3)));
    }
}

/// As of a variable of the shell that is not set: it says nothing, and is no name of a file.
void refuse_empty_values(CLI::App& app) {
    const auto check = [](const std::string& value) {
        return value.empty() ? std::string("is empty; give a value, or leave it out") : std::string();
    };
    for (CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
        for (CLI::Option* option : sub->get_options())
            if (option->get_items_expected_max() > 0) option->check(check);
}

}  // namespace

CommandLine::CommandLine(const std::string& program, const std::string& purpose)
    : parser_(new Parser{.app = CLI::App(purpose, program), .chosen = {}}) {
    parser_->app.require_subcommand(1);
    parser_->app.fallthrough();  // options of the program may follow those of a subcommand
}

CommandLine::~CommandLine() = default;

void CommandLine::set_version(const std::string& text) {
    parser_->app.set_version_flag("--version", text);
}

void CommandLine::add_flag(const std::string& name, const std::function<void()>& given,
                           const std::string& help) {
    parser_->app.add_flag_callback(name, given, help);
}

void CommandLine::set_footer(const std::string& text) {
    parser_->app.footer(text);
}

Command CommandLine::add_command(const std::string& name, const std::string& purpose) {
    return {*parser_->app.add_subcommand(name, purpose), parser_->chosen};
}

std::string CommandLine::command_names() const {
    std::string names;
    for (const CLI::App* command : commands_of(parser_->app))
        names += (names.empty() ? "" : ", ") + command->get_name();
    return names;
}

std::string CommandLine::help() const {
    // Not app.help(): that would explain the subcommand at hand, which is `help`.
    const CLI::App& app = parser_->app;
    return app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal);
}

std::optional<std::string> CommandLine::help_on(const std::string& command) const {
    const CLI::App* named = command_named(parser_->app, command);
    if (named == nullptr) return std::nullopt;
    return named->help(parser_->app.get_name());
}

int CommandLine::run(int argc, char** argv) {
    refuse_empty_values(parser_->app);
    refuse_short_assignments(argc, argv);
    try {
        parser_->app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return parser_->app.exit(error);  // --help and --version
        throw UsageError(sentence(parser_->app, error, command_names(), argc > 1 ? argv[1] : ""));
    }
    return parser_->chosen();
}

}  // namespace runout
