#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "accuracy/plan.h"
#include "program/answer.h"
#include "program/case_arguments.h"
#include "program/command.h"
#include "program/common_options.h"
#include "program/interrupt.h"
#include "program/log.h"
#include "program/number_option.h"
#include "program/progress_line.h"
#include "program/refused_sections.h"
#include "program/run_keeper.h"
#include "report/text/ladder_text.h"
#include "report/text/table.h"
#include "run/run_scene.h"
#include "scene/input_files.h"
#include "scene/scene.h"
#include "store/store.h"
#include "store/write_ahead.h"

namespace runout {
namespace {

struct RunArguments {
    CaseArguments scenario;
    std::string database = "runout.db";
    std::string refused;
    OutputRules rules{};
    int frames = 60;
    bool store = true;
    bool json = false;
    bool quiet = false;
    bool pilots = true;
    double budget_s = 3600;
    int wait_s = 60;
};

RunResult simulate(const Scene& scene, const RunArguments& arguments, const InterruptWatch& interrupt) {
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
    (json ? print_json : print_text)(text + (text.ends_with('\n') ? "" : "\n"));
}

int exit_code_of(const RunResult& result) {
    if (result.status == RunStatus::interrupted) return exit_code::interrupted;
    return is_result(result.status) ? exit_code::success : exit_code::not_a_result;
}

void log_ending(const RunResult& result) {
    if (is_result(result.status)) return;
    log_warning("the run ended as {}{}{}", to_string(result.status), result.status_detail.empty() ? "" : ": ",
                result.status_detail);
}

/// A section that is to be run, as its case asks for it.
struct Section {
    SectionCase asked;
    Scene scene;
};

bool says_how_fine(const CaseSpec& spec) {
    return spec.has("run.resolution") || spec.has("run.particle_spacing_m");
}

/// What is to be run: the spacing that the case gives, or one that meets its accuracy.
RunPlan plan_of(const Section& section, const std::optional<Store>& store, const RunArguments& arguments,
                const InterruptWatch& interrupt) {
    const CaseSpec& spec = section.asked.spec;
    const Scene& scene = section.scene;
    PlanOptions options;
    if (!says_how_fine(spec)) options.target = accuracy_target(spec.accuracy, spec.place("run.accuracy"));
    if (spec.has("run.accuracy")) options.asked = spec.place("run.accuracy");
    if (store) {
        options.costs = costs_on_this_machine(*store);
        if (const auto ladder = store->find_ladder(question_hash(scene)))
            options.ladder = read_ladder(*ladder, *store);
    }
    options.longest_run_s = arguments.budget_s;
    options.pilots = arguments.pilots;
    options.interrupt = &interrupt.requested();
    return plan_run(scene, options);
}

void log_plan(const RunPlan& plan) {
    if (!plan.reason.empty()) log_info("{}", plan.reason);
    if (std::isfinite(plan.appraisal.expected_cpu_s))
        log_info("expected to take {} of CPU time", short_duration(plan.appraisal.expected_cpu_s));
}

/// Where the runs go; nowhere when they are not to be stored. The log is closed last.
struct RunDatabase {
    std::optional<WriteAheadLog> log;
    std::optional<Store> store;
    std::optional<RunKeeper> keeper;

