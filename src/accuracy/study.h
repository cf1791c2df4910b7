#pragma once

#include <string>
#include <vector>

#include "accuracy/ladder.h"
#include "accuracy/methods.h"
#include "accuracy/price.h"
#include "store/store.h"

namespace runout {

/// A setting that was chosen to meet a target, and how the run came out.
struct ChoiceCheck {
    std::string target;  ///< "5 %"
    StoredRun run;       ///< with its appraisal
    double resolution = 0;
    double off_finest_m = 0;  ///< run-out - mean of the finest rung
    bool inside = false;      ///< the finest rung lies within the error bar of the run
};

/// All that is stored of one study.
struct AccuracyStudy {
    std::string name;
    std::string machine;
    Ladder ladder;
    std::vector<Price> prices;
    std::vector<MethodPoint> points;  ///< the ladder as series "spacing", and each setting
    std::vector<ChoiceCheck> choices;
};

/// Series of a study that holds runs at chosen settings; the setting is the target.
constexpr const char* choice_series = "choice";
constexpr const char* ladder_choice_series = "choice from ladder";

AccuracyStudy read_study(const StoredLadder& stored, const Store& store);

/// The latest study of each question, in the order in which the questions were first asked.
std::vector<AccuracyStudy> read_studies(const Store& store);

}  // namespace runout
