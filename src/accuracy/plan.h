#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/ladder.h"
#include "accuracy/survey.h"
#include "scene/accuracy_target.h"
#include "store/store.h"

namespace runout {

/// What is to be run, how sure it will be, and what it will take.
struct RunPlan {
    Scene scene;          ///< with the spacing to run
    Appraisal appraisal;  ///< to be stored with the run
    std::vector<PilotRow> pilots;
    std::string reason;  ///< what was chosen and why, one sentence
};

struct PlanOptions {
    /// To meet; nothing: the spacing of the scene stays, and is only appraised.
    std::optional<AccuracyTarget> target;
    /// Where the user asked for the target; a target that was not asked for is met as well as can be.
    std::optional<InputPlace> asked;
    std::optional<Ladder> ladder;   ///< of this very question; nothing: coarse pilots are run
    std::vector<CostSample> costs;  ///< of runs on this machine; too few: those of the survey stand in
    double longest_run_s = 3600;    ///< CPU time that a chosen run may take
    bool pilots = true;             ///< false: nothing is run for the plan
    const std::vector<SurveyedScene>* survey = nullptr;  ///< null: the shipped one
    const std::atomic<bool>* interrupt = nullptr;
};

/// What the runs of a database took on this machine, on one thread.
std::vector<CostSample> costs_on_this_machine(const Store& store);

/// Chooses the cheapest spacing that meets the target by the scene's own ladder, or else by pilots: coarse
/// runs of the scene, which tell its size, its cost and how much it changes on refinement, held against the
/// survey of shipped ladders. Pilots take at most half the CPU time of the run that is chosen; where even the
/// cheapest would take more, the run is made finer than it need be, or, with a spacing that is given, there
/// are none. Throws InputError when a target that was asked for cannot be met within the memory and
/// `longest_run_s`; it names the best that can be, and its price.
RunPlan plan_run(const Scene& scene, const PlanOptions& options);

}  // namespace runout
