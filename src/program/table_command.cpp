#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "core/input_error.h"
#include "program/answer.h"
#include "program/command.h"
#include "program/common_options.h"
#include "program/number_option.h"
#include "program/study_choice.h"
#include "report/text/run_out_table.h"
#include "report/text/table.h"
#include "store/store.h"

namespace runout {
namespace {

struct TableArguments {
    std::string database;
    std::string study;
    std::string format = "text";
    bool list = false;
    RunOutTableOptions layout;
};

template <class Format, std::size_t count>
Format format_of(const std::string& name, const std::array<std::pair<const char*, Format>, count>& known) {
    std::string valid;
    for (const auto& [word, format] : known) {
        if (name == word) return format;
        valid += fmt::format("{}{}", valid.empty() ? "" : ", ", word);
    }
    throw InputError({.file = {}, .line = 0, .key = "--format", .value = name}, "is not known",
                     "valid: " + valid);
}

constexpr std::array list_formats = {std::pair{"text", TableFormat::text}, std::pair{"csv", TableFormat::csv},
                                     std::pair{"json", TableFormat::json}};
constexpr std::array study_formats = {
    std::pair{"text", RunOutTableFormat::text}, std::pair{"csv", RunOutTableFormat::csv},
    std::pair{"json", RunOutTableFormat::json}, std::pair{"markdown", RunOutTableFormat::markdown}};

int show_study(const TableArguments& arguments) {
    const RunOutTableFormat format = format_of(arguments.format, study_formats);
    const Store store(arguments.database, Store::Mode::read);
    const StoredStudy study = chosen_study(store, arguments.database, arguments.study);
    const std::string table =
        run_out_table(study.name, store.study_rows(study.study_id), arguments.layout, format);
    (format == RunOutTableFormat::json ? print_json : print_text)(table);
    return exit_code::success;
}

int show_runs(const TableArguments& arguments) {
    const TableFormat format = format_of(arguments.format, list_formats);
    const std::string table = run_table(Store(arguments.database, Store::Mode::read).runs(), format);
    (format == TableFormat::json ? print_json : print_text)(table + (table.ends_with('\n') ? "" : "\n"));
    return exit_code::success;
}

/// A database that holds one study and nothing else is about that.
int show_table(TableArguments arguments) {
    if (arguments.study.empty() && !arguments.list) {
        const std::vector<StoredStudy> studies = Store(arguments.database, Store::Mode::read).studies();
        if (studies.size() == 1) arguments.study = studies.front().name;
    }
    return arguments.study.empty() ? show_runs(arguments) : show_study(arguments);
}

}  // namespace

void add_table_command(CommandLine& program) {
    const auto arguments = std::make_shared<TableArguments>();
    Command command =
        program.add_command("table", "The run-out table of a study, or a list of the runs of a database");
    add_database_argument(command, arguments->database);
    command
        .add_option("--study", &arguments->study,
                    "Which study; by default the only one, else every run is listed")
        .value_name("NAME|ID");
    command.add_flag("--list", &arguments->list, "List every run, study or not");
    command
        .add_option("--rows", &arguments->layout.rows,
                    "What the rows of the table are: section, slope_angle_deg or a varied key")
        .value_name("word");
    command
        .add_option("--columns", &arguments->layout.columns,
                    "What its columns are: drop_height_m, source_type or a varied key")
        .value_name("word");
    add_number_option(command, "--distance", arguments->layout.distances,
                      "Tell the probability of reaching this distance", not_negative)
        .value_name("m");
    command.add_option("--format", &arguments->format, "text, csv, json, or (of a study) markdown")
        .value_name("word")
        .show_default();
    command.set_work([arguments] { return show_table(*arguments); });
}

}  // namespace runout
