#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "core/input_error.h"
#include "program/answer.h"
#include "program/case_arguments.h"
#include "program/command.h"
#include "program/number_option.h"
#include "program/study_choice.h"
#include "report/text/estimate_text.h"
#include "store/store.h"

namespace runout {
namespace {

struct EstimateArguments {
    std::string database;
    std::string study;
    CaseArguments scenario;  ///< its file is empty where the question is given by numbers
    ChartQuestion numbers;
    double area = ChartQuestion::not_given;
    bool check = false;
    bool json = false;
};

struct Question {
    ChartQuestion chart;
    std::optional<EstimateScale> scale;
};

bool has_numbers(const EstimateArguments& arguments) {
    for (const double value : arguments.numbers.place)
        if (!std::isnan(value)) return true;
    return !std::isnan(arguments.area);
}

InputError unclear(const std::string& problem) {
    return InputError({.file = {}, .line = 0, .key = "estimate", .value = {}}, problem,
                      "give a case, or --slope-angle, --drop-height, --front-area and --friction-angle");
}

Question question_of(const EstimateArguments& arguments) {
    const bool numbers = has_numbers(arguments);
    if (arguments.scenario.file.empty()) {
        if (arguments.check && !numbers) return {};
        if (!arguments.scenario.overrides.empty()) throw unclear("has --set without a case");
        if (!numbers) throw unclear("says not what is to be estimated");
        std::optional<EstimateScale> scale;
        if (!std::isnan(arguments.area)) scale = EstimateScale{arguments.area, std::nullopt};
        return {arguments.numbers, scale};
    }
    if (numbers) throw unclear("has a case and numbers");
    const Scene scene = make_scene(case_from(arguments.scenario));
    log_reading(scene.profile);
    log_assumptions(scene.assumed);
    return {chart_question(scene), EstimateScale{scene.source.area, -scene.source.head.x()}};
}

int tell_estimate(const EstimateArguments& arguments) {
    const Question question = question_of(arguments);
    const Store store(arguments.database, Store::Mode::read);
    std::optional<long> study_id;
    if (!arguments.study.empty())
        study_id = chosen_study(store, arguments.database, arguments.study).study_id;
    const ChartPoints points = chart_points(store.chart_rows(study_id), question.chart);
    if (arguments.check) {
        const HeldOutCheck check = check_held_out(points, arguments.database);
        if (arguments.json)
            print_json(held_out_json(check));
        else
            print_text(held_out_text(check));
        return exit_code::success;
    }
    const RunOutChart chart(points, arguments.database);
    const Estimate estimate = chart.estimate(question.chart);
    if (arguments.json)
        print_json(estimate_json(chart, estimate, question.scale));
    else
        print_text(estimate_text(chart, estimate, question.scale));
    return exit_code::success;
}

void add_number(CLI::App& sub, const char* option, double& value, const char* help, const char* unit,
                const NumberRange& range) {
    add_number_option(sub, option, value, help, range)->type_name(unit)->group("Question in numbers");
}

}  // namespace

void add_estimate_command(CLI::App& app, Command& command) {
    const auto arguments = std::make_shared<EstimateArguments>();
    CLI::App* sub = app.add_subcommand(
        "estimate", "Estimate a run-out from stored runs, without a simulation; refused outside of them");
    sub->add_option("DB", arguments->database, "Database of runs, such as sweep.db")
        ->required()
        ->type_name("");
    sub->add_option("FILE", arguments->scenario.file, "A case (.toml) that is to be estimated")
        ->type_name("");
    add_set_option(*sub, arguments->scenario);
    sub->add_option("--study", arguments->study, "Only the runs of this study; by default all runs")
        ->type_name("NAME|ID");
    ChartPlace& place = arguments->numbers.place;
    add_number(*sub, "--slope-angle", place[0], "Inclination of the cut", "deg", {0, 90});
    add_number(*sub, "--drop-height", place[1],
               "H_d/sqrt(S): head of the source above the toe over the root of its area", "ratio",
               not_negative);
    add_number(*sub, "--front-area", place[2], "S_front/S: part of the source above the discontinuity plane",
               "ratio", {0, 1});
    add_number(*sub, "--friction-angle,--phi", place[3], "Internal friction of the soil", "deg", {0, 89});
    add_number(*sub, "--area", arguments->area, "Area S of the source: the answer is in metres too", "m2",
               positive_number);
    sub->add_flag("--check", arguments->check,
                  "Instead of an estimate: hold out runs in turn, and say how well they are estimated");
    sub->add_flag("--json", arguments->json, "Print one JSON object");
    sub->callback([arguments, &command] { command = [arguments] { return tell_estimate(*arguments); }; });
}

}  // namespace runout
