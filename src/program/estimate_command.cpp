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

CommandOption add_number(Command& command, const char* names, double& value, const char* help,
                         const NumberRange& range) {
    return add_number_option(command, names, value, help, range).group("Question in numbers");
}

}  // namespace

void add_estimate_command(CommandLine& program) {
    const auto arguments = std::make_shared<EstimateArguments>();
    Command command = program.add_command(
        "estimate", "Estimate a run-out from stored runs, without a simulation; refused outside of them");
    command.add_option("DB", &arguments->database, "Database of runs, such as sweep.db")
        .required()
        .value_name("");
    command.add_option("FILE", &arguments->scenario.file, "A case (.toml) that is to be estimated")
        .value_name("");
    add_set_option(command, arguments->scenario);
    command.add_option("--study", &arguments->study, "Only the runs of this study; by default all runs")
        .value_name("NAME|ID");
    ChartPlace& place = arguments->numbers.place;
    add_number(command, "--slope-angle", place[0], "Inclination of the cut", {0, 90}).value_name("deg");
    add_number(command, "--drop-height", place[1],
               "H_d/sqrt(S): head of the source above the toe over the root of its area", not_negative)
        .value_name("ratio");
    add_number(command, "--front-area", place[2],
               "S_front/S: part of the source above the discontinuity plane", {0, 1})
        .value_name("ratio");
    add_number(command, "--friction-angle,--phi", place[3], "Internal friction of the soil", {0, 89})
        .value_name("deg");
    add_number(command, "--area", arguments->area, "Area S of the source: the answer is in metres too",
               positive_number)
        .value_name("m2");
    command.add_flag("--check", &arguments->check,
                     "Instead of an estimate: hold out runs in turn, and say how well they are estimated");
    command.add_flag("--json", &arguments->json, "Print one JSON object");
    command.set_work([arguments] { return tell_estimate(*arguments); });
}

}  // namespace runout
