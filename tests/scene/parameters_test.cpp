// The table of all keys: every one is read into its own field, within its range.

#include "scene/parameters.h"

#include <cmath>
#include <set>

#include "core/units.h"
#include "scene/effect_settings.h"
#include "scene_fixture.h"

namespace runout {
namespace {

TEST(Parameters, HaveUniqueKeysInKnownSectionsAndSayWhatTheyAre) {
    std::set<std::string_view> keys;
    for (const Parameter& parameter : parameters()) {
        EXPECT_TRUE(keys.insert(parameter.key).second) << parameter.key << " twice";
        EXPECT_FALSE(parameter.help.empty()) << parameter.key;
        EXPECT_FALSE(parameter.fallback.empty()) << parameter.key;
        EXPECT_TRUE(parameter.help.ends_with('.') || parameter.help.ends_with("file.")) << parameter.key;
        const std::string section(parameter.key.substr(0, parameter.key.find('.')));
        const std::set<std::string> known = {"section", "source", "material", "effects",
                                             "place",   "places", "run"};
        EXPECT_TRUE(known.contains(section)) << section;
    }
}

/// All that a case holds, as text, for telling two cases apart.
std::string everything(const CaseSpec& c) {
    const auto& [density, friction_angle] = c.material;
    const SourceSpec& s = c.source;
    const RunSettings& r = c.run;
    const MapSection& m = c.section.map;
    std::string text = fmt::format("{}|{}|{}|{}|", c.name, c.section.file, c.section.options.toe_chainage.m,
                                   c.section.options.crest_chainage.m);
    const SectionFileOptions& f = c.section.format;
    text += fmt::format("{}|{}|{}|{}|{}|{}|{}|", f.columns, f.unit, f.decimal, f.dxf_layers,
                        f.landxml.alignment, f.landxml.station, f.landxml.surface);
    const LinePlacing& p = c.section.placing;
    text += fmt::format("{}|{} {}|{}|{}|{}|{}|", p.crs, p.origin.x(), p.origin.y(), p.origin_chainage.m,
                        p.bearing, p.towards ? fmt::format("{} {}", p.towards->x(), p.towards->y()) : "",
                        m.zero_is_ground);
    text += fmt::format("{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|", m.raster, m.sampling_m, m.smoothing_m,
                        static_cast<int>(m.options.interpolation), m.options.crs, m.options.elevation_unit,
                        m.line.file, m.line.layer, m.line.where, m.line.feature_id.value_or(-1), m.line.crs);
    text += fmt::format("{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|", to_string(s.type), s.base_angle,
                        s.scarp_angle, s.area, s.height, s.length, s.thickness, s.aspect, s.drop_height,
                        to_string(s.datum), s.discontinuity_angle, s.points.size());
    text += fmt::format("{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}", density, friction_angle,
                        r.particle_spacing, r.resolution, r.gravity, r.courant, r.smoothing_ratio,
                        static_cast<int>(r.friction), r.friction_iterations, r.pressure_tolerance,
                        r.time_limit, r.front_thickness, r.front_window, r.threads);
    text +=
        fmt::format("|{}|{}|{}|{}", r.sleeping, r.lattice_seed, fmt::join(r.snapshot_times, " "), c.accuracy);
    const FeatureQuery& q = c.map_places;
    text += fmt::format("|{}|{}|{}|{}|{}|{}|{}", q.file, q.layer, q.where, q.crs, q.name_field, q.kind_field,
                        q.max_offset_m);
    const Effects& e = c.effects;
    for (const EffectSetting& setting : effect_settings(e, Profile{}))
        text += fmt::format("|{}.{} {}", setting.effect, setting.key, setting.value);
    if (e.pore_pressure) text += fmt::format("|excess for {}", e.pore_pressure->dissipation_time);
    if (e.release) text += fmt::format("|{} {}", e.release->layer_width, e.release->layer_height);
    if (e.erodible_bed) text += fmt::format("|layer from {}", e.erodible_bed->from);
    text += fmt::format("|{}|{} {}", c.shaking_record, c.pseudo_static.x(), c.pseudo_static.y());
    for (const Place& place : c.places)
        text += text += fmt::format("|place {} {} {} {}", place.name, place.x, place.width, place.kind);
    return text;
}

// An inert knob is the worst kind: each key must change the case, and no two keys in the same way.
TEST(Parameters, EachSetsItsOwnFieldAndNoOther) {
    std::set<std::string> seen = {everything(CaseSpec{})};
    for (const Parameter& parameter : parameters()) {
        CaseSpec spec;
        override_value(spec, std::string(parameter.key), sample_text(parameter), "--set");
        EXPECT_TRUE(seen.insert(everything(spec)).second)
            << parameter.key << " does nothing, or what another key does";
        EXPECT_TRUE(spec.has(parameter.key));
    }
}

TEST(Parameters, NumericDefaultsSayWhatHolds) {
    const CaseSpec spec;
    const auto said = [](const char* key) { return std::stod(std::string(find_parameter(key)->fallback)); };
    EXPECT_EQ(said("material.density_kg_m3"), spec.material.density);
    EXPECT_EQ(said("run.gravity_m_s2"), spec.run.gravity);
    EXPECT_EQ(said("run.courant"), spec.run.courant);
    EXPECT_EQ(said("run.smoothing_ratio"), spec.run.smoothing_ratio);
    EXPECT_EQ(said("run.friction_iterations"), spec.run.friction_iterations);
    EXPECT_EQ(said("run.pressure_tolerance"), spec.run.pressure_tolerance);
    EXPECT_NEAR(said("source.discontinuity_angle_deg"), degrees(spec.source.discontinuity_angle), 1e-12);
}

TEST(Parameters, AnglesBecomeRadiansAtTheBorder) {
    CaseSpec spec;
    for (const char* key : {"source.base_angle_deg", "source.scarp_angle_deg",
                            "source.discontinuity_angle_deg", "material.friction_angle_deg"})
        override_value(spec, key, "30", "--set");
    for (const double angle : {spec.source.base_angle, spec.source.scarp_angle,
                               spec.source.discontinuity_angle, spec.material.friction_angle})
        EXPECT_DOUBLE_EQ(angle, std::acos(-1.0) / 6);
}

TEST(Parameters, RangesIncludeTheEndsTheySayTheyInclude) {
    const auto accepts = [](const std::string& key, const std::string& text) {
        CaseSpec spec;
        return input_error([&] { override_value(spec, key, text, "--set"); }).empty();
    };
    EXPECT_TRUE(accepts("material.friction_angle_deg", "0"));
    EXPECT_TRUE(accepts("material.friction_angle_deg", "79.999"));
    EXPECT_FALSE(accepts("material.friction_angle_deg", "80"));
    EXPECT_FALSE(accepts("material.friction_angle_deg", "-1e-9"));
    EXPECT_TRUE(accepts("run.resolution", "4"));
    EXPECT_TRUE(accepts("run.resolution", "2000"));
    EXPECT_FALSE(accepts("run.resolution", "3.999"));
    EXPECT_FALSE(accepts("run.resolution", "2001"));
    EXPECT_TRUE(accepts("run.courant", "0.4"));
    EXPECT_FALSE(accepts("run.courant", "0"));
    EXPECT_FALSE(accepts("run.courant", "0.41"));
    EXPECT_FALSE(accepts("run.particle_spacing_m", "0"));
    EXPECT_FALSE(accepts("source.area_m2", "-3"));
    EXPECT_TRUE(accepts("section.toe_chainage_m", "-831450.25"));
    EXPECT_FALSE(accepts("run.threads", "1.5"));
    EXPECT_FALSE(accepts("run.threads", "0"));
    EXPECT_FALSE(accepts("run.gravity_m_s2", "1e999"));
}

}  // namespace
}  // namespace runout
