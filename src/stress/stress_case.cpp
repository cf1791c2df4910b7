#include "stress/stress_case.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "core/input_error.h"
#include "core/units.h"
#include "scene/parameters.h"
#include "scene/toml_text.h"
#include "source/source_types.h"
#include "stress/stress_scene.h"

namespace runout {
namespace {

/// The degrees that are exactly this angle once they are read.
double exact_degrees(double angle) {
    double value = degrees(angle);
    for (const double candidate : {value, std::nextafter(value, 0.0), std::nextafter(value, 360.0)})
        if (radians(candidate) == angle) return candidate;
    return value;
}

std::string number(double value) {
    return fmt::format("{}", value);
}

/// Values by section of the case file, and key.
using Tables = std::map<std::string, std::map<std::string, std::string>>;

void put(Tables& tables, const std::string& key, const std::string& value) {
    const std::size_t dot = key.rfind('.');
    tables[key.substr(0, dot)][key.substr(dot + 1)] = value;
}

void put_source(Tables& tables, const SourceSpec& spec) {
    put(tables, "source.type", toml_string(to_string(spec.type)));
    const auto put_angle = [&](const char* key, double angle) {
        if (angle > 0) put(tables, key, number(exact_degrees(angle)));
    };
    const auto put_number = [&](const char* key, double value) {
        if (value > 0) put(tables, key, number(value));
    };
    const bool dips = uses(spec.type, &SourceSpec::base_angle);
    if (dips) put_angle("source.base_angle_deg", spec.base_angle);
    if (uses(spec.type, &SourceSpec::scarp_angle)) put_angle("source.scarp_angle_deg", spec.scarp_angle);
    put_number("source.area_m2", spec.area);
    put_number("source.height_m", spec.height);
    put_number("source.length_m", spec.length);
    put_number("source.thickness_m", spec.thickness);
    put_number("source.aspect_ratio", spec.aspect);
    if (spec.points.empty()) return;
    std::string points;
    for (const SectionPoint& p : spec.points)
        points += fmt::format("{}[{}, {}]", points.empty() ? "" : ", ", p.chainage.m, p.elevation);
    put(tables, "source.points", "[" + points + "]");
}

std::string text_of(const Tables& tables) {
    std::string text;
    for (const auto& [section, keys] : tables) {
        text += fmt::format("\n[{}]\n", section);
        for (const auto& [key, value] : keys) text += fmt::format("{} = {}\n", key, value);
    }
    return text;
}

/// A value of the command line as a case file has it.
std::string toml_value(const std::string& key, const std::string& value) {
    const Parameter* parameter = find_parameter(key);
    const bool word =
        parameter == nullptr || parameter->kind == ValueKind::text || parameter->kind == ValueKind::choice;
    if (word) return toml_string(value);
    return parameter->kind == ValueKind::numbers && !value.starts_with('[') ? "[" + value + "]" : value;
}

}  // namespace

StressCase stress_case(const StressPoint& point, const std::string& name, const std::string& section_file,
                       const std::vector<std::pair<std::string, std::string>>& settings) {
    const StressSite site = stress_site(point);
    if (site.free)
        throw InputError({.file = "--case", .line = 0, .key = "", .value = name},
                         "starts as a column or a block of its own, which no case file may say",
                         "leave out --case to run it");
    StressCase made;
    made.section = "chainage_m,elevation_m\n";
    for (const Vec2& p : site.section) made.section += fmt::format("{},{}\n", p.x(), p.y());
    Tables tables;
    put(tables, "section.file", toml_string(section_file));
    put(tables, "section.toe_chainage_m", number(site.face.toe_chainage.m));
    put(tables, "section.crest_chainage_m", number(site.face.crest_chainage.m));
    put_source(tables, site.source);
    put(tables, "material.friction_angle_deg", number(point.friction_angle_deg));
    if (point.base_friction_share < 1)
        put(tables, "effects.base_friction.angle_deg",
            number(point.base_friction_share * point.friction_angle_deg));
    put(tables, "run.name", toml_string(name));
    put(tables, "run.gravity_m_s2", number(point.gravity_m_s2));
    put(tables, "run.resolution", number(point.resolution));
    put(tables, "run.threads", "1");
    for (const auto& [key, value] : settings) put(tables, key, toml_value(key, value));
    made.text = toml_comment("Scene " + name + " of runout stress.") + text_of(tables);
    return made;
}

}  // namespace runout
