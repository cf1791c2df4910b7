#include "program/case_arguments.h"

#include <fmt/format.h>

#include <array>
#include <map>

#include "program/common_options.h"
#include "program/log.h"
#include "scene/case_file.h"
#include "scene/parameters.h"

namespace runout {
namespace {

struct ShortOption {
    const char* option;
    const char* key;
};

constexpr std::array<ShortOption, 35> short_options = {{
    {"--source", "source.type"},
    {"--base-angle", "source.base_angle_deg"},
    {"--scarp-angle", "source.scarp_angle_deg"},
    {"--area", "source.area_m2"},
    {"--height", "source.height_m"},
    {"--length", "source.length_m"},
    {"--thickness", "source.thickness_m"},
    {"--aspect", "source.aspect_ratio"},
    {"--drop-height", "source.drop_height_m"},
    {"--drop-height-datum", "source.drop_height_datum"},
    {"--discontinuity-angle", "source.discontinuity_angle_deg"},
    {"--friction-angle", "material.friction_angle_deg"},
    {"--density", "material.density_kg_m3"},
    {"--columns", "section.columns"},
    {"--unit", "section.unit"},
    {"--decimal", "section.decimal"},
    {"--layer", "section.dxf_layers"},
    {"--station", "section.station"},
    {"--surface", "section.surface"},
    {"--raster", "section.raster"},
    {"--where", "section.where"},
    {"--origin", "section.origin"},
    {"--bearing", "section.bearing_deg"},
    {"--towards", "section.towards"},
    {"--crs", "section.crs"},
    {"--toe-chainage", "section.toe_chainage_m"},
    {"--crest-chainage", "section.crest_chainage_m"},
    {"--name", "run.name"},
    {"--accuracy", "run.accuracy"},
    {"--spacing", "run.particle_spacing_m"},
    {"--resolution", "run.resolution"},
    {"--courant", "run.courant"},
    {"--friction", "run.friction"},
    {"--time-limit", "run.time_limit_s"},
    {"--threads", "run.threads"},
}};

/// "Source" for "source.type": the heading in the help.
std::string group_of(const std::string& key) {
    std::string group = key.substr(0, key.find('.'));
    group[0] = static_cast<char>(group[0] - 'a' + 'A');
    return group;
}

std::string type_of(const Parameter& parameter) {
    if (!parameter.unit.empty()) return std::string(parameter.unit);
    return parameter.kind == ValueKind::text || parameter.kind == ValueKind::choice ? "word" : "number";
}

void add_short_option(Command& command, CaseArguments& arguments, const ShortOption& entry) {
    const InputPlace place{.file = entry.option, .line = 0, .key = entry.key, .value = {}};
    const Parameter& parameter = known_parameter(place);
    const auto remember = [&arguments, entry](const std::string& text) {
        arguments.overrides.push_back({entry.option, entry.key, text});
    };
    command.add_option(entry.option, remember, std::string(parameter.help))
        .value_name(type_of(parameter))
        .group(group_of(entry.key));
}

Override split_setting(const std::string& setting) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0)
        throw InputError(option_place("--set", setting), "is not key=value",
                         "write --set material.friction_angle_deg=35");
    return {"--set", setting.substr(0, equals), setting.substr(equals + 1)};
}

void check_given_once(const std::vector<Override>& overrides) {
    std::map<std::string, Override> seen;
    for (const Override& entry : overrides) {
        const auto [first, fresh] = seen.emplace(entry.key, entry);
        if (!fresh)
            throw InputError(
                {.file = entry.option, .line = 0, .key = entry.key, .value = entry.text},
                fmt::format("was given before by {} as {}", first->second.option, first->second.text),
                "give it once");
    }
}

}  // namespace

CommandOption add_case_arguments(Command& command, CaseArguments& arguments) {
    CommandOption file = command.add_option(
        "FILE", &arguments.file,
        "A case (.toml), a bare cross-section (.csv, .txt, .dxf, LandXML ...), or lines on a map "
        "(.gpkg, .shp, .geojson, .kmz ...)");
    file.value_name("");
    for (const ShortOption& entry : short_options) add_short_option(command, arguments, entry);
    add_set_option(command, arguments);
    return file;
}

void add_set_option(Command& command, CaseArguments& arguments) {
    const auto remember = [&arguments](const std::vector<std::string>& settings) {
        for (const std::string& setting : settings) arguments.overrides.push_back(split_setting(setting));
    };
    command.add_option("--set", remember, "Any key of a case file (runout help keys); may be repeated")
        .value_name("key=value")
        .one_value_a_use();
}

CaseSpec case_from(const CaseArguments& arguments) {
    check_given_once(arguments.overrides);
    CaseSpec spec = read_case(arguments.file);
    for (const Override& entry : arguments.overrides)
        override_value(spec, entry.key, entry.text, entry.option);
    return spec;
}

void log_reading(const Profile& profile) {
    if (!profile.read_as.empty()) log_info("{} {}", profile.origin, profile.read_as);
}

void log_assumptions(const std::vector<std::string>& assumed) {
    for (const std::string& sentence : assumed) log_info("not given, assumed: {}", sentence);
}

}  // namespace runout
