#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <exception>
#include <memory>
#include <optional>

#include "measures/run.h"
#include "program/case_arguments.h"
#include "program/command.h"
#include "program/interrupt.h"
#include "program/progress_line.h"
#include "report/table.h"
#include "report/time_table.h"
#include "scene/scene.h"
#include "store/store.h"

namespace runout {
namespace {

struct RunArguments {
    CaseArguments scenario;
    std::string database = "runout.db";
    int frames = 60;
    bool store = true;
    bool json = false;
    bool quiet = false;
};

RunResult simulate(const Scene& scene, const RunArguments& arguments) {
    InterruptWatch interrupt;
    ProgressLine line(arguments.quiet ? ProgressLine::Style::none : ProgressLine::style_of_stderr());
    RunControl control;
    control.on_progress = [&line](const Progress& progress) { line.show(progress); };
    control.interrupt = &interrupt.requested();
    control.frames = arguments.store ? arguments.frames : 0;
    RunResult result = run_scene(scene, control);
    line.finish();
    return result;
}

void print_run(const StoredRun& run, bool json) {
    const std::string text = json ? run_json(run) : run_summary(run);
    fmt::print("{}{}", text, text.ends_with('\n') ? "" : "\n");
}

int exit_code_of(const RunResult& result) {
    if (result.status == RunStatus::interrupted) return exit_code::interrupted;
    return is_result(result.status) ? exit_code::success : exit_code::not_a_result;
}

void log_ending(const RunResult& result) {
    if (is_result(result.status)) return;
    spdlog::warn("the run ended as {}{}{}", to_string(result.status),
                 result.status_detail.empty() ? "" : ": ", result.status_detail);
}

int run(const RunArguments& arguments) {
    if (arguments.quiet) spdlog::set_level(spdlog::level::err);
    const Scene scene = make_scene(case_from(arguments.scenario));
    log_assumptions(scene.assumed);

    // A database that cannot take the run is found out now and not after an hour of work.
    std::optional<Store> store;
    if (arguments.store) store.emplace(arguments.database, Store::Mode::write);

    const RunResult result = simulate(scene, arguments);
    log_ending(result);

    StoredRun run = describe_run(scene, result);
    std::exception_ptr failure;
    try {
        if (store) run = store->run(store->add(scene, result));
    } catch (...) {
        failure = std::current_exception();  // a full disk must not cost the answer: print it first
    }
    print_run(run, arguments.json);
    if (!arguments.json) fmt::print("{}", time_table(result.phases));
    if (failure) std::rethrow_exception(failure);
    if (store) spdlog::info("stored as run {} in {}", run.run_id, arguments.database);
    return exit_code_of(result);
}

}  // namespace

void add_run_command(CLI::App& app, Command& command) {
    const auto arguments = std::make_shared<RunArguments>();
    CLI::App* sub = app.add_subcommand("run", "Simulate the run-out of a case or of a bare section");
    add_case_arguments(*sub, arguments->scenario);
    sub->add_option("--db", arguments->database, "Database that takes the run; made if absent")
        ->type_name("PATH")
        ->capture_default_str()
        ->group("Output");
    sub->add_flag_callback(
           "--no-store", [arguments] { arguments->store = false; }, "Leave no trace but the answer")
        ->group("Output");
    sub->add_option("--frames", arguments->frames,
                    "Most pictures of the particles to store for the animation of the report; 0 for none")
        ->type_name("number")
        ->check(CLI::Range(0, 10000))
        ->capture_default_str()
        ->group("Output");
    sub->add_flag("--json", arguments->json, "Print the answer as one JSON object")->group("Output");
    sub->add_flag("--quiet", arguments->quiet, "No progress, no log but errors")->group("Output");
    sub->callback([arguments, &command] { command = [arguments] { return run(*arguments); }; });
}

}  // namespace runout
