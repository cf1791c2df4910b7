#include <limits>
#include <memory>
#include <optional>

#include "program/command.h"
#include "program/common_options.h"
#include "program/log.h"
#include "program/number_option.h"
#include "program/run_choice.h"
#include "program/study_choice.h"
#include "report/page/run_page.h"
#include "report/page/study_page.h"
#include "store/store.h"

namespace runout {
namespace {

struct ReportArguments {
    RunChoice choice;
    std::string output = "report.html";
    std::optional<long> section_id;
    std::string study;
    std::vector<std::string> intensities;
    OutputRules rules{};
    double width = std::numeric_limits<double>::quiet_NaN();
};

std::vector<StoredRun> runs_of(const Store& store, const StoredStudy& study) {
    std::vector<StoredRun> runs;
    for (const StudyRow& row : store.study_rows(study.study_id))
        if (row.run_id) runs.push_back(store.run(*row.run_id));
    return runs;
}

std::string page_of(const Store& store, const ReportArguments& arguments) {
    if (!arguments.study.empty()) {
        const StoredStudy study = chosen_study(store, arguments.choice.database, arguments.study);
        return study_page("Study " + study.name, runs_of(store, study));
    }
    if (arguments.section_id) {
        const std::vector<StoredRun> runs = store.runs_on_section(*arguments.section_id);
        return study_page("Runs on " + runs.back().section_origin, runs);
    }
    RunData run = read_run_data(store, chosen_run(store, arguments.choice));
    run.intensities = intensities_from(arguments.intensities, "--intensity");
    return run_page(run, arguments.width);
}

int report(ReportArguments arguments) {
    arguments.rules.taken = database_files(arguments.choice.database);
    check_output_place(arguments.output, "-o", Folder::exists, arguments.rules);
    const Store store(arguments.choice.database, Store::Mode::read);
    const std::string page = page_of(store, arguments);
    write_output_file(arguments.output, "-o", page, arguments.rules);
    log_info("wrote {} ({:.1f} MB)", arguments.output, 1e-6 * static_cast<double>(page.size()));
    return exit_code::success;
}

}  // namespace

void add_report_command(CommandLine& program) {
    const auto arguments = std::make_shared<ReportArguments>();
    Command command =
        program.add_command("report", "Write a page that shows a stored run, for any browser, offline");
    add_run_choice(command, arguments->choice);
    add_id_option(command, "--section", arguments->section_id,
                  "Show all runs on this section instead of one run")
        .excludes("--run");
    command.add_option("--study", &arguments->study, "Show all scenarios of this study instead of one run")
        .value_name("NAME|ID")
        .excludes("--run")
        .excludes("--section");
    add_width_option(command, arguments->width);
    command.add_option("-o,--output", &arguments->output, "The page").value_name("PATH").show_default();
    add_intensity_option(command, arguments->intensities).excludes("--section").excludes("--study");
    add_overwrite_option(command, arguments->rules);
    command.set_work([arguments] { return report(*arguments); });
}

}  // namespace runout
