#include "scene/new_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "core/units.h"
#include "scene/case_checks.h"
#include "scene/case_file.h"
#include "scene/parameters.h"
#include "scene/read_ground.h"
#include "scene/toml_text.h"
#include "source/ground_walk.h"
#include "source/source_types.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

constexpr const char* example_friction_deg = "38";

struct Setting {
    std::string key;
    std::string text;
};
using Settings = std::vector<Setting>;

constexpr std::array<std::string_view, 5> path_keys = {"section.file", "section.line", "section.raster",
                                                       "places.file", "effects.shaking.record"};

bool says_source(const CaseSpec& spec) {
    return std::ranges::any_of(spec.given,
                               [](const auto& entry) { return entry.first.starts_with("source."); });
}

/// A slip line from the toe to the ground behind the crest, its middle at this share of the height.
Settings slip_line(const Profile& profile, double middle) {
    const Polyline& ground = profile.ground;
    const Vec2& crest = ground[profile.crest];
    const double back = std::max(ground.front().x(), crest.x() - 0.4 * crest.y());
    const Vec2 toe = profile.to_section({0, 0});
    const Vec2 bend = profile.to_section({crest.x() / 2 + back / 2, middle * crest.y()});
    const Vec2 top = profile.to_section({back, elevation_at(ground, back)});
    return {{"source.type", "slip_surface"},
            {"source.points", fmt::format("[[{}, {}], [{:.7g}, {:.7g}], [{}, {}]]", toe.x(), toe.y(),
                                          bend.x(), bend.y(), top.x(), top.y())}};
}

/// The usual wedge, flatter ones for gentle faces, and slip lines for what has walls and benches.
std::vector<Settings> sources_to_try(const Profile& profile) {
    const auto wedge = [](double base_deg, double scarp_deg) -> Settings {
        return {{"source.type", "B"},
                {"source.base_angle_deg", fmt::format("{:g}", base_deg)},
                {"source.scarp_angle_deg", fmt::format("{:g}", scarp_deg)}};
    };
    const double gentle = std::max(1.0, std::floor(0.6 * degrees(profile.slope_angle)));
    std::vector<Settings> tries = {wedge(35, 80), wedge(gentle, 80), wedge(35, 90), wedge(gentle, 90)};
    for (const double middle : {0.5, 0.3, 0.1, 0.02}) tries.push_back(slip_line(profile, middle));
    return tries;
}

CaseSpec with_settings(const CaseSpec& spec, const Settings& settings) {
    CaseSpec completed = spec;
    for (const Setting& setting : settings) override_value(completed, setting.key, setting.text, "new");
    return completed;
}

/// The case with a source that fits, and the site that follows.
struct Completed {
    CaseSpec spec;
    Site site;
    bool guessed = false;  ///< nobody said what the source is
};

std::optional<Completed> tried(const CaseSpec& spec, const Settings& settings) {
    try {
        const CaseSpec completed = with_settings(spec, settings);
        return Completed{completed, make_site(completed), true};
    } catch (const InputError&) {
        return std::nullopt;
    }
}

Completed with_source(const CaseSpec& spec) {
    check_keys_go_together(spec);
    const Ground ground = read_ground(spec);
    const bool drawn = !ground.mass.outline.empty() || !ground.mass.slip_line.empty();
    if (says_source(spec) || drawn) return {spec, make_site(spec)};
    for (const Settings& settings : sources_to_try(ground.profile))
        if (std::optional<Completed> fitting = tried(spec, settings)) return *std::move(fitting);
    throw InputError({spec.file, 0, "", ""}, "has no face that a source could be made for",
                     "give toe and crest (--toe-chainage, --crest-chainage), or a source (--source)");
}

/// Writes keys with what they mean.
class CaseText {
  public:
    CaseText(const CaseSpec& spec, std::string folder) : spec_(spec), folder_(std::move(folder)) {}

    void section(std::string_view heading) { text_ += fmt::format("\n{}\n", heading); }
    void blank() { text_ += "\n"; }
    void comment(const std::string& sentence) { text_ += toml_comment(sentence); }

    /// A key that holds, as it was given.
    void given(const std::string& key) { write(key, value_of(key), ""); }
    /// A key that holds, whether it was given or not.
    void given_or(const std::string& key, const std::string& value) {
        write(key, spec_.has(key) ? value_of(key) : value, "");
    }
    /// A key for the user to take the # from; one that was given holds.
    void offered(const std::string& key, const std::string& value) {
        if (written_.contains(key)) return;
        spec_.has(key) ? given(key) : write(key, value, "# ");
    }
    /// The keys of a section ("effects.cohesion.") that were given and are not written yet.
    void rest_of(std::string_view section) {
        for (const Parameter& parameter : parameters()) {
            const std::string key(parameter.key);
            if (key.substr(0, key.rfind('.') + 1) == section && spec_.has(key) && !written_.contains(key))
                given(key);
        }
    }
    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    [[nodiscard]] std::string value_of(const std::string& key) const {
        const Parameter& parameter = *find_parameter(key);
        std::string text = spec_.place(key).value;
        if (key == spec_path_key()) text = spec_.file;
        if (std::ranges::find(path_keys, key) != path_keys.end())
            text = fs::proximate(fs::absolute(text), fs::absolute(folder_)).generic_string();
        const bool word = parameter.kind == ValueKind::text || parameter.kind == ValueKind::choice;
        if (word) return toml_string(text);
        // The command line takes ".5" and "05", TOML does not.
        if (parameter.kind == ValueKind::number || parameter.kind == ValueKind::integer)
            return fmt::format("{}", std::stod(text));
        return text.starts_with('[') ? text : "[" + text + "]";
    }
    /// A bare section stands for this key, without a value of its own in the list of what was given.
    [[nodiscard]] std::string_view spec_path_key() const {
        return spec_.has("section.file") ? "section.file" : "section.line";
    }

