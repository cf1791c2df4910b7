#include "scene/effect_settings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/units.h"

namespace runout {
namespace {

/// Collects the settings of one effect after the other.
class Settings {
  public:
    explicit Settings(const Profile& profile) : profile_(profile) {}

    void begin(const char* effect) { effect_ = effect; }
    void add(const char* key, const std::string& value) { settings_.push_back({effect_, key, value}); }
    // -0 and 0 are the same number, so they must be the same text.
    void add(const char* key, double value) { add(key, fmt::format("{}", value + 0.0)); }
    /// Left out where it was not given.
    void add_if_given(const char* key, double value) {
        if (!std::isnan(value)) add(key, value);
    }
    void add(const char* key, const std::vector<double>& values) {
        add(key, fmt::format("[{}]", fmt::join(values, ", ")));
    }
    void add(const char* key, const std::vector<Vec2>& points) {
        std::string text;
        for (const Vec2& p : points)
            text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", p.x(), p.y());
        add(key, "[" + text + "]");
    }
    [[nodiscard]] double chainage(double x) const { return profile_.to_section({x, 0}).x(); }
    [[nodiscard]] std::vector<Vec2> to_section(std::vector<Vec2> points) const {
        for (Vec2& p : points) p = profile_.to_section(p);
        return points;
    }
    [[nodiscard]] std::vector<EffectSetting> take() { return std::move(settings_); }

