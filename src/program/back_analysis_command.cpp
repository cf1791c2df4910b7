#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "program/answer.h"
#include "program/command.h"
#include "program/common_options.h"
#include "program/interrupt.h"
#include "program/log.h"
#include "program/patient_store.h"
#include "report/text/back_analysis_text.h"
#include "store/store.h"
#include "store/write_ahead.h"
#include "validation/back_analysis.h"

namespace runout {
namespace {

struct BackAnalysisArguments {
    std::string folder;
    std::string database = "back-analysis.db";
    int jobs = default_jobs();
    bool quiet = false;
};

int back_analyse(const BackAnalysisArguments& arguments) {
    if (arguments.quiet) log_errors_only();
    const BackAnalysis analysis = read_back_analysis(arguments.folder);
    const WriteAheadLog log_of_writes(arguments.database);
    Store store(arguments.database, Store::Mode::write);
    InterruptWatch interrupt;
    wait_for_others(store, arguments.database, interrupt.requested());
    SuiteOptions options;
    options.jobs = arguments.jobs;
    options.interrupt = &interrupt.requested();
    options.on_run = [](int done, int total, const std::string& name) {
        log_info("{} of {} runs: {}", done, total, name);
    };
    const std::vector<long> ids = run_back_analysis(analysis, store, options);
    if (ids.empty()) {
        log_warning("interrupted; finished runs are in {} and will not be repeated", arguments.database);
        return exit_code::interrupted;
    }
    std::vector<StoredRun> runs;
    for (const long id : ids) runs.push_back(store.run(id));
    print_text(back_analysis_text(analysis, runs));
    return std::ranges::all_of(runs, [](const StoredRun& run) { return is_result(run.status); })
               ? exit_code::success
               : exit_code::not_a_result;
}

}  // namespace

void add_back_analysis_command(CommandLine& program) {
    const auto arguments = std::make_shared<BackAnalysisArguments>();
    Command command = program.add_command(
        "back-analysis", "Run a documented failure over the ranges of what is not known of it");
    command.add_option("FOLDER", &arguments->folder, "Folder with case.toml, ranges.csv and observed.csv")
        .required()
        .value_name("");
    add_database_option(command, arguments->database);
    add_jobs_option(command, arguments->jobs);
    command.add_flag("--quiet", &arguments->quiet, "No log but errors");
    command.set_work([arguments] { return back_analyse(*arguments); });
}

}  // namespace runout
