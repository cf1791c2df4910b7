#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace runout {

// The words on the command line. CLI11 reads them, behind this header: it is a large library of headers, and
// only command_line.cpp includes it.

/// The command line is not one that the program knows; the message is a sentence for the user.
class UsageError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Where the words of an option go; numbers are read by program/number_option.h. The variable keeps what it
/// holds when the option is not given; it must live until the command has been done. Of a vector, each use of
/// the option adds a word. A function is called while the command line is read, with the one word or with all
/// of them.
using OptionTarget =
    std::variant<std::string*, std::vector<std::string>*, std::function<void(const std::string&)>,
                 std::function<void(const std::vector<std::string>&)>>;

/// Where it is noted that a flag was given: true, or the function is called.
using FlagTarget = std::variant<bool*, std::function<void()>>;

/// An option that was declared; each function says one thing more of it and returns it.
class CommandOption {
  public:
    explicit CommandOption(CLI::Option& option) : option_(&option) {}

    /// The command is refused without it.
    CommandOption& required();
    /// What stands for the value in the help, such as "PATH" or a unit; nothing for "".
    CommandOption& value_name(const std::string& name);
    /// The heading under which the help lists it; "Options" unless said otherwise.
    CommandOption& group(const std::string& heading);
    /// The help shows what the variable holds now as the default.
    CommandOption& show_default();
    /// The help shows this as the default.
    CommandOption& default_text(const std::string& text);
    /// Each use takes one value only, so that a positional may follow.
    CommandOption& one_value_a_use();
    /// Refused when that option is given too.
    CommandOption& excludes(const std::string& name);

  private:
    CLI::Option* option_;
};

/// A command of the program while its options are declared. Copies speak of the same command.
class Command {
  public:
    using Work = std::function<int()>;

    Command(CLI::App& app, Work& chosen) : app_(&app), chosen_(&chosen) {}

    /// `names` is "--db", "-o,--output", or a positional such as "FILE".
    CommandOption add_option(const std::string& names, OptionTarget target, const std::string& help);
    CommandOption add_flag(const std::string& name, FlagTarget target, const std::string& help);
    /// Text below the options in the help.
    void set_footer(const std::string& text);
    /// What is done when this command is the one that was named: returns the exit code, throws InputError.
    void set_work(Work work);

  private:
    CLI::App* app_;
    Work* chosen_;
};

/// The program's commands, and the reading of the words that name one of them.
class CommandLine {
  public:
    CommandLine(const std::string& program, const std::string& purpose);
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    /// What --version prints.
    void set_version(const std::string& text);
    /// A flag of the program, which may stand before or after those of a command.
    void add_flag(const std::string& name, const std::function<void()>& given, const std::string& help);
    /// Text below the commands in the help.
    void set_footer(const std::string& text);
    Command add_command(const std::string& name, const std::string& purpose);

    /// The names of the commands in the order they were added, with commas between them.
    [[nodiscard]] std::string command_names() const;
    /// The help on the program; on one command, or nothing if there is none of that name.
    [[nodiscard]] std::string help() const;
    [[nodiscard]] std::optional<std::string> help_on(const std::string& command) const;

    /// Does the work of the command that the words name, and returns its exit code. --help and --version are
    /// printed and are a success. Throws UsageError, InputError where a value is empty or behind "-o=", and
    /// what the work throws.
    int run(int argc, char** argv);

  private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
};

}  // namespace runout
