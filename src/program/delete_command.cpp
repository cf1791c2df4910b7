#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <string_view>

#include "core/input_error.h"
#include "core/printable.h"
#include "program/answer.h"
#include "program/command.h"
#include "program/common_options.h"
#include "program/number_option.h"
#include "program/study_choice.h"
#include "store/remove_runs.h"
#include "store/store.h"

namespace runout {
namespace {

constexpr std::size_t runs_shown = 20;

struct DeleteArguments {
    std::string database;
    std::vector<long> run_ids;
    std::string study;
    std::string older_than;
    bool yes = false;
};

/// Whether the text has this form, in which a 0 stands for any digit.
bool has_form(std::string_view text, std::string_view form) {
    return std::ranges::equal(text, form, [](char letter, char expected) {
        return expected == '0' ? letter >= '0' && letter <= '9' : letter == expected;
    });
}

/// "90d": up to six digits and a unit (w, d, h).
std::optional<std::chrono::hours> age_of(std::string_view text) {
    constexpr std::size_t most_digits = 6;
    if (text.size() < 2 || text.size() > most_digits + 1) return std::nullopt;
    const char unit = text.back();
    const std::string_view digits = text.substr(0, text.size() - 1);
    if (!has_form(digits, std::string(digits.size(), '0'))) return std::nullopt;
    if (unit != 'w' && unit != 'd' && unit != 'h') return std::nullopt;
    int count = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), count);
    return std::chrono::hours(count) * (unit == 'w' ? 168 : unit == 'd' ? 24 : 1);
}

/// The instant that an age lies back, or that "2024-05-31" names, as ISO 8601.
std::string instant_of(const std::string& text) {
    if (has_form(text, "0000-00-00") || has_form(text, "0000-00-00T00:00:00Z")) return text;
    const std::optional<std::chrono::hours> age = age_of(text);
    if (!age)
        throw InputError(option_place("--older-than", text), "is no age and no date",
                         "give weeks, days or hours such as 90d, or 2024-05-31");
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::now() - *age));
}

RunSelection selection_of(const DeleteArguments& arguments) {
    const int ways = (arguments.run_ids.empty() ? 0 : 1) + (arguments.study.empty() ? 0 : 1) +
                     (arguments.older_than.empty() ? 0 : 1);
    if (ways != 1)
        throw InputError({.file = {}, .line = 0, .key = "delete", .value = {}},
                         "must be told in one way what is to go", "give --run, --study or --older-than");
    RunSelection selection;
    for (const long id : arguments.run_ids)  // one that is named twice goes once
        if (std::ranges::find(selection.run_ids, id) == selection.run_ids.end())
            selection.run_ids.push_back(id);
    if (!arguments.study.empty())
        selection.study_id =
            chosen_study(Store(arguments.database, Store::Mode::read), arguments.database, arguments.study)
                .study_id;
    if (!arguments.older_than.empty()) selection.ended_before_utc = instant_of(arguments.older_than);
    return selection;
}

std::string text_of(const Removal& removal, const std::string& database) {
    std::string text = fmt::format("To be removed from {}: {} run{}\n", printable(database),
                                   removal.runs.size(), removal.runs.size() == 1 ? "" : "s");
    for (std::size_t i = 0; i < std::min(runs_shown, removal.runs.size()); ++i) {
        const DoomedRun& run = removal.runs[i];
        text += fmt::format("  run {}: {}, {}, ended {}\n", run.run_id, printable(run.name),
                            printable(run.status), printable(run.ended_utc));
    }
    if (removal.runs.size() > runs_shown)
        text += fmt::format("  and {} more\n", removal.runs.size() - runs_shown);
    for (const std::string& ladder : removal.ladders)
        text += fmt::format("  the study of accuracy {}, which rests on one of them\n", printable(ladder));
    if (removal.study_id) text += fmt::format("  the study {}\n", printable(removal.study));
    if (removal.shared_runs > 0)
        text += fmt::format("Kept: {} of its runs, which another study has too\n", removal.shared_runs);
    return text;
}

/// Asks a person; without one, --yes must have said it.
bool is_wanted(const DeleteArguments& arguments) {
    if (arguments.yes) return true;
    if (isatty(STDIN_FILENO) == 0)
        throw InputError({.file = arguments.database, .line = 0, .key = {}, .value = {}},
                         "is left as it is: nobody can be asked here", "give --yes");
    fmt::print(stderr, "Remove? They cannot be brought back. [y/N] ");
    std::string answer;
    std::getline(std::cin, answer);
    return answer == "y" || answer == "yes";
}

int delete_runs(const DeleteArguments& arguments) {
    const Removal removal = plan_removal(arguments.database, selection_of(arguments));
    print_text(text_of(removal, arguments.database));
    std::fflush(stdout);
    if (removal.runs.empty() && !removal.study_id) return exit_code::success;
    if (!is_wanted(arguments)) {
        print_text("Nothing was removed.\n");
        return exit_code::success;
    }
    const Removed removed = remove_runs(arguments.database, removal);
    print_text(removed.space_given_back ? fmt::format("Removed; the file is {:.3g} MB smaller.\n",
                                                      1e-6 * static_cast<double>(removed.bytes_given_back))
                                        : "Removed; the disk has no room for making the file smaller.\n");
    return exit_code::success;
}

}  // namespace

void add_delete_command(CommandLine& program) {
    const auto arguments = std::make_shared<DeleteArguments>();
    Command command =
        program.add_command("delete", "Remove stored runs whole, after asking, and give their space back");
    add_database_argument(command, arguments->database);
    add_id_option(command, "--run", arguments->run_ids, "These runs; may be repeated");
    command
        .add_option("--study", &arguments->study,
                    "A study with its runs, but those that another study has too")
        .value_name("NAME|ID");
    command
        .add_option(
            "--older-than", &arguments->older_than,
            "Runs that ended longer ago: weeks, days or hours (8w, 90d, 12h), or before a date (2024-05-31)")
        .value_name("AGE|DATE");
    command.add_flag("--yes", &arguments->yes, "Do not ask");
    command.set_work([arguments] { return delete_runs(*arguments); });
}

}  // namespace runout
