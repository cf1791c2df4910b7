#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "accuracy/check_choices.h"
#include "accuracy/ladder.h"
#include "accuracy/methods.h"
#include "accuracy/price.h"
#include "accuracy/study.h"
#include "accuracy/survey.h"
#include "core/output_folder.h"
#include "core/printable.h"
#include "program/answer.h"
#include "program/case_arguments.h"
#include "program/command.h"
#include "program/common_options.h"
#include "program/interrupt.h"
#include "program/log.h"
#include "program/number_option.h"
#include "program/patient_store.h"
#include "report/chart/svg_chart.h"
#include "report/page/accuracy_page.h"
#include "report/text/coverage_text.h"
#include "report/text/ladder_text.h"
#include "scene/input_files.h"
#include "scene/scene.h"
#include "store/store.h"
#include "store/write_ahead.h"
#include "stress/random_slopes.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

constexpr double usual_finest = 45;  // of a survey

struct AccuracyArguments {
    CaseArguments scenario;
    std::string target = "5%";
    std::string database = "runout.db";
    std::string chart;
    std::string page;
    std::string survey;
    OutputRules rules{};
    double budget_s = 300;
    double at_least_to = 0;
    int lattices = 3;
    int slopes = 0;
    std::uint64_t seed = 1;
    bool methods = false;
    bool check = false;
    bool json = false;
    bool quiet = false;
};

/// The files that this call reads, and the database.
std::vector<std::string> taken_by(const AccuracyArguments& arguments) {
    std::vector<std::string> taken = database_files(arguments.database);
    if (arguments.scenario.file.empty()) return taken;
    for (const std::string& file : input_files(case_from(arguments.scenario))) taken.push_back(file);
    return taken;
}

/// What would only be found out after all runs. Each output is taken for those after it.
void check_places(const AccuracyArguments& arguments) {
    OutputRules rules = arguments.rules;
    for (const auto& [name, path] :
         {std::pair{"--chart", arguments.chart}, std::pair{"--page", arguments.page},
          std::pair{"--survey", arguments.survey}}) {
        if (path.empty()) continue;
        check_output_place(path, name, Folder::exists, rules);
        rules.taken.push_back(path);
    }
}

/// A case says how fine it wants to be run; a ladder asks at every spacing.
Scene scene_of(const AccuracyArguments& arguments) {
    for (const Override& entry : arguments.scenario.overrides)
        for (const char* key :
             {"run.accuracy", "run.resolution", "run.particle_spacing_m", "run.lattice_seed"})
            if (entry.key == key)
                throw InputError({.file = entry.option, .line = 0, .key = key, .value = entry.text},
                                 "does not apply to a ladder, which runs at many spacings and lattices",
                                 "leave it out, and give --target");
    Scene scene = make_scene(case_from(arguments.scenario));
    log_reading(scene.profile);
    log_assumptions(scene.assumed);
    return scene;
}

void say(const AccuracyArguments& arguments, const std::string& text) {
    if (arguments.json) return;
    print_text(text);
    std::fflush(stdout);
}

Ladder climb_and_tell(const Scene& scene, Store& store, const AccuracyArguments& arguments,
                      const std::atomic<bool>& interrupt) {
    LadderOptions options;
    options.target = accuracy_target(arguments.target, option_place("--target", arguments.target));
    options.lattices = arguments.lattices;
    options.budget_s = arguments.budget_s;
    options.at_least_to = arguments.at_least_to;
    options.interrupt = &interrupt;
    std::optional<RungSummary> before;
    options.on_rung = [&](const RungSummary& rung) {
        say(arguments, rung_table_line(rung, before ? &*before : nullptr));
        before = rung;
    };
    say(arguments, rung_table_head());
    return climb(scene, store, options);
}

void compare_and_tell(const Scene& scene, Ladder& ladder, Store& store, const AccuracyArguments& arguments,
                      const std::atomic<bool>& interrupt) {
    MethodOptions options;
    options.interrupt = &interrupt;
    options.on_point = [&](const MethodPoint& point) { say(arguments, method_table_line(point)); };
    say(arguments, fmt::format("\n{}", method_table_head()));
    compare_methods(scene, ladder, store, options);
}

