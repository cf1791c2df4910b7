#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "core/input_error.h"
#include "core/output_folder.h"
#include "core/printable.h"
#include "program/answer.h"
#include "program/command.h"
#include "program/common_options.h"
#include "program/interrupt.h"
#include "program/log.h"
#include "program/patient_store.h"
#include "report/page/validation_page.h"
#include "store/store.h"
#include "store/write_ahead.h"
#include "validation/run_suite.h"
#include "validation/suite.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

struct ValidateArguments {
    std::vector<std::string> names;
    std::string cases = "cases";
    std::string database = "validation.db";
    std::string page;
    OutputRules rules{};
    int jobs = default_jobs();
    bool quick = false;
    bool quiet = false;
};

std::string known_names() {
    std::string names;
    for (const ValidationCase& item : validation_cases()) {
        names += fmt::format("{}{}", names.empty() ? "" : ", ", item.name);
    }
    return names;
}

std::vector<ValidationCase> chosen_cases(const std::vector<std::string>& names) {
    const auto all = validation_cases();
    if (names.empty()) return {all.begin(), all.end()};
    std::vector<ValidationCase> chosen;
    for (const std::string& name : names) {
        const auto found =
            std::ranges::find_if(all, [&](const ValidationCase& item) { return name == item.name; });
        if (found == all.end())
            throw InputError(option_place("validate", name), "is not a case of the suite",
                             "valid: " + known_names());
        chosen.push_back(*found);
    }
    return chosen;
}

/// The folder of the pictures of a page: of its name, beside it.
fs::path pictures_of(const fs::path& page) {
    return page.parent_path() / page.stem();
}

/// The databases and the files of the cases are not to be written over.
OutputRules rules_of(const ValidateArguments& arguments) {
    OutputRules rules = arguments.rules;
    rules.taken = database_files(arguments.database);
    std::error_code none_there;
    for (const auto& entry : fs::recursive_directory_iterator(arguments.cases, none_there))
        if (entry.is_regular_file()) rules.taken.push_back(entry.path().string());
    return rules;
}

/// What would only be found out after all runs.
void check_places(const ValidateArguments& arguments) {
    if (!fs::is_directory(arguments.cases))
        throw InputError(option_place("--cases", arguments.cases), "is not a folder",
                         "give the folder of cases that comes with the program");
    if (arguments.page.empty()) return;
    check_output_place(arguments.page, "--output", Folder::exists, arguments.rules);
    std::error_code none_there;
    for (const auto& entry : fs::directory_iterator(pictures_of(arguments.page), none_there))
        if (entry.path().extension() == ".svg")
            check_output_place(entry.path().string(), "--output", Folder::exists, arguments.rules);
}

/// The page and, in a folder of its name beside it, the pictures.
void write_page(const std::vector<CaseReport>& reports, const ValidateArguments& arguments) {
    const fs::path page(arguments.page);
    const fs::path pictures = pictures_of(page);
    make_output_folder(pictures.string(), "--output");
    for (const auto& [name, picture] : validation_pictures(reports))
        write_output_file((pictures / file_name_part(name)).string(), "--output", picture, arguments.rules);
    const std::string command = fmt::format(
        "runout validate{}{} --output {}", arguments.quick ? " --quick" : "",
        arguments.names.empty() ? "" : fmt::format(" {}", fmt::join(arguments.names, " ")), arguments.page);
    write_output_file(arguments.page, "--output", validation_page(reports, command, page.stem().string()),
                      arguments.rules);
}

bool all_within_bands(const std::vector<CaseReport>& reports) {
    return std::ranges::all_of(
        reports, [](const CaseReport& report) { return std::ranges::all_of(report.entries, within_band); });
}

int validate(ValidateArguments arguments) {
    if (arguments.quiet) log_errors_only();
    const std::vector<ValidationCase> cases = chosen_cases(arguments.names);
    arguments.rules = rules_of(arguments);
    check_places(arguments);
    const WriteAheadLog log_of_writes(arguments.database);
    Store store(arguments.database, Store::Mode::write);
    InterruptWatch interrupt;
    wait_for_others(store, arguments.database, interrupt.requested());
    SuiteOptions options;
    options.cases_folder = arguments.cases;
    options.quick = arguments.quick;
    options.jobs = arguments.jobs;
    options.interrupt = &interrupt.requested();
    options.on_run = [](int done, int total, const std::string& name) {
        log_info("{} of {} runs: {}", done, total, name);
    };
    const std::vector<CaseReport> reports = run_suite(cases, store, options);
    if (reports.empty()) {
        log_warning("interrupted; finished runs are in {} and will not be repeated", arguments.database);
        return exit_code::interrupted;
    }
    print_text(validation_table(reports));
    if (!arguments.page.empty()) write_page(reports, arguments);
    return all_within_bands(reports) ? exit_code::success : exit_code::not_a_result;
}

}  // namespace

void add_validate_command(CommandLine& program) {
    const auto arguments = std::make_shared<ValidateArguments>();
    Command command = program.add_command(
        "validate", "Hold the program against exact mechanics, the paper and laboratory measurements");
    command.add_option("NAME", &arguments->names, "Cases of the suite; all if none is named").value_name("");
    command.add_flag("--quick", &arguments->quick, "The part of the suite that takes minutes");
    command.add_option("--cases", &arguments->cases, "Folder of the cases").value_name("PATH").show_default();
    add_database_option(command, arguments->database);
    command.add_option("-o,--output", &arguments->page, "Write a Markdown page, with pictures beside it")
        .value_name("PATH");
    add_overwrite_option(command, arguments->rules);
    add_jobs_option(command, arguments->jobs);
    command.add_flag("--quiet", &arguments->quiet, "No log but errors");
    command.set_work([arguments] { return validate(*arguments); });
}

}  // namespace runout
