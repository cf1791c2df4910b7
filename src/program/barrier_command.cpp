#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/input_error.h"
#include "program/answer.h"
#include "program/case_arguments.h"
#include "program/command.h"
#include "program/interrupt.h"
#include "program/number_option.h"
#include "run/run_scene.h"
#include "study/barrier_height.h"

namespace runout {
namespace {

using Json = nlohmann::ordered_json;

constexpr double usual_resolution = 24;  // of a search: several runs, each for one height

struct BarrierArguments {
    CaseArguments scenario;
    double tolerance_percent = 5;
    bool json = false;
};

std::string trial_line(const BarrierTrial& trial) {
    return fmt::format("{:>9.3g}  {:<14}{:>10.3g}{:>14.3g}{:>14.3g}{:>14.3g}\n", trial.height_m,
                       !is_result(trial.status) ? to_string(trial.status)
                                                : std::string_view(trial.holds ? "holds" : "passed"),
                       trial.farthest_front_m, trial.beyond_back_m2, 1e-3 * trial.barrier.greatest_force_n_m,
                       1e-3 * trial.barrier.greatest_moment_n);
}

std::string answer_text(const BarrierSearch& search) {
    std::string text = fmt::format("{:>9}  {:<14}{:>10}{:>14}{:>14}{:>14}\n", "height, m", "the front",
                                   "comes to, m", "m2 beyond", "force, kN/m", "moment, kNm/m");
    for (const BarrierTrial& trial : search.trials) text += trial_line(trial);
    if (std::isnan(search.least_height_m))
        return text + fmt::format("No height up to {:.3g} m holds what is as thick as the front.\n",
                                  search.too_low_m);
    return text + fmt::format("Least height that holds: {:.3g} m; {:.3g} m does not.\n",
                              search.least_height_m, search.too_low_m);
}

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

std::string answer_json(const BarrierSearch& search) {
    Json trials = Json::array();
    for (const BarrierTrial& trial : search.trials)
        trials.push_back({{"height_m", trial.height_m},
                          {"status", to_string(trial.status)},
                          {"holds", trial.holds},
                          {"farthest_front_m", number(trial.farthest_front_m)},
                          {"beyond_back_m2", number(trial.beyond_back_m2)},
                          {"greatest_force_n_m", number(trial.barrier.greatest_force_n_m)},
                          {"greatest_moment_n", number(trial.barrier.greatest_moment_n)},
                          {"design_force_n_m", number(trial.barrier.design_force_n_m)},
                          {"last_force_n_m", number(trial.barrier.last_force_n_m)},
                          {"run_up_m", number(trial.barrier.run_up_m)}});
    return Json{{"least_height_m", number(search.least_height_m)},
                {"too_low_m", search.too_low_m},
                {"trials", trials}}
               .dump(2) +
           "\n";
}

int search_height(const BarrierArguments& arguments) {
    const CaseSpec spec = case_from(arguments.scenario);
    Scene scene = make_scene(spec);
    if (!scene.effects.barrier)
        throw InputError(spec.place("effects.barrier.chainage_m"), "is missing",
                         "give the place of the barrier and a height to begin with");
    log_assumptions(scene.assumed);
    if (!spec.has("run.resolution") && !spec.has("run.particle_spacing_m"))
        scene.run.resolution = usual_resolution;
    const InterruptWatch interrupt;
    bool stopped = false;
    const auto simulate = [&](const Scene& tried) {
        RunControl control;
        control.interrupt = &interrupt.requested();
        RunResult result = run_scene(tried, control);
        stopped = result.status == RunStatus::interrupted;
        return result;
    };
    const auto go_on = [&](const BarrierTrial&) { return !stopped; };
    const BarrierSearch search =
        least_barrier(std::move(scene), 0.01 * arguments.tolerance_percent, simulate, go_on);
    if (stopped) return exit_code::interrupted;
    if (arguments.json)
        print_json(answer_json(search));
    else
        print_text(answer_text(search));
    return std::isnan(search.least_height_m) ? exit_code::not_a_result : exit_code::success;
}

}  // namespace

void add_barrier_command(CommandLine& program) {
    const auto arguments = std::make_shared<BarrierArguments>();
    Command command = program.add_command(
        "barrier",
        "Least height of a case's barrier that holds what is as thick as the front, by a few runs");
    add_case_arguments(command, arguments->scenario).required();
    add_number_option(command, "--tolerance", arguments->tolerance_percent,
                      "How near the least height is sought, in per cent of it", {.low = 0.5, .high = 50})
        .value_name("%")
        .show_default();
    command.add_flag("--json", &arguments->json, "Print the answer as one JSON object");
    command.set_work([arguments] { return search_height(*arguments); });
}

}  // namespace runout