int study(const AccuracyArguments& arguments) {
    const Scene scene = scene_of(arguments);
    accuracy_target(arguments.target, option_place("--target", arguments.target));
    const WriteAheadLog log_of_writes(arguments.database);
    Store store(arguments.database, Store::Mode::write);
    InterruptWatch interrupt;
    wait_for_others(store, arguments.database, interrupt.requested());
    Ladder ladder = climb_and_tell(scene, store, arguments, interrupt.requested());
    const std::vector<Price> prices = price_list(ladder);
    say(arguments, fmt::format("\n{}", ladder_summary(ladder, prices)));
    if (arguments.methods && !interrupt.requested())
        compare_and_tell(scene, ladder, store, arguments, interrupt.requested());
    if (arguments.check && !interrupt.requested())
        check_choices(scene, ladder, store, arguments.budget_s, &interrupt.requested());
    const StoredLadder stored = describe_ladder(scene, ladder);
    const long ladder_id = store.add(stored);
    log_info("stored as study {} in {}", ladder_id, arguments.database);
    const std::vector<MethodPoint> points = read_study(stored, store).points;
    if (arguments.json) print_json(ladder_json(scene.name, ladder, prices, points));
    if (!arguments.chart.empty())
        write_output_file(arguments.chart, "--chart",
                          svg_chart(work_precision_figure(scene.name, chart_title(scene.name), points)),
                          arguments.rules);
    if (interrupt.requested()) return exit_code::interrupted;
    return ladder.convergence[0].fit ? exit_code::success : exit_code::not_a_result;
}

/// Ladders of random slopes, up to the finest rung that is asked for. Those that the database holds already
/// cost nothing, so that a survey that was stopped goes on where it was.
int survey_slopes(const AccuracyArguments& arguments) {
    const WriteAheadLog log_of_writes(arguments.database);
    Store store(arguments.database, Store::Mode::write);
    InterruptWatch interrupt;
    wait_for_others(store, arguments.database, interrupt.requested());
    LadderOptions options;
    options.lattices = arguments.lattices;
    options.budget_s = arguments.budget_s;
    options.finest = options.at_least_to = arguments.at_least_to > 0 ? arguments.at_least_to : usual_finest;
    options.interrupt = &interrupt.requested();
    int done = 0;
    std::vector<AccuracyStudy> studies;
    for (const Scene& scene : random_slopes(arguments.slopes, arguments.seed)) {
        Ladder ladder = climb(scene, store, options);
        if (arguments.check && !interrupt.requested())
            check_choices(scene, ladder, store, arguments.budget_s, &interrupt.requested());
        if (interrupt.requested()) return exit_code::interrupted;
        store.add(describe_ladder(scene, ladder));
        if (arguments.check) studies.push_back(read_study(describe_ladder(scene, ladder), store));
        log_info("{} of {}: {}, {} rungs; {}", ++done, arguments.slopes, scene.name, ladder.rungs.size(),
                 ladder.ended);
    }
    if (arguments.check) print_text(coverage_table(studies));
    return exit_code::success;
}

void write_page(const AccuracyArguments& arguments, const Store& store) {
    const fs::path page(arguments.page);
    const fs::path pictures = page.parent_path() / page.stem();
    const std::vector<AccuracyStudy> studies = read_studies(store);
    if (studies.empty())
        throw InputError(option_place("--db", arguments.database), "holds no study of accuracy",
                         "make one with: runout accuracy CASE --db " + arguments.database);
    std::vector<std::string> names;
    for (const AccuracyStudy& item : studies) names.push_back(item.name);
    const std::vector<std::string> files = distinct_file_names(names);
    const auto path_of = [&](std::size_t i) { return (pictures / (files[i] + ".svg")).string(); };
    for (std::size_t i = 0; i < studies.size(); ++i)
        check_output_place(path_of(i), "--page", Folder::may_be_made, arguments.rules);
    make_output_folder(pictures.string(), "--page");
    for (std::size_t i = 0; i < studies.size(); ++i)
        write_output_file(path_of(i), "--page",
                          svg_chart(work_precision_figure(studies[i].name, chart_title(studies[i].name),
                                                          studies[i].points)),
                          arguments.rules);
    write_output_file(arguments.page, "--page", accuracy_page(studies, page.stem().string()),
                      arguments.rules);
}

