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

/// Every section of the case; a mistake in one is found before any has run.
std::vector<Scene> scenes_of(const CaseArguments& arguments) {
    std::vector<Scene> scenes;
    for (const CaseSpec& spec : section_cases(case_from(arguments))) scenes.push_back(make_scene(spec));
    return scenes;
}

/// Simulates, stores and prints one section, and returns its exit code.
int run_section(const Scene& scene, const RunArguments& arguments, std::optional<Store>& store) {
    log_assumptions(scene.assumed);
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

int run(const RunArguments& arguments) {
    if (arguments.quiet) spdlog::set_level(spdlog::level::err);
    const std::vector<Scene> scenes = scenes_of(arguments.scenario);

    // A database that cannot take the runs is found out now and not after an hour of work.
    std::optional<Store> store;
    if (arguments.store) store.emplace(arguments.database, Store::Mode::write);

    if (scenes.size() == 1) return run_section(scenes.front(), arguments, store);
    int failed = 0;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        spdlog::info("section {} of {}: {}", i + 1, scenes.size(), scenes[i].name);
        const int code = run_section(scenes[i], arguments, store);
        if (code == exit_code::interrupted) return code;
        if (code != exit_code::success) ++failed;
    }
    if (failed > 0) spdlog::warn("{} of {} sections gave no result", failed, scenes.size());
    return failed > 0 ? exit_code::not_a_result : exit_code::success;
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
    sub->add_flag("--json", arguments->json,
                  "Print the answer as one JSON object, one after the other for many sections")
        ->group("Output");
    sub->add_flag("--quiet", arguments->quiet, "No progress, no log but errors")->group("Output");
    sub->callback([arguments, &command] { command = [arguments] { return run(*arguments); }; });
}

}  // namespace runout
