#include "accuracy/check_choices.h"

#include <array>
#include <cmath>

#include "accuracy/plan.h"
#include "accuracy/study.h"
#include "run/run_scene.h"

namespace runout {
namespace {

constexpr std::array<double, 3> targets = {0.1, 0.05, 0.02};

/// The run is made anew even where the store has it, since its error bar is another one.
void check(const Scene& scene, const PlanOptions& options, const char* series, Ladder& ladder, Store& store) {
    const RunPlan plan = plan_run(scene, options);
    RunControl control;
    control.interrupt = options.interrupt;
    const RunResult result = run_scene(plan.scene, control);
    if (result.status == RunStatus::interrupted) return;
    const long run_id = store.add(plan.scene, result, plan.appraisal, plan.pilots);
    ladder.runs.push_back({series, options.target->text(), plan.scene.run.resolution, run_id});
}

}  // namespace

void check_choices(const Scene& scene, Ladder& ladder, Store& store, double longest_run_s,
                   const std::atomic<bool>* interrupt) {
    const std::vector<SurveyedScene> others = without(shipped_survey(), scene.name);
    for (const double share : targets) {
        PlanOptions options;
        options.target = AccuracyTarget{share, 0};
        options.survey = &others;
        options.longest_run_s = longest_run_s;
        options.interrupt = interrupt;
        check(scene, options, choice_series, ladder, store);
        options.ladder = ladder;
        check(scene, options, ladder_choice_series, ladder, store);
    }
}

}  // namespace runout