    explicit RunDatabase(const RunArguments& arguments) {
        if (!arguments.store) return;
        log.emplace(arguments.database);
        store.emplace(arguments.database, Store::Mode::write);
        keeper.emplace(*store, arguments.database, std::chrono::seconds(arguments.wait_s));
    }
    [[nodiscard]] bool is_empty() const { return store && store->runs().empty() && store->studies().empty(); }
};

void log_place(const StoredRun& run, const RunKeeper& keeper, const std::string& asked) {
    log_info("stored as run {} in {}", run.run_id, keeper.place());
    if (keeper.is_elsewhere())
        log_warning("not in {}; when that is free: runout merge {} {}", asked, asked, keeper.place());
}

/// Simulates, stores and prints one section, and returns its exit code.
int run_section(const RunPlan& plan, const RunArguments& arguments, RunDatabase& database,
                const InterruptWatch& interrupt) {
    log_reading(plan.scene.profile);
    log_plan(plan);
    const Scene& scene = plan.scene;
    const RunResult result = simulate(scene, arguments, interrupt);
    log_ending(result);

    StoredRun run = describe_run(scene, result, plan.appraisal);
    std::exception_ptr failure;
    try {
        if (database.keeper) run.run_id = database.keeper->keep({scene, result, run, plan.pilots});
    } catch (...) {
        failure = std::current_exception();  // a full disk must not cost the answer: print it first
    }
    print_run(run, arguments.json);
    if (!arguments.json) print_text(time_table(result.phases));
    if (failure) std::rethrow_exception(failure);
    if (!database.keeper) return exit_code_of(result);
    log_place(run, *database.keeper, arguments.database);
    const int code = exit_code_of(result);
    const bool elsewhere = database.keeper->is_elsewhere() && code != exit_code::interrupted;
    return elsewhere ? exit_code::stored_elsewhere : code;
}

/// The plan of a section; none where it is one of many and its accuracy cannot be had.
std::optional<RunPlan> plan_or_refuse(const Section& section, SectionTally& tally,
                                      const std::function<RunPlan()>& plan) {
    log_assumptions(section.scene.assumed);
    try {
        return plan();
    } catch (const InputError& error) {
        if (!tally.many()) throw;
        tally.refuse(section.asked, error);
        tell_refused(tally.sections().refused.back());
        return std::nullopt;
    }
}

/// All of them, one after the other.
int run_sections(const std::vector<Section>& sections, SectionTally& tally, const RunArguments& arguments,
                 RunDatabase& database, const InterruptWatch& interrupt) {
    int failed = 0;
    bool elsewhere = false;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        if (tally.many()) log_info("section {} of {}: {}", i + 1, sections.size(), sections[i].scene.name);
        const std::optional<RunPlan> plan = plan_or_refuse(
            sections[i], tally, [&] { return plan_of(sections[i], database.store, arguments, interrupt); });
        if (!plan) continue;
        const int code = run_section(*plan, arguments, database, interrupt);
        if (code == exit_code::interrupted) return code;
        if (code == exit_code::stored_elsewhere) elsewhere = true;
        if (code == exit_code::not_a_result) ++failed;
    }
    if (failed > 0 && tally.many()) log_warning("{} of {} sections gave no result", failed, sections.size());
    if (elsewhere) return exit_code::stored_elsewhere;
    return failed > 0 ? exit_code::not_a_result : exit_code::success;
}

/// Says what became of many sections, and keeps the refused.
int end_of_many(int code, const SectionTally& tally, const RunArguments& arguments,
                std::optional<Store>& store) {
    if (!tally.many()) return code;
    if (store) store->set_sections(tally.sections());
    write_refused(arguments.refused, tally.sections().refused, arguments.rules);
    if (!tally.any_refused()) return code;
    if (arguments.json)
        log_error("{}", tally.summary());
    else
        print_text(tally.summary() + "\n");
    return code == exit_code::success ? exit_code::not_a_result : code;
}

/// One that this call has made, and that holds nothing.
void remove_database(const std::string& path) {
    std::error_code ignored;
    for (const std::string& file : database_files(path)) std::filesystem::remove(file, ignored);
}

int run(RunArguments arguments) {
    if (arguments.quiet) log_errors_only();
    const CaseSpec whole = case_from(arguments.scenario);
    arguments.rules.taken = input_files(whole);
    for (const std::string& file : database_files(arguments.database)) arguments.rules.taken.push_back(file);
    if (!arguments.refused.empty())
        check_output_place(arguments.refused, "--refused", Folder::exists, arguments.rules);
    const std::vector<SectionCase> cases = section_cases(whole);
    SectionTally tally(cases);
    std::vector<Section> sections;
    for (const SectionCase& each : cases)
        if (std::optional<Scene> scene = tally.make(each, make_scene))
            sections.push_back({each, std::move(*scene)});
    tally.require_any();

    // A database that cannot take the runs is found out now and not after an hour of work.
    std::error_code ignored;
    const bool existed = std::filesystem::exists(arguments.database, ignored);
    std::optional<RunDatabase> database;
    try {
        database.emplace(arguments);
        const InterruptWatch interrupt;
        const int code = run_sections(sections, tally, arguments, *database, interrupt);
        if (tally.many() && tally.sections().taken.empty()) tally.require_any();
        return end_of_many(code, tally, arguments, database->store);
    } catch (...) {  // a target that cannot be met leaves nothing behind
        const bool empty = !database || database->is_empty();
        database.reset();
        if (empty && !existed && arguments.store) remove_database(arguments.database);
        throw;
    }
}

}  // namespace

void add_run_command(CommandLine& program) {
    const auto arguments = std::make_shared<RunArguments>();
    Command command = program.add_command("run", "Simulate the run-out of a case or of a bare section");
    add_case_arguments(command, arguments->scenario).required();
    command.add_option("--db", &arguments->database, "Database that takes the run; made if absent")
        .value_name("PATH")
        .show_default()
        .group("Output");
    command
        .add_flag(
            "--no-store", [arguments] { arguments->store = false; }, "Leave no trace but the answer")
        .group("Output");
    command
        .add_flag(
            "--no-pilots", [arguments] { arguments->pilots = false; },
            "No coarse runs beside a spacing that is given: no error bar and no expected time unless there "
            "is "
            "a ladder")
        .group("Accuracy");
    add_number_option(command, "--budget", arguments->budget_s,
                      "CPU time that a run may take whose spacing is chosen", positive_number)
        .value_name("s")
        .group("Accuracy");
    add_number_option(command, "--wait", arguments->wait_s,
                      "How long a run that has ended waits for a database that another program holds, before "
                      "it is stored in one beside it",
                      {0, 1e6})
        .value_name("s")
        .group("Output");
    add_number_option(command, "--frames", arguments->frames,
                      "Most pictures of the particles to store for the animation of the report; 0 for none",
                      {0, 10'000})
        .group("Output");
    add_refused_option(command, arguments->refused);
    add_overwrite_option(command, arguments->rules);
    command
        .add_flag("--json", &arguments->json,
                  "Print the answer as one JSON object, one after the other for many sections")
        .group("Output");
    command.add_flag("--quiet", &arguments->quiet, "No progress, no log but errors").group("Output");
    command.set_work([arguments] { return run(*arguments); });
}

}  // namespace runout
