#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/input_error.h"
#include "core/output_file.h"
#include "program/answer.h"
#include "program/command.h"
#include "program/common_options.h"
#include "program/interrupt.h"
#include "program/log.h"
#include "program/number_option.h"
#include "program/patient_store.h"
#include "report/text/stress_table.h"
#include "store/store.h"
#include "store/write_ahead.h"
#include "stress/stress_case.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

constexpr int all_scenes = -1;

struct StressArguments {
    int scenes = 100;
    std::uint64_t seed = 1;
    std::vector<std::string> ranges;
    std::vector<std::string> settings;
    int scene = all_scenes;
    std::string case_file;
    std::string database = "stress.db";
    int jobs = default_jobs();
    bool quiet = false;
};

std::optional<double> number_from(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::string known_axes(std::span<const StressAxis> axes) {
    std::vector<std::string_view> names;
    for (const StressAxis& axis : axes) names.push_back(axis.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

/// "slope_angle_deg=40:70" narrows one axis.
void narrow(std::vector<StressAxis>& axes, const std::string& text) {
    const InputPlace place = option_place("--range", text);
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string name = text.substr(0, equals);
    const auto axis = std::ranges::find(axes, name, &StressAxis::name);
    if (axis == axes.end()) throw InputError(place, "names no axis", "known: " + known_axes(axes));
    const std::string range = text.substr(std::min(equals + 1, text.size()));
    const std::size_t colon = range.find(':');
    const auto low = number_from(range.substr(0, colon));
    const auto high = colon == std::string::npos ? low : number_from(range.substr(colon + 1));
    const bool ordered = low && high && *low <= *high;
    if (!ordered || *low < axis->low || *high > axis->most)
        throw InputError(
            place, "is not a range of this axis",
            fmt::format("give {}=LOW:HIGH or one number, from {} to {}", name, axis->low, axis->most));
    axis->low = *low;
    axis->high = *high;
}

std::pair<std::string, std::string> split(const std::string& setting) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos)
        throw InputError(option_place("--set", setting), "is not key=value", "write --set run.courant=0.1");
    return {setting.substr(0, equals), setting.substr(equals + 1)};
}

void check_scene(const StressArguments& arguments) {
    if (arguments.scene >= arguments.scenes)
        throw InputError(option_place("--scene", fmt::format("{}", arguments.scene)),
                         "is not among the scenes", fmt::format("give 0 to {}", arguments.scenes - 1));
    if (!arguments.case_file.empty() && arguments.scene == all_scenes)
        throw InputError(option_place("--case", arguments.case_file), "is of one scene", "give --scene too");
}

/// Writes the scene as a case and, beside it, its section.
void write_case(const StressArguments& arguments, const StressPoint& point, const StressOptions& options) {
    const fs::path section = fs::path(arguments.case_file).replace_extension(".csv");
    const StressCase made = stress_case(point, stress_name(arguments.seed, arguments.scene),
                                        section.filename().string(), options.settings);
    write_output_file(section.string(), "--case", made.section);
    write_output_file(arguments.case_file, "--case", made.text);
}

int stress(const StressArguments& arguments) {
    if (arguments.quiet) log_errors_only();
    check_scene(arguments);
    std::vector<StressAxis> axes = stress_axes();
    for (const std::string& range : arguments.ranges) narrow(axes, range);
    const WriteAheadLog log_of_writes(arguments.database);
    Store store(arguments.database, Store::Mode::write);
    InterruptWatch interrupt;
    wait_for_others(store, arguments.database, interrupt.requested());
    StressOptions options;
    options.jobs = arguments.jobs;
    for (const std::string& setting : arguments.settings) options.settings.push_back(split(setting));
    options.interrupt = &interrupt.requested();
    options.on_run = [](int done, int total) {
        if (done % 50 == 0 || done == total) log_info("{} of {} scenes", done, total);
    };
    if (arguments.scene != all_scenes) options.only = arguments.scene;
    const auto points = stress_points(axes, arguments.scenes, arguments.seed);
    if (!arguments.case_file.empty())
        write_case(arguments, points[static_cast<std::size_t>(arguments.scene)], options);
    const auto outcomes = run_stress(points, arguments.seed, store, options);
    print_text(stress_table(outcomes, axes));
    if (interrupt.requested()) return exit_code::interrupted;
    return std::ranges::all_of(outcomes, is_sound) ? exit_code::success : exit_code::not_a_result;
}

std::string axes_text() {
    std::string text = "Axes, for --range:\n";
    for (const StressAxis& axis : stress_axes())
        text += fmt::format("  {:<20} {:g} to {:g}{}: {}\n", axis.name, axis.low, axis.high,
                            axis.most > axis.high ? fmt::format(" (to {:g} if asked for)", axis.most) : "",
                            axis.meaning);
    return text;
}

}  // namespace

void add_stress_command(CommandLine& program) {
    const auto arguments = std::make_shared<StressArguments>();
    Command command = program.add_command(
        "stress",
        "Run random hard scenes and say how each ended and how near any came to losing its stability");
    add_number_option(command, "--scenes", arguments->scenes, "How many, spread by a Latin hypercube",
                      {1, 1e6});
    add_number_option(command, "--seed", arguments->seed, "The same seed makes the same scenes",
                      not_negative);
    command.add_option("--range", &arguments->ranges, "Range of an axis, or its one value; may be repeated")
        .value_name("axis=LOW:HIGH")
        .one_value_a_use();
    command
        .add_option("--set", &arguments->settings,
                    "Any key run.* of a case file, for all scenes; may be repeated")
        .value_name("key=value")
        .one_value_a_use();
    add_number_option(command, "--scene", arguments->scene,
                      "Run this one of them only, as the tables number them", {0, 1e6})
        .default_text("all");
    command
        .add_option("--case", &arguments->case_file,
                    "Write that scene as a case that runs to the same bits, and its section beside it")
        .value_name("FILE");
    command.add_option("--db", &arguments->database, "Database that takes the runs; made if absent")
        .value_name("PATH")
        .show_default();
    add_jobs_option(command, arguments->jobs);
    command.add_flag("--quiet", &arguments->quiet, "No log but errors");
    command.set_footer(axes_text());
    command.set_work([arguments] { return stress(*arguments); });
}

}  // namespace runout