int accuracy(AccuracyArguments arguments) {
    if (arguments.quiet) log_errors_only();
    if (arguments.slopes > 0 && !arguments.scenario.file.empty())
        throw InputError(option_place("--slopes", fmt::format("{}", arguments.slopes)),
                         "goes without FILE: the slopes are drawn at random", "leave out one of them");
    arguments.rules.taken = taken_by(arguments);
    check_places(arguments);
    const bool from_store = !arguments.page.empty() || !arguments.survey.empty();
    if (arguments.scenario.file.empty() && !from_store && arguments.slopes == 0)
        throw InputError(option_place("accuracy", ""), "has no FILE",
                         "give a case (.toml) or a section (.csv), or --page to write up stored studies");
    int code = exit_code::success;
    if (!arguments.scenario.file.empty()) code = study(arguments);
    if (arguments.slopes > 0) code = survey_slopes(arguments);
    if (!from_store) return code;
    const Store store(arguments.database, Store::Mode::read);
    if (!arguments.page.empty()) write_page(arguments, store);
    if (!arguments.survey.empty())
        write_output_file(arguments.survey, "--survey", survey_text(store), arguments.rules);
    return code;
}

}  // namespace

void add_accuracy_command(CommandLine& program) {
    const auto arguments = std::make_shared<AccuracyArguments>();
    Command command = program.add_command("accuracy", "Show what accuracy costs in time on a case");
    add_case_arguments(command, arguments->scenario);
    command.add_option("--target", &arguments->target, "Error of the run-out to reach: a share or a length")
        .value_name("5%|0.25m")
        .show_default()
        .group("Ladder");
    add_number_option(command, "--budget", arguments->budget_s,
                      "Time for the ladder; no rung is begun that would exceed it", positive_number)
        .value_name("s")
        .group("Ladder");
    add_number_option(command, "--finest", arguments->at_least_to,
                      "sqrt(S)/dl to go on to even if the target is met before, for a better reference",
                      {0, 1000})
        .group("Ladder");
    add_number_option(command, "--lattices", arguments->lattices,
                      "Runs on each rung: on the regular lattice and off it at random", {1, 100})
        .group("Ladder");
    command
        .add_flag(
            "--methods", &arguments->methods,
            "Also turn each knob: Courant number, friction iterations, pressure tolerance, smoothing length, "
            "friction scheme, threads")
        .group("Ladder");
    command
        .add_flag("--check", &arguments->check,
                  "Also let settings be chosen for 10, 5 and 2 %, run them, and hold their error bars "
                  "against the ladder")
        .group("Ladder");
    add_number_option(command, "--slopes", arguments->slopes,
                      "Without FILE: ladders of so many random slopes, up to --finest (45)", {0, 10000})
        .group("Survey");
    add_number_option(command, "--seed", arguments->seed, "The same seed makes the same slopes", not_negative)
        .group("Survey");
    add_database_option(command, arguments->database).group("Output");
    command.add_option("--chart", &arguments->chart, "Write error against CPU time as an SVG picture")
        .value_name("PATH")
        .group("Output");
    command
        .add_option("--page", &arguments->page,
                    "Write all studies of the database as a Markdown page, with pictures beside it")
        .value_name("PATH")
        .group("Output");
    command
        .add_option("--survey", &arguments->survey,
                    "Write the ladders of the database as CSV, the form of src/accuracy/ladders.csv")
        .value_name("PATH")
        .group("Output");
    add_overwrite_option(command, arguments->rules);
    command.add_flag("--json", &arguments->json, "Print the study as one JSON object").group("Output");
    command.add_flag("--quiet", &arguments->quiet, "No log but errors").group("Output");
    command.set_work([arguments] { return accuracy(*arguments); });
}

}  // namespace runout
