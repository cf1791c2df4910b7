#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "core/input_error.h"
#include "core/printable.h"
#include "core/units.h"
#include "program/answer.h"
#include "program/case_arguments.h"
#include "program/command.h"
#include "program/common_options.h"
#include "program/log.h"
#include "program/refused_sections.h"
#include "report/chart/section_view.h"
#include "report/chart/svg_chart.h"
#include "scene/input_files.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

constexpr int drawing_columns = 78;

struct ProfileArguments {
    CaseArguments scenario;
    std::string svg;
    std::string refused;
    OutputRules rules{};
};

/// A section with its source. Where the case says nothing of a source, and the usual one does not fit, the
/// ground alone is worth a look.
struct ShownSection {
    std::string name;
    Profile profile;
    std::optional<Source> source;
    std::string no_source;  ///< why there is none
};

bool asks_for_source(const CaseSpec& spec) {
    return spec.given.lower_bound("source.") != spec.given.lower_bound("source/");
}

ShownSection section_of(const CaseSpec& spec) {
    ShownSection section{spec.name, make_ground(spec), std::nullopt, {}};
    try {
        section.source = make_site(spec).source;
    } catch (const InputError& error) {
        if (asks_for_source(spec)) throw;
        section.no_source = error.what();
    }
    return section;
}

SectionView view_of(const ShownSection& section) {
    return {section.profile, section.source ? &*section.source : nullptr};
}

/// One line a section.
std::string overview(const std::vector<ShownSection>& sections) {
    std::size_t widest = 4;
    for (const ShownSection& section : sections) widest = std::max(widest, printable(section.name).size());
    std::string text = fmt::format("{:<{}}  {:>8}  {:>8}  {:>8}  {:>8}  {:>8}\n", "name", widest, "length",
                                   "toe", "crest", "height", "face");
    text += fmt::format("{:<{}}  {:>8}  {:>8}  {:>8}  {:>8}  {:>8}\n", "", widest, "m", "m", "m", "m", "deg");
    for (const ShownSection& section : sections) {
        const Profile& profile = section.profile;
        const Vec2& crest = profile.ground[profile.crest];
        text += fmt::format("{:<{}}  {:>8.1f}  {:>8.1f}  {:>8.1f}  {:>8.1f}  {:>8.1f}\n",
                            printable(section.name), widest,
                            profile.ground.back().x() - profile.ground.front().x(), profile.toe_chainage_m,
                            profile.to_section(crest).x(), crest.y(), degrees(profile.slope_angle));
    }
    return text;
}

/// "out.svg", or "out-A.svg" for each of many sections.
std::vector<std::string> svg_paths(const std::string& path, const std::vector<ShownSection>& sections,
                                   bool many) {
    if (!many) return {path};
    std::vector<std::string> names;
    for (const ShownSection& section : sections) names.push_back(section.name);
    const fs::path whole(path);
    std::vector<std::string> paths;
    for (const std::string& name : distinct_file_names(names))
        paths.push_back((whole.parent_path() /
                         fmt::format("{}-{}{}", whole.stem().string(), name, whole.extension().string()))
                            .string());
    return paths;
}

/// Refuses before the first is written.
void write_svgs(const std::vector<ShownSection>& sections, bool many, const ProfileArguments& arguments) {
    const std::vector<std::string> paths = svg_paths(arguments.svg, sections, many);
    for (const std::string& path : paths) check_output_place(path, "--svg", Folder::exists, arguments.rules);
    for (std::size_t i = 0; i < paths.size(); ++i)
        write_output_file(paths[i], "--svg",
                          svg_chart(section_figure(view_of(sections[i]), sections[i].name)), arguments.rules);
}

int show_profile(ProfileArguments arguments) {
    const CaseSpec whole = case_from(arguments.scenario);
    arguments.rules.taken = input_files(whole);
    if (!arguments.refused.empty())
        check_output_place(arguments.refused, "--refused", Folder::exists, arguments.rules);
    const std::vector<SectionCase> cases = section_cases(whole);
    SectionTally tally(cases);
    std::vector<ShownSection> sections;
    for (const SectionCase& each : cases)
        if (auto section = tally.make(each, section_of)) sections.push_back(std::move(*section));
    tally.require_any();
    write_refused(arguments.refused, tally.sections().refused, arguments.rules);
    const bool many = tally.many();
    if (!arguments.svg.empty()) write_svgs(sections, many, arguments);
    if (many) {
        print_text(overview(sections));
        if (!tally.any_refused()) return exit_code::success;
        print_text(tally.summary() + "\n");
        return exit_code::not_a_result;
    }
    const ShownSection& section = sections.front();
    log_reading(section.profile);
    print_text(section_text(view_of(section)) + section_drawing(view_of(section), drawing_columns));
    if (!section.no_source.empty()) log_info("no source is shown: {}", section.no_source);
    return exit_code::success;
}

}  // namespace

void add_profile_command(CommandLine& program) {
    const auto arguments = std::make_shared<ProfileArguments>();
    Command command =
        program.add_command("profile", "Show the section that was read, with toe, crest and source");
    add_case_arguments(command, arguments->scenario).required();
    command.add_option("--svg", &arguments->svg, "Draw it into a file as well")
        .value_name("PATH")
        .group("Output");
    add_refused_option(command, arguments->refused);
    add_overwrite_option(command, arguments->rules);
    command.set_work([arguments] { return show_profile(*arguments); });
}

}  // namespace runout
