#pragma once

#include <string>
#include <vector>

#include "accuracy/cost_model.h"
#include "accuracy/ladder.h"
#include "store/store.h"

namespace runout {

/// The ladder of one scene of the survey.
struct SurveyedScene {
    std::string name;
    std::vector<RungSummary> rungs;  ///< from the coarsest to the finest, all with results
};

/// Ladders of shipped cases and random slopes that come with the program: what refinement changes on slopes
/// in general, and what it costs. They stand in for a scene's own ladder where it has none. From
/// src/accuracy/ladders.csv, which says where and how they were made; compiled into the program.
const std::vector<SurveyedScene>& shipped_survey();

/// `survey` without the scene of this name: for holding the rest against it.
std::vector<SurveyedScene> without(const std::vector<SurveyedScene>& survey, const std::string& name);

/// Reads the format of src/accuracy/ladders.csv. Throws InputError; `path` is for the message.
std::vector<SurveyedScene> parse_survey(const std::string& text, const std::string& path);

/// The latest ladder of each question in a database, in that format, with the program and the machine that
/// made them in its head. Rungs of which fewer than two lattices ended as results are left out, and so are
/// scenes of fewer than three such rungs, and those that end uphill of the toe.
std::string survey_text(const Store& store);

/// Costs of all rungs of a survey.
std::vector<CostSample> costs_of(const std::vector<SurveyedScene>& survey);

}  // namespace runout
