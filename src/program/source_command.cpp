#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "core/printable.h"
#include "core/units.h"
#include "program/answer.h"
#include "program/case_arguments.h"
#include "program/command.h"
#include "scene/scene.h"

namespace runout {
namespace {

using Json = nlohmann::ordered_json;

struct SourceArguments {
    CaseArguments scenario;
    bool json = false;
};

Json point_json(const Profile& profile, const Vec2& local) {
    const Vec2 point = profile.to_section(local);
    return {point.x(), point.y()};
}

Json points_json(const Profile& profile, const Polyline& local) {
    Json points = Json::array();
    for (const Vec2& point : local) points.push_back(point_json(profile, point));
    return points;
}

/// Keys as in the database; points are (chainage, elevation) of the section file.
std::string source_json(const Site& site) {
    const Source& source = site.source;
    const Json object = {
        {"section_origin", site.profile.origin},
        {"slope_angle_deg", degrees(site.profile.slope_angle)},
        {"source_type", to_string(source.type)},
        {"source_area_m2", source.area},
        {"front_area_m2", source.front_area},
        {"front_area_ratio", source.front_area / source.area},
        {"discontinuity_angle_deg", degrees(source.discontinuity_angle)},
        {"drop_height_m", source.drop_height},
        {"drop_height_datum", to_string(source.datum)},
        {"exit_point", point_json(site.profile, source.exit_point)},
        {"head", point_json(site.profile, source.head)},
        {"outline", points_json(site.profile, source.outline)},
        {"bed", points_json(site.profile, source.bed)},
    };
    return object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string point_text(const Profile& profile, const Vec2& local) {
    const Vec2 point = profile.to_section(local);
    return fmt::format("({:.10g}, {:.10g})", point.x(), point.y());
}

std::string points_text(const Profile& profile, const Polyline& local) {
    std::string text;
    for (const Vec2& point : local)
        text += fmt::format("{}{}", text.empty() ? "" : " ", point_text(profile, point));
    return text;
}

std::string source_text(const Site& site) {
    const auto& [profile, source, assumed] = site;
    std::string text =
        fmt::format("Source of type {} on {}\n", to_string(source.type), printable(profile.origin));
    text += fmt::format("  slope angle    {:.4g} deg\n", degrees(profile.slope_angle));
    text += fmt::format("  area S_0       {:.6g} m2\n", source.area);
    text +=
        fmt::format("  S_front        {:.6g} m2, {:.5f} of S_0 (plane at {:.4g} deg)\n", source.front_area,
                    source.front_area / source.area, degrees(source.discontinuity_angle));
    text += fmt::format("  drop height    {:.6g} m to the {}\n", source.drop_height, to_string(source.datum));
    text += "Points as (chainage, elevation), m\n";
    text += fmt::format("  exit point P   {}\n", point_text(profile, source.exit_point));
    text += fmt::format("  head           {}\n", point_text(profile, source.head));
    text += fmt::format("  outline        {}\n", points_text(profile, source.outline));
    text += fmt::format("  bed            {}\n", points_text(profile, source.bed));
    return text;
}

int show_source(const SourceArguments& arguments) {
    const Site site = make_site(case_from(arguments.scenario));
    log_reading(site.profile);
    log_assumptions(site.assumed);
    if (arguments.json)
        print_json(source_json(site) + "\n");
    else
        print_text(source_text(site));
    return exit_code::success;
}

}  // namespace

void add_source_command(CommandLine& program) {
    const auto arguments = std::make_shared<SourceArguments>();
    Command command = program.add_command("source", "Derive the source and print it, without a run");
    add_case_arguments(command, arguments->scenario).required();
    command.add_flag("--json", &arguments->json, "Print the source as one JSON object").group("Output");
    command.set_work([arguments] { return show_source(*arguments); });
}

}  // namespace runout