    void write(const std::string& key, const std::string& value, const char* mark) {
        written_.insert(key);
        const Parameter& parameter = *find_parameter(key);
        comment(fmt::format("{} ({}; without it: {})", parameter.help, valid_values(parameter),
                            parameter.fallback));
        text_ += fmt::format("{}{} = {}\n", mark, key.substr(key.rfind('.') + 1), value);
    }

    const CaseSpec& spec_;
    std::string folder_;
    std::string text_;
    std::set<std::string> written_;
};

std::string shortest(double value) {
    return fmt::format("{}", value);
}

void write_section(CaseText& text, const CaseSpec& spec, const Profile& profile) {
    text.section("[section]");
    text.given(spec.has("section.file") ? "section.file" : "section.line");
    text.rest_of("section.");
    if (!profile.read_as.empty()) text.comment(fmt::format("The file is {}.", profile.read_as));
    const Vec2 crest = profile.to_section(profile.ground[profile.crest]);
    text.comment(
        fmt::format("The face goes from chainage {:.6g} m (elevation {:.6g} m) down to {:.6g} m "
                    "({:.6g} m), {:.4g} m high, {:.1f} deg.",
                    crest.x(), crest.y(), profile.toe_chainage_m, profile.toe_elevation_m,
                    profile.ground[profile.crest].y(), degrees(profile.slope_angle)));
    for (const std::string& doubt : profile.doubts) text.comment("Doubtful: " + doubt);
    text.comment("Take the # from both keys to keep this face, whatever the section becomes.");
    text.offered("section.toe_chainage_m", shortest(profile.toe_chainage_m));
    text.offered("section.crest_chainage_m", shortest(crest.x()));
}

void write_source(CaseText& text, const Completed& completed) {
    const auto& [spec, site, guessed] = completed;
    const Source& source = site.source;
    text.section("[source]");
    if (guessed) text.comment("Nobody said what may fail: this is a guess to begin with.");
    text.comment(fmt::format("The source has an area of {:.4g} m2, and drops {:.4g} m.", source.area,
                             source.drop_height));
    for (const std::string& sentence : site.assumed)
        if (sentence.ends_with(", as drawn") || sentence.starts_with("source.points = the "))
            text.comment("Taken from the drawing: " + sentence + ".");
    text.offered("source.type", toml_string(to_string(source.type)));
    text.rest_of("source.");
    const bool has_height = uses(source.type, &SourceSpec::height);
    if (has_height && !spec.has("source.area_m2"))
        text.offered("source.height_m", shortest(height_of(site.profile, source)));
    if (has_height && row_of(source.type).placement == Placement::by_drop_height)
        text.offered("source.drop_height_m", shortest(source.drop_height));
    text.offered("source.discontinuity_angle_deg", shortest(degrees(source.discontinuity_angle)));
}

void write_material(CaseText& text, const CaseSpec& spec) {
    text.section("[material]");
    if (!spec.has("material.friction_angle_deg"))
        text.comment(
            "An example! Give that of your soil: the run-out hangs on it more than on anything else.");
    text.given_or("material.friction_angle_deg", example_friction_deg);
    text.offered("material.density_kg_m3", shortest(spec.material.density));
}

void write_run(CaseText& text, const CaseSpec& spec) {
    text.section("[run]");
    text.given_or("run.name", toml_string(spec.name));
    const bool says_how_fine = spec.has("run.resolution") || spec.has("run.particle_spacing_m");
    if (!says_how_fine) text.offered("run.accuracy", toml_string(spec.accuracy));
    text.rest_of("run.");
}

std::string heading(const std::string& name) {
    return is_list_section(name) ? fmt::format("[[{}]]", name) : fmt::format("[{}]", name);
}

/// Effects and places that were given, and the names of all.
void write_effects(CaseText& text, const CaseSpec& spec) {
    std::vector<std::string> names;
    for (const Parameter& parameter : parameters()) {
        const std::string name(parameter.key.substr(0, parameter.key.rfind('.')));
        const bool named = name.starts_with("effects.") || name == "place";
        if (named && std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + heading(name);
    text.blank();
    text.comment(
        fmt::format("Effects and places exist only where the case names them (docs/effects.md): {}.", list));
    for (const std::string& name : names) {
        const bool given = std::ranges::any_of(spec.given, [&](const auto& entry) {
            return entry.first.substr(0, entry.first.rfind('.')) == name;
        });
        if (!given) continue;
        text.section(heading(name));
        text.rest_of(name + ".");
    }
}

}  // namespace

NewCase new_case(const CaseSpec& spec, const std::string& folder) {
    const Completed completed = with_source(spec);
    CaseText text(completed.spec, folder);
    text.comment(fmt::format("A case for Runout, made by runout new from {}.",
                             fs::path(spec.file).filename().string()));
    text.comment(
        "A key in a comment holds as it stands there; take the # away to pin or to change it. runout "
        "help keys lists all keys.");
    write_section(text, completed.spec, completed.site.profile);
    write_source(text, completed);
    write_material(text, completed.spec);
    write_run(text, completed.spec);
    write_effects(text, completed.spec);
    return {text.text(), completed.site.source.type, !spec.has("material.friction_angle_deg")};
}

}  // namespace runout