  private:
    const Profile& profile_;
    std::string effect_;
    std::vector<EffectSetting> settings_;
};

// The structs are taken apart member by member: one that is added later stops the build here, where it must
// be written down.

void add(Settings& out, const BaseFriction& effect) {
    const auto& [angle, ranges] = effect;
    out.begin("base_friction");
    out.add_if_given("angle_deg", degrees(angle));
    std::string text;
    for (const auto& [from, to, own] : ranges) {
        const auto [low, high] = std::minmax({out.chainage(from), out.chainage(to)});
        text += fmt::format("{}[{}, {}, {}]", text.empty() ? "" : ", ", low, high, degrees(own));
    }
    if (!ranges.empty()) out.add("ranges", "[" + text + "]");
}

void add(Settings& out, const Cohesion& effect) {
    const auto& [strength, tension] = effect;
    out.begin("cohesion");
    out.add("cohesion_kpa", 1e-3 * strength);
    out.add_if_given("tension_cut_off_kpa", 1e-3 * tension);
}

void add(Settings& out, const RateDependence& effect) {
    const auto& [increase, inertial_number, diameter, density] = effect;
    out.begin("rate");
    out.add("grain_diameter_m", diameter);
    out.add("grain_density_kg_m3", density);
    out.add("friction_increase", increase);
    out.add("inertial_number", inertial_number);
}

void add(Settings& out, const PorePressure& effect) {
    const auto& [ratio, field, excess, time] = effect;
    out.begin("pore_pressure");
    if (field.empty()) out.add("ratio", ratio);
    std::vector<Vec2> points = field;
    for (Vec2& p : points) p.x() = out.chainage(p.x());
    if (!field.empty()) out.add("ratio_points", points);
    if (excess == 0) return;
    out.add("base_excess_ratio", excess);
    if (std::isfinite(time)) out.add("dissipation_time_s", time);
}

void add(Settings& out, const Barrier& effect) {
    const auto& [x, height, inclination, thickness, coefficient] = effect;
    out.begin("barrier");
    out.add("chainage_m", out.chainage(x));
    out.add("height_m", height);
    out.add("inclination_deg", degrees(inclination));
    out.add("thickness_m", thickness);
    out.add("load_coefficient", coefficient);
}

void add(Settings& out, const Shaking& effect) {
    const auto& [time, horizontal, vertical] = effect;
    out.begin("shaking");
    if (!time.empty()) out.add("time_s", time);
    out.add("horizontal_m_s2", horizontal);
    out.add("vertical_m_s2", vertical);
}

void add(Settings& out, const SideWalls& effect) {
    const auto& [width, angle] = effect;
    out.begin("side_walls");
    out.add("width_m", width);
    out.add("friction_angle_deg", degrees(angle));
}

void add(Settings& out, const StagedRelease& effect) {
    const auto& [layers, width, height, masses] = effect;
    out.begin("release");
    if (layers > 0) {
        out.add("layers", static_cast<double>(layers));
        out.add("layer_width_m", width);
        out.add("layer_height_m", height);
    }
    for (const auto& [time, mass] : masses) {
        out.add("mass.time_s", time);
        out.add("mass.points", out.to_section(mass.outline));
    }
}

void add(Settings& out, const ErodibleBed& effect) {
    const auto& [depth, from, to] = effect;
    const auto [low, high] = std::minmax({out.chainage(from), out.chainage(to)});
    out.begin("erodible_bed");
    out.add("depth_m", depth);
    out.add("from_chainage_m", low);
    out.add("to_chainage_m", high);
}

/// All that the program says of an effect, but its keys.
struct EffectEntry {
    EffectId id;
    const char* name;
    const char* with;
    const char* without;
    bool (*is_on)(const Effects&);
    void (*remove)(Effects&);
    void (*add_settings)(Settings&, const Effects&);
};

template <auto member>
constexpr EffectEntry entry(EffectId id, const char* name, const char* with, const char* without) {
    return {id,
            name,
            with,
            without,
            [](const Effects& effects) { return (effects.*member).has_value(); },
            [](Effects& effects) { (effects.*member).reset(); },
            [](Settings& out, const Effects& effects) {
                if (effects.*member) add(out, *(effects.*member));
            }};
}

/// One row an effect, in the order of the documentation.
constexpr std::array table = {
    entry<&Effects::base_friction>(EffectId::base_friction, "base_friction",
                                   "the bed has a friction of its own",
                                   "the bed is rough: the soil's own friction holds on it"),
    entry<&Effects::cohesion>(EffectId::cohesion, "cohesion", "strength that does not come from pressure",
                              "the soil has friction only"),
    entry<&Effects::rate>(EffectId::rate, "rate", "friction grows with the inertial number",
                          "friction does not depend on the rate"),
    entry<&Effects::pore_pressure>(EffectId::pore_pressure, "pore_pressure",
                                   "water takes pressure off the grains",
                                   "the soil is dry, or its friction angle stands for the water"),
    entry<&Effects::barrier>(EffectId::barrier, "barrier", "a rigid obstacle on the bed",
                             "nothing stands in the way"),
    entry<&Effects::shaking>(EffectId::shaking, "shaking", "the ground is accelerated",
                             "the ground is still"),
    entry<&Effects::side_walls>(EffectId::side_walls, "side_walls", "friction on the walls of a channel",
                                "the slide is infinitely wide"),
    entry<&Effects::release>(EffectId::release, "release", "several releases, one after the other",
                             "the whole source is let go at once"),
    entry<&Effects::erodible_bed>(EffectId::erodible_bed, "erodible_bed", "a layer of the bed may move",
                                  "the bed is rigid"),
};

}  // namespace

std::vector<EffectSetting> effect_settings(const Effects& effects, const Profile& profile) {
    // An effect without a row would be lost from records and hashes: a new member breaks this.
    [[maybe_unused]] const auto& [base_friction, cohesion, rate, pore_pressure, barrier, shaking, side_walls,
                                  release, erodible_bed] = effects;
    static_assert(table.size() == 9);
    Settings out(profile);
    for (const EffectEntry& row : table) row.add_settings(out, effects);
    return out.take();
}

std::string settings_text(const std::vector<EffectSetting>& settings, const std::string& effect) {
    std::string text;
    for (const EffectSetting& setting : settings)
        if (setting.effect == effect)
            text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", setting.key, setting.value);
    return text.size() > 90 ? text.substr(0, 87) + "..." : text;
}

std::vector<EffectState> effect_states(const Effects& effects, std::size_t places) {
    std::vector<EffectState> states;
    for (const EffectEntry& row : table) {
        const bool on = row.is_on(effects);
        states.push_back({row.id, row.name, on, on ? row.with : row.without});
    }
    states.push_back({std::nullopt, "places", places > 0,
                      places > 0 ? "passing debris is measured" : "nothing is measured on the way"});
    return states;
}

Effects without(Effects effects, EffectId id) {
    for (const EffectEntry& row : table)
        if (row.id == id) row.remove(effects);
    return effects;
}

}  // namespace runout
