#include "store/scenario_hash.h"

#include <fmt/format.h>

#include "core/sha256.h"
#include "core/version.h"
#include "scene/effect_settings.h"
#include "store/store.h"

namespace runout {
namespace {

/// One "key value" a line. Numbers are the shortest text that reads back as the same double, on every
/// machine.
class CanonicalText {
  public:
    void add(const char* key, const std::string& value) { text_ += fmt::format("{} {}\n", key, value); }
    void add(const char* key, double value) { add(key, number(value)); }
    void add(const char* key, const Vec2& point) {
        add(key, fmt::format("{} {}", number(point.x()), number(point.y())));
    }
    void add(const char* key, const std::vector<Vec2>& points) {
        add(key, std::to_string(points.size()));
        for (const Vec2& point : points) add("-", point);
    }
    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    // -0 and 0 are the same number, so they must be the same text.
    static std::string number(double value) { return fmt::format("{}", value + 0.0); }

    std::string text_;
};

// The structs are taken apart member by member: one that is added later stops the build here, where it must
// be decided whether it changes the result.

std::string section_text(const Profile& profile) {
    // How the ground was read and its toe was chosen does not matter, but what came of it.
    const auto& [ground, crest, toe, slope_angle, toe_chainage, toe_elevation, descends, origin, read_as,
                 toe_given, crest_given, doubts, map_line] = profile;
    CanonicalText text;
    text.add("crest", static_cast<double>(crest));
    text.add("toe", static_cast<double>(toe));
    text.add("toe_chainage", toe_chainage);
    text.add("toe_elevation", toe_elevation);
    text.add("descends_with_chainage", descends ? 1.0 : 0.0);
    text.add("ground", ground);
    return text.text();
}

std::string source_text(const Source& source) {
    const auto& [type, outline, bed, area, front_area, discontinuity, exit, head, drop_height, datum] =
        source;
    CanonicalText text;
    text.add("type", to_string(type));
    text.add("outline", outline);
    text.add("bed", bed);
    text.add("area", area);
    text.add("front_area", front_area);
    text.add("discontinuity_angle", discontinuity);
    text.add("exit_point", exit);
    text.add("head", head);
    text.add("drop_height", drop_height);
    text.add("datum", to_string(datum));
    return text.text();
}

/// An effect that is absent leaves no text, so that scenarios without it keep their identity when it is
/// invented.
void add_effects(CanonicalText& text, const Scene& scene) {
    for (const EffectSetting& setting : effect_settings(scene.effects, scene.profile))
        text.add(fmt::format("{}.{}", setting.effect, setting.key).c_str(), setting.value);
    for (const auto& [name, x, width, kind] : scene.places) {
        text.add("place", name);
        text.add("place_x", x);
        text.add("place_width", width);
        text.add("place_kind", kind);
    }
}

std::string question_text(const Scene& scene) {
    const auto& [density, friction_angle] = scene.material;
    const auto& [spacing, resolution, gravity, courant, smoothing, friction, iterations, tolerance,
                 time_limit, front_thickness, front_window, sleeping, lattice_seed, snapshot_times, threads] =
        scene.run;
    CanonicalText text;
    text.add("density", density);
    text.add("friction_angle", friction_angle);
    text.add("particle_spacing", spacing);
    text.add("resolution", resolution);
    text.add("gravity", gravity);
    text.add("courant", courant);
    text.add("smoothing_ratio", smoothing);
    text.add("friction", friction_scheme_name(friction));
    text.add("friction_iterations", static_cast<double>(iterations));
    text.add("pressure_tolerance", tolerance);
    text.add("time_limit", time_limit);
    text.add("front_thickness", front_thickness);
    // The word keeps runs of the former definition (docs/front.md) apart: theirs had none.
    text.add("front_definition", "thickness");
    text.add("front_window", front_window);
    text.add("sleeping", sleeping ? "on" : "off");
    if (lattice_seed != 0) text.add("lattice_seed", static_cast<double>(lattice_seed));
    for (const double time : snapshot_times) text.add("snapshot_time", time);
    add_effects(text, scene);
    return text.text();
}

}  // namespace

SceneIdentity scene_identity(const Scene& scene) {
    const std::string section = section_text(scene.profile);
    const std::string source = section + source_text(scene.source);
    // The version stands for the numerics: a release that changes results must not take over the old ones.
    const std::string scenario =
        source + question_text(scene) + "program_version " + program_version() + "\n";
    return {sha256_hex(section), sha256_hex(source), sha256_hex(scenario)};
}

std::string scenario_hash(const Scene& scene) {
    return scene_identity(scene).scenario;
}

std::string map_line_hash(const MapLine& line) {
    const auto& [crs, points, chainages, attributes] = line;
    CanonicalText text;
    text.add("crs", crs);
    text.add("points", points);
    for (const double chainage : chainages) text.add("chainage", chainage);
    for (const Attribute& attribute : attributes)
        text.add(attribute.name.c_str(),
                 fmt::format("{} {}", attribute.value.index(), text_of(attribute.value)));
    return sha256_hex(text.text());
}

std::string friction_scheme_name(FrictionScheme scheme) {
    return scheme == FrictionScheme::explicit_ ? "explicit" : "projected";
}

}  // namespace runout
