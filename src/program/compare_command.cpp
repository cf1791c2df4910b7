#include <fmt/format.h>

#include <limits>
#include <memory>

#include "core/input_error.h"
#include "program/answer.h"
#include "program/command.h"
#include "program/common_options.h"
#include "program/log.h"
#include "program/run_choice.h"
#include "report/compare/comparison.h"
#include "store/store.h"

namespace runout {
namespace {

struct CompareArguments {
    RunChoice choice;
    std::string output;
    OutputRules rules{};
    double width = std::numeric_limits<double>::quiet_NaN();
};

int compare(CompareArguments arguments) {
    arguments.rules.taken = database_files(arguments.choice.database);
    if (!arguments.output.empty())
        check_output_place(arguments.output, "-o", Folder::exists, arguments.rules);
    const Store store(arguments.choice.database, Store::Mode::read);
    const RunData run = read_run_data(store, chosen_run(store, arguments.choice));
    const std::string refusal = comparison_refusal(run);
    if (!refusal.empty())
        throw InputError({.file = arguments.choice.database,
                          .line = 0,
                          .key = "run",
                          .value = std::to_string(run.run.run_id)},
                         "cannot be compared: " + refusal, "name a settled run with --run");
    const Comparison comparison = compare_run(run, arguments.width);
    print_text(comparison_text(run, comparison));
    if (arguments.output.empty()) return exit_code::success;
    write_output_file(arguments.output, "-o", comparison_page(run, comparison), arguments.rules);
    log_info("wrote {}", arguments.output);
    return exit_code::success;
}

}  // namespace

void add_compare_command(CommandLine& program) {
    const auto arguments = std::make_shared<CompareArguments>();
    Command command = program.add_command(
        "compare", "Put a stored run beside empirical relations and documented landslides");
    add_run_choice(command, arguments->choice);
    add_width_option(command, arguments->width);
    command.add_option("-o,--output", &arguments->output, "Also write a page with the chart")
        .value_name("PATH");
    add_overwrite_option(command, arguments->rules);
    command.set_work([arguments] { return compare(*arguments); });
}

}  // namespace runout
