#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "core/input_error.h"
#include "program/answer.h"
#include "program/command.h"
#include "program/common_options.h"
#include "program/number_option.h"
#include "program/run_choice.h"
#include "program/study_choice.h"
#include "report/text/reach_text.h"
#include "store/store.h"

namespace runout {
namespace {

struct AtArguments {
    RunChoice choice;
    double chainage = std::nan("");
    std::string study;
    std::string section;
    std::vector<std::string> intensities;
    bool json = false;
};

InputError off_the_section(const AtArguments& arguments, double low, double high) {
    return InputError(
        {.file = {}, .line = 0, .key = "--chainage", .value = fmt::format("{:g}", arguments.chainage)},
        "is not on the section", fmt::format("valid: {:.6g} to {:.6g} m", low, high));
}

bool is_on_its_section(const ReachRow& row, double chainage) {
    return chainage >= row.section_from_m && chainage <= row.section_to_m;
}

int at_one_run(const AtArguments& arguments, const Store& store) {
    ReachQuestion question{.chainage_m = arguments.chainage};
    question.run_id = store.run(chosen_run(store, arguments.choice)).run_id;
    const ReachRow row = store.reach(question).at(0);
    if (!is_on_its_section(row, arguments.chainage))
        throw off_the_section(arguments, row.section_from_m, row.section_to_m);
    const Intensities classes = intensities_from(arguments.intensities, "--intensity");
    if (arguments.json)
        print_json(reach_json(row, arguments.chainage, classes));
    else
        print_text(reach_text(row, arguments.chainage, classes));
    return row.is_result ? exit_code::success : exit_code::not_a_result;
}

int at_many(const AtArguments& arguments, const Store& store) {
    ReachQuestion question{.chainage_m = arguments.chainage};
    if (!arguments.study.empty())
        question.study_id = chosen_study(store, arguments.choice.database, arguments.study).study_id;
    question.section = arguments.section;
    std::vector<ReachRow> rows = store.reach(question);
    const InputPlace asked{.file = arguments.choice.database,
                           .line = 0,
                           .key = arguments.study.empty() ? "--section" : "--study",
                           .value = arguments.study.empty() ? arguments.section : arguments.study};
    if (rows.empty()) throw InputError(asked, "has no runs", "`runout table --list` lists the stored runs");
    const ReachRow first = rows.front();
    std::erase_if(rows, [&](const ReachRow& row) { return !is_on_its_section(row, arguments.chainage); });
    if (rows.empty()) throw off_the_section(arguments, first.section_from_m, first.section_to_m);
    const ReachSummary summary = summary_of(rows);
    if (summary.runs > 0 && summary.runs == summary.without_envelope)
        throw InputError(asked, "has no envelopes: its runs are older than database 10",
                         "run it again, or ask `runout table --distance` for the front alone");
    if (arguments.json)
        print_json(reach_json(summary, arguments.chainage));
    else
        print_text(reach_text(summary, arguments.chainage));
    return exit_code::success;
}

int at(const AtArguments& arguments) {
    if (std::isnan(arguments.chainage))
        throw InputError({.file = {}, .line = 0, .key = "--chainage", .value = {}}, "is missing",
                         "give the chainage of the place in metres");
    const Store store(arguments.choice.database, Store::Mode::read);
    const bool many = !arguments.study.empty() || !arguments.section.empty();
    return many ? at_many(arguments, store) : at_one_run(arguments, store);
}

}  // namespace

void add_at_command(CommandLine& program) {
    const auto arguments = std::make_shared<AtArguments>();
    Command command =
        program.add_command("at", "What arrives at a place: from stored runs, without a new one");
    add_run_choice(command, arguments->choice);
    add_number_option(command, "--chainage", arguments->chainage, "The place, as in the section",
                      {.low = -1e9, .high = 1e9})
        .value_name("m");
    command
        .add_option("--study", &arguments->study,
                    "All scenarios of a study: probability of reaching the place, thickness and speed there")
        .value_name("NAME|ID")
        .excludes("--run");
    command.add_option("--section", &arguments->section, "All results on sections of that file")
        .value_name("FILE")
        .excludes("--run")
        .excludes("--study");
    add_intensity_option(command, arguments->intensities);
    command.add_flag("--json", &arguments->json, "Print the answer as one JSON object");
    command.set_work([arguments] { return at(*arguments); });
}

}  // namespace runout
