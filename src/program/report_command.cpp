#include <spdlog/spdlog.h>

#include <limits>
#include <memory>
#include <optional>

#include "core/input_error.h"
#include "program/command.h"
#include "program/output_file.h"
#include "program/run_choice.h"
#include "report/run_page.h"
#include "report/study_page.h"
#include "store/store.h"

namespace runout {
namespace {

struct ReportArguments {
    RunChoice choice;
    std::string output = "report.html";
    std::optional<long> section_id;
    std::string named;
    double width = std::numeric_limits<double>::quiet_NaN();
};

/// Runs whose name begins like that: all of a back-analysis, a validation or a study have such names.
std::vector<StoredRun> runs_named(const Store& store, const ReportArguments& arguments) {
    std::vector<StoredRun> runs = store.runs();
    std::erase_if(runs, [&](const StoredRun& run) { return !run.name.starts_with(arguments.named); });
    if (runs.empty())
        throw InputError(
            {.file = arguments.choice.database, .line = 0, .key = "--named", .value = arguments.named},
            "begins no run's name", "`runout table` lists the names");
    return runs;
}

std::string page_of(const Store& store, const ReportArguments& arguments) {
    if (!arguments.named.empty())
        return study_page("Runs named " + arguments.named, runs_named(store, arguments));
    if (arguments.section_id) {
        const std::vector<StoredRun> runs = store.runs_on_section(*arguments.section_id);
        return study_page("Runs on " + runs.back().section_origin, runs);
    }
    return run_page(read_run_data(store, chosen_run(store, arguments.choice)), arguments.width);
}

int report(const ReportArguments& arguments) {
    check_output_place(arguments.output, "-o");
    const Store store(arguments.choice.database, Store::Mode::read);
    const std::string page = page_of(store, arguments);
    write_output_file(arguments.output, "-o", page);
    spdlog::info("wrote {} ({:.1f} MB)", arguments.output, 1e-6 * static_cast<double>(page.size()));
    return exit_code::success;
}

}  // namespace

void add_report_command(CLI::App& app, Command& command) {
    const auto arguments = std::make_shared<ReportArguments>();
    CLI::App* sub =
        app.add_subcommand("report", "Write a page that shows a stored run, for any browser, offline");
    add_run_choice(*sub, arguments->choice);
    sub->add_option("--section", arguments->section_id, "Show all runs on this section instead of one run")
        ->type_name("ID")
        ->excludes("--run");
    sub->add_option("--named", arguments->named,
                    "Show all runs whose name begins with this, such as those of one study")
        ->type_name("TEXT")
        ->excludes("--run")
        ->excludes("--section");
    add_width_option(*sub, arguments->width);
    sub->add_option("-o,--output", arguments->output, "The page")->type_name("PATH")->capture_default_str();
    sub->callback([arguments, &command] { command = [arguments] { return report(*arguments); }; });
}

}  // namespace runout
