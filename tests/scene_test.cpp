// From a case file to a scene: every key, every override, every mistake.

#include "scene/scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>
#include <string>

#include "core/input_error.h"
#include "core/units.h"
#include "scene/case_file.h"
#include "scene/effect_settings.h"
#include "scene/parameters.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

/// The sentence of the InputError that `action` throws; empty when it throws none.
std::string input_error(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

bool contains(const std::string& sentence, const std::string& part) {
    return sentence.find(part) != std::string::npos;
}

/// A folder of its own for each test, with a section in it.
class SceneTest : public testing::Test {
  protected:
    SceneTest()
        : folder_(fs::temp_directory_path() / fmt::format("runout-scene-{}-{}", getpid(), test_name())) {
        fs::create_directories(folder_);
        write("section.csv", "chainage_m,elevation_m\n0,0.4\n0.3,0.4\n0.45,0\n2,0\n");
    }
    ~SceneTest() override { fs::remove_all(folder_); }

    static std::string test_name() { return testing::UnitTest::GetInstance()->current_test_info()->name(); }

    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return path(name);
    }

    /// A sound case: a triangle on the face, in four lines of source and one of material, and then `more`.
    [[nodiscard]] CaseSpec sound_case(const std::string& more = "") const {
        return read_case(write("case.toml",
                               "[section]\n"               // line 1
                               "file = \"section.csv\"\n"  // 2
                               "[source]\n"                // 3
                               "type = \"B\"\n"            // 4
                               "base_angle_deg = 35\n"     // 5
                               "scarp_angle_deg = 80\n"    // 6
                               "height_m = 0.2\n"          // 7
                               "[material]\n"              // 8
                               "friction_angle_deg = 38\n" +
                                   more));
    }

    /// What is said of a case file with this text, read and made into a scene.
    [[nodiscard]] std::string complaint(const std::string& text) const {
        const std::string file = write("bad.toml", text);
        return input_error([&] { make_scene(read_case(file)); });
    }

    fs::path folder_;
};

void expect_complaint(const std::string& sentence, const std::vector<std::string>& parts) {
    EXPECT_FALSE(sentence.empty()) << "nothing was said";
    for (const std::string& part : parts)
        EXPECT_TRUE(contains(sentence, part)) << part << " is not in: " << sentence;
}

// --- the parameter table

TEST(Parameters, HaveUniqueKeysInKnownSectionsAndSayWhatTheyAre) {
    std::set<std::string_view> keys;
    for (const Parameter& parameter : parameters()) {
        EXPECT_TRUE(keys.insert(parameter.key).second) << parameter.key << " twice";
        EXPECT_FALSE(parameter.help.empty()) << parameter.key;
        EXPECT_FALSE(parameter.fallback.empty()) << parameter.key;
        EXPECT_TRUE(parameter.help.ends_with('.') || parameter.help.ends_with("file.")) << parameter.key;
        const std::string section(parameter.key.substr(0, parameter.key.find('.')));
        const std::set<std::string> known = {"section", "source", "material", "effects", "gauge", "run"};
        EXPECT_TRUE(known.contains(section)) << section;
    }
}

/// A text inside the parameter's range that differs from the default.
std::string sample_text(const Parameter& parameter) {
    switch (parameter.kind) {
        case ValueKind::choice:
            return std::string(parameter.choices.back());
        case ValueKind::text:
            return "a-name";
        case ValueKind::points:
            return "[[1.0, 2.0], [3.0, 4.0], [1, 3]]";
        case ValueKind::numbers:
            return "[0.25, 0.5]";
        case ValueKind::rows:
            return parameter.choices.size() == 2 ? "[[1, 0.2], [2, 0.3]]" : "[[1, 2, 10]]";
        case ValueKind::integer:
            return "7";
        case ValueKind::number:
            break;
    }
    for (const char* candidate : {"17.5", "1.75", "0.25", "0.025", "1750", "75"}) {
        const double value = std::stod(candidate);
        if (parameter.range.contains(value)) return candidate;
    }
    return "?";
}

/// All that a case holds, as text, for telling two cases apart.
std::string everything(const CaseSpec& c) {
    const auto& [density, friction_angle] = c.material;
    const SourceSpec& s = c.source;
    const RunSettings& r = c.run;
    const MapSection& m = c.section.map;
    std::string text = fmt::format("{}|{}|{}|{}|", c.name, c.section.file, c.section.options.toe_chainage_m,
                                   c.section.options.crest_chainage_m);
    text += fmt::format("{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|", m.raster, m.sampling_m, m.smoothing_m,
                        static_cast<int>(m.options.interpolation), m.options.crs, m.options.elevation_unit,
                        m.line.file, m.line.layer, m.line.where, m.line.feature_id.value_or(-1), m.line.crs);
    text += fmt::format("{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|", to_string(s.type), s.base_angle,
                        s.scarp_angle, s.area, s.height, s.length, s.thickness, s.aspect, s.drop_height,
                        to_string(s.datum), s.discontinuity_angle, s.points.size());
    text +=
        fmt::format("{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}", density, friction_angle, r.particle_spacing,
                    r.resolution, r.gravity, r.courant, r.smoothing_ratio, static_cast<int>(r.friction),
                    r.friction_iterations, r.pressure_tolerance, r.time_limit, r.front_thickness, r.threads);
    text +=
        fmt::format("|{}|{}|{}|{}", r.sleeping, r.lattice_seed, fmt::join(r.snapshot_times, " "), c.accuracy);
    const Effects& e = c.effects;
    for (const EffectSetting& setting : effect_settings(e, Profile{}))
        text += fmt::format("|{}.{} {}", setting.effect, setting.key, setting.value);
    if (e.pore_pressure) text += fmt::format("|excess for {}", e.pore_pressure->dissipation_time);
    if (e.release) text += fmt::format("|{} {}", e.release->layer_width, e.release->layer_height);
    if (e.erodible_bed) text += fmt::format("|layer from {}", e.erodible_bed->from);
    text += fmt::format("|{}|{} {}", c.shaking_record, c.pseudo_static.x(), c.pseudo_static.y());
    for (const Gauge& gauge : c.gauges) text += fmt::format("|gauge {} {}", gauge.name, gauge.x);
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
    EXPECT_TRUE(accepts("run.courant", "0.5"));
    EXPECT_FALSE(accepts("run.courant", "0"));
    EXPECT_FALSE(accepts("run.courant", "0.51"));
    EXPECT_FALSE(accepts("run.particle_spacing_m", "0"));
    EXPECT_FALSE(accepts("source.area_m2", "-3"));
    EXPECT_TRUE(accepts("section.toe_chainage_m", "-831450.25"));
    EXPECT_FALSE(accepts("run.threads", "1.5"));
    EXPECT_FALSE(accepts("run.threads", "0"));
    EXPECT_FALSE(accepts("run.gravity_m_s2", "1e999"));
}

// --- reading a case file

TEST_F(SceneTest, ReadsEveryPartOfACase) {
    const CaseSpec spec =
        sound_case("density_kg_m3 = 1900\n[run]\nresolution = 20\nfriction = \"explicit\"\n");
    EXPECT_EQ(spec.section.file, path("section.csv"));
    EXPECT_EQ(spec.source.type, SourceType::b);
    EXPECT_DOUBLE_EQ(spec.source.base_angle, radians(35));
    EXPECT_DOUBLE_EQ(spec.source.height, 0.2);
    EXPECT_DOUBLE_EQ(spec.material.density, 1900);
    EXPECT_DOUBLE_EQ(spec.run.resolution, 20);
    EXPECT_EQ(spec.run.friction, FrictionScheme::explicit_);
    EXPECT_EQ(spec.place("source.height_m").line, 7);
    EXPECT_EQ(spec.place("source.height_m").value, "0.2");
}

TEST_F(SceneTest, ReadsPoints) {
    const CaseSpec spec =
        read_case(write("p.toml", "[source]\ntype = \"polygon\"\npoints = [[0, 0.5],\n  [1.5, 2]]\n"));
    ASSERT_EQ(spec.source.points.size(), 2u);
    EXPECT_EQ(spec.source.points[0], Vec2(0, 0.5));
    EXPECT_EQ(spec.source.points[1], Vec2(1.5, 2));
}

TEST_F(SceneTest, MakesAScene) {
    const Scene scene = make_scene(sound_case());
    EXPECT_GT(scene.source.area, 0);
    EXPECT_EQ(scene.source.type, SourceType::b);
    EXPECT_DOUBLE_EQ(scene.material.friction_angle, radians(38));
    EXPECT_DOUBLE_EQ(scene.material.density, 2000);
    EXPECT_EQ(scene.assumed, (std::vector<std::string>{"source.drop_height_m = 0.2"}));
}

TEST_F(SceneTest, PathsAreRelativeToTheCaseFile) {
    fs::create_directories(folder_ / "cases" / "one");
    const std::string file =
        write("cases/one/case.toml",
              "[section]\nfile = \"../../section.csv\"\n[material]\nfriction_angle_deg = 38\n");
    const CaseSpec spec = read_case(file);
    EXPECT_EQ(spec.section.file, path("section.csv"));
    EXPECT_EQ(spec.name, "one");
}

TEST_F(SceneTest, AbsolutePathsStay) {
    const CaseSpec spec =
        read_case(write("a.toml", fmt::format("[section]\nfile = \"{}\"\n", path("section.csv"))));
    EXPECT_EQ(spec.section.file, path("section.csv"));
    EXPECT_EQ(spec.name, "a");
}

TEST_F(SceneTest, ABareSectionIsACaseWithDefaultsThatAreSaid) {
    CaseSpec spec = read_case(path("section.csv"));
    EXPECT_EQ(spec.name, "section");
    override_value(spec, "material.friction_angle_deg", "38", "--friction-angle");
    const Scene scene = make_scene(spec);
    EXPECT_EQ(scene.source.type, SourceType::b);
    EXPECT_GT(scene.source.area, 0);
    ASSERT_EQ(scene.assumed.size(), 5u);
    EXPECT_EQ(scene.assumed[0], "source.type = B");
    EXPECT_EQ(scene.assumed[1], "source.base_angle_deg = 35");
    EXPECT_EQ(scene.assumed[2], "source.scarp_angle_deg = 80");
    EXPECT_EQ(scene.assumed[3], "source.height_m = 0.4");
    EXPECT_EQ(scene.assumed[4], "source.drop_height_m = 0.4");
}

TEST_F(SceneTest, WhatIsGivenIsNotAssumed) {
    CaseSpec spec = read_case(path("section.csv"));
    override_value(spec, "source.base_angle_deg", "40", "--base-angle");
    override_value(spec, "source.area_m2", "0.002", "--area");
    const Site site = make_site(spec);
    EXPECT_EQ(site.assumed, (std::vector<std::string>{
                                "source.type = B", "source.scarp_angle_deg = 80",
                                fmt::format("source.drop_height_m = {:.6g}", site.source.drop_height)}));
    EXPECT_NEAR(site.source.area, 0.002, 1e-12);
}

TEST_F(SceneTest, TheCommandLineReplacesTheCaseFile) {
    CaseSpec spec = sound_case();
    override_value(spec, "material.friction_angle_deg", "30", "--set");
    EXPECT_DOUBLE_EQ(spec.material.friction_angle, radians(30));
    EXPECT_EQ(spec.place("material.friction_angle_deg").file, "--set");
}

TEST_F(SceneTest, ASourceNeedsNoFrictionAngle) {
    EXPECT_GT(make_site(read_case(path("section.csv"))).source.area, 0);
    expect_complaint(input_error([&] { make_scene(read_case(path("section.csv"))); }),
                     {"section.csv", "material.friction_angle_deg", "is missing", "80 deg"});
}

TEST_F(SceneTest, AMassThatNothingStopsNeedsATimeLimit) {
    CaseSpec spec = sound_case();
    spec.material.friction_angle = 0;
    expect_complaint(input_error([&] { make_scene(spec); }),
                     {"material.friction_angle_deg", "leaves nothing that would bring the mass to rest",
                      "run.time_limit_s"});
    spec.run.time_limit = 1;
    EXPECT_NO_THROW(make_scene(spec));
    spec = sound_case();
    override_value(spec, "effects.base_friction.angle_deg", "0.1", "--set");
    expect_complaint(input_error([&] { make_scene(spec); }),
                     {"--set: effects.base_friction.angle_deg = 0.1", "leaves nothing"});
}

// --- mistakes in the file

TEST_F(SceneTest, MissingAndWrongFiles) {
    expect_complaint(input_error([&] { read_case(path("none.toml")); }), {"none.toml", "does not exist"});
    expect_complaint(input_error([&] { read_case(path("none")); }), {"none", "does not exist"});
    expect_complaint(input_error([&] { read_case(path("")); }), {"folder"});
    expect_complaint(input_error([&] { read_case(write("notes.txt", "x")); }),
                     {"notes.txt", "neither", ".toml", ".csv"});
    expect_complaint(input_error([&] { make_scene(read_case(path("none.csv"))); }), {"none.csv"});
}

TEST_F(SceneTest, EmptyFiles) {
    expect_complaint(complaint(""), {"bad.toml", "is empty"});
    expect_complaint(complaint("\n  \n"), {"bad.toml", "is empty"});
    expect_complaint(complaint("# nothing yet\n[material]\nfriction_angle_deg = 38\n"),
                     {"bad.toml", "section.file", "is missing"});
    const std::string section = write("empty.csv", "");
    CaseSpec spec = read_case(section);
    spec.material.friction_angle = 0.6;
    expect_complaint(input_error([&] { make_scene(spec); }), {"empty.csv"});
}

TEST_F(SceneTest, TextThatIsNotToml) {
    expect_complaint(complaint("[section]\nfile = section.csv\n"), {"bad.toml, line 2", "not valid TOML"});
    expect_complaint(complaint("[section\n"), {"bad.toml, line 1", "not valid TOML"});
    expect_complaint(complaint("[run]\nresolution = 20\nresolution = 30\n"),
                     {"bad.toml, line 3", "not valid TOML"});
}

TEST_F(SceneTest, UnknownKeysNameTheNearest) {
    expect_complaint(complaint("[material]\nfriction_angel_deg = 38\n"),
                     {"bad.toml, line 2", "material.friction_angel_deg = 38", "not a known key",
                      "material.friction_angle_deg"});
    expect_complaint(complaint("[material]\nfriction_angle = 38\n"),
                     {"nearest is material.friction_angle_deg"});
    expect_complaint(complaint("[materials]\ndensity_kg_m3 = 38\n"),
                     {"line 2", "nearest is material.density_kg_m3"});
    expect_complaint(complaint("[run]\nfriction_angle_deg = 38\n"),
                     {"nearest is material.friction_angle_deg"});
    expect_complaint(complaint("friction_angle_deg = 38\n"),
                     {"line 1", "nearest is material.friction_angle_deg"});
    expect_complaint(complaint("\"run.resolution\" = 38\n"), {"line 1", "not a known key"});
    expect_complaint(complaint("[sauce]\n"), {"line 1", "sauce", "not a known key"});
    expect_complaint(complaint("[[source]]\ntype = \"B\"\n"), {"line 1: source", "write [source], once"});
    expect_complaint(complaint("[run]\ncourant.max = 0.1\n"), {"line 2", "run.courant"});
}

TEST_F(SceneTest, ValuesOutOfRange) {
    expect_complaint(
        complaint("[material]\nfriction_angle_deg = 95\n"),
        {"bad.toml, line 2", "material.friction_angle_deg = 95", "out of range", "0 <= number < 80 deg"});
    expect_complaint(complaint("[run]\nresolution = 1e9\n"), {"run.resolution = 1e9", "4 <= number <= 2000"});
    expect_complaint(complaint("[run]\nfriction_iterations = 0\n"),
                     {"run.friction_iterations = 0", "whole number"});
    expect_complaint(complaint("[run]\nfriction = \"none\"\n"),
                     {"run.friction = \"none\"", "not known", "projected, explicit"});
    expect_complaint(complaint("[source]\ntype = \"D\"\n"),
                     {"source.type = \"D\"", "rectangle, A, B, C, polygon"});
}

TEST_F(SceneTest, ValuesOfTheWrongKind) {
    expect_complaint(complaint("[material]\nfriction_angle_deg = \"38\"\n"),
                     {"line 2", "\"38\"", "is not a number"});
    expect_complaint(complaint("[material]\nfriction_angle_deg = nan\n"),
                     {"line 2", "= nan", "not a finite number"});
    expect_complaint(complaint("[material]\nfriction_angle_deg = inf\n"),
                     {"line 2", "= inf", "not a finite number"});
    expect_complaint(complaint("[material]\nfriction_angle_deg = true\n"), {"line 2", "is not a number"});
    expect_complaint(complaint("[run]\nthreads = 1.5\n"), {"line 2", "1.5", "not a whole number"});
    expect_complaint(complaint("[run]\nname = 5\n"), {"line 2", "not a text in quotes"});
    expect_complaint(complaint("[run]\nname = \"\"\n"), {"line 2", "is empty"});
    expect_complaint(complaint("[source]\npoints = [1, 2]\n"), {"line 2", "entry 1", "pairs in metres"});
    expect_complaint(complaint("[source]\npoints = [[0, 0], [1, 2, 3]]\n"), {"line 2", "entry 2"});
    expect_complaint(complaint("[source]\npoints = [[0, nan], [1, 2]]\n"), {"line 2", "not finite"});
    expect_complaint(complaint("[source]\npoints = 3\n"), {"line 2", "not a list"});
}

TEST_F(SceneTest, MistakesOnTheCommandLineNameTheOption) {
    CaseSpec spec;
    const auto said = [&](const std::string& key, const std::string& text) {
        return input_error([&] { override_value(spec, key, text, "--set"); });
    };
    expect_complaint(
        said("material.friction_angle_deg", "steep"),
        {"--set", "material.friction_angle_deg = steep", "is not a number", "0 <= number < 80 deg"});
    expect_complaint(said("material.friction_angle_deg", "38deg"), {"= 38deg", "is not a number"});
    expect_complaint(said("material.friction_angle_deg", ""), {"is not a number"});
    expect_complaint(said("material.friction_angle_deg", "nan"), {"not a finite number"});
    expect_complaint(said("material.phi", "38"), {"material.phi = 38", "not a known key"});
    expect_complaint(said("source.points", "[[1,"), {"source.points", "not a list"});
    EXPECT_TRUE(spec.given.empty());
}

// --- values that do not go together

constexpr const char* with_section =
    "[section]\nfile = \"section.csv\"\n[material]\nfriction_angle_deg = 38\n";

TEST_F(SceneTest, KeysThatExcludeEachOther) {
    expect_complaint(
        complaint(std::string(with_section) + "[run]\nparticle_spacing_m = 0.001\nresolution = 40\n"),
        {"bad.toml, line 6", "run.particle_spacing_m = 0.001", "excludes run.resolution", "line 7",
         "give one of the two"});
    expect_complaint(
        complaint("[section]\nfile = \"section.csv\"\nraster = \"dem.tif\"\nline = \"line.geojson\"\n"
                  "[material]\nfriction_angle_deg = 38\n"),
        {"line 2", "section.file", "excludes section.raster", "line 3"});
    expect_complaint(complaint("[section]\nline = \"line.gpkg\"\nfeature_id = 1\nwhere = \"id = 1\"\n"
                               "[material]\nfriction_angle_deg = 38\n"),
                     {"line 3", "section.feature_id = 1", "excludes section.where", "line 4"});
    expect_complaint(
        complaint(std::string(with_section) + "[source]\ntype = \"B\"\nheight_m = 0.2\narea_m2 = 0.5\n"),
        {"bad.toml, line", "source.area_m2", "height"});
}

TEST_F(SceneTest, KeysThatNeedEachOther) {
    expect_complaint(complaint("[section]\nraster = \"dem.tif\"\n[material]\nfriction_angle_deg = 38\n"),
                     {"line 2", "section.raster", "needs section.line"});
    expect_complaint(
        complaint(
            "[section]\nfile = \"section.csv\"\nsampling_m = 0.5\n[material]\nfriction_angle_deg = 38\n"),
        {"line 3", "section.sampling_m = 0.5", "needs section.raster"});
    expect_complaint(
        complaint(
            "[section]\nfile = \"section.csv\"\nwhere = \"id = 1\"\n[material]\nfriction_angle_deg = 38\n"),
        {"line 3", "section.where", "needs section.line"});
}

TEST_F(SceneTest, KeysThatDoNotApply) {
    const std::string rectangle = "[source]\ntype = \"rectangle\"\nlength_m = 0.1\nthickness_m = 0.05\n";
    expect_complaint(
        complaint(with_section + rectangle + "scarp_angle_deg = 80\n"),
        {"line 9", "source.scarp_angle_deg = 80", "does not apply to source.type = rectangle", "B, C"});
    expect_complaint(complaint(with_section + rectangle + "points = [[0, 0], [1, 1]]\n"), {"source.points"});
    expect_complaint(complaint(std::string(with_section) + "[source]\nlength_m = 0.1\n"),
                     {"source.length_m = 0.1", "does not apply to source.type = B", "rectangle, A"});
    expect_complaint(
        complaint(std::string(with_section) + "[run]\nfriction = \"explicit\"\nfriction_iterations = 3\n"),
        {"line 7", "run.friction_iterations = 3", "does not apply"});
}

// The table says which type knows a key, and so does the geometry: they must agree.
TEST_F(SceneTest, TheTableAndTheGeometryAgreeOnTheKeysOfAType) {
    const Profile profile = make_site(sound_case()).profile;
    for (const Parameter& parameter : parameters()) {
        if (!parameter.key.starts_with("source.") || parameter.applies_to.empty()) continue;
        for (const SourceType type : {SourceType::rectangle, SourceType::a, SourceType::b, SourceType::c,
                                      SourceType::polygon, SourceType::slip_surface}) {
            CaseSpec spec;
            override_value(spec, std::string(parameter.key), sample_text(parameter), "--set");
            spec.source.type = type;
            const bool applies = std::ranges::find(parameter.applies_to, type) != parameter.applies_to.end();
            const std::string said = input_error([&] { derive_source(profile, spec.source); });
            EXPECT_EQ(contains(said, "is not used by"), !applies)
                << parameter.key << ", " << to_string(type) << ": " << said;
        }
    }
}

TEST_F(SceneTest, SourcesThatCannotBeAreNamedWithFileAndLine) {
    const std::string wedge = std::string(with_section) + "[source]\ntype = \"B\"\nbase_angle_deg = 35\n";
    expect_complaint(complaint(wedge + "scarp_angle_deg = 60\nheight_m = 0.2\n"),
                     {"bad.toml, line 8", "source.scarp_angle_deg"});
    expect_complaint(complaint(wedge + "scarp_angle_deg = 80\nheight_m = 3\n"),
                     {"bad.toml, line 9", "source.height_m"});
    expect_complaint(complaint(std::string(with_section) + "[source]\ntype = \"C\"\nheight_m = 0.2\n"),
                     {"bad.toml", "source.area_m2", "missing"});
}

TEST_F(SceneTest, SpacingsThatMakeTooFewOrTooManyParticles) {
    CaseSpec spec = sound_case();
    const double area = make_site(spec).source.area;
    const auto said = [&](double spacing) {
        CaseSpec changed = sound_case(fmt::format("[run]\nparticle_spacing_m = {}\n", spacing));
        return input_error([&] { make_scene(changed); });
    };
    expect_complaint(said(std::sqrt(area)),
                     {"case.toml, line 11", "run.particle_spacing_m", "particles", "valid:"});
    expect_complaint(said(std::sqrt(area / 6e6)), {"run.particle_spacing_m", "6e+06 particles"});
    EXPECT_EQ(said(std::sqrt(area / 5)), "");
    EXPECT_EQ(said(std::sqrt(area / 4e6)), "");
}

// --- what is shipped

bool is_study(const fs::path& file) {
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    return text.str().find("[study]") != std::string::npos;
}

void expect_sound_case(const fs::path& file) {
    SCOPED_TRACE(file);
    std::vector<Scene> scenes;
    const std::string said = input_error([&] {
        for (const CaseSpec& spec : section_cases(read_case(file.string())))
            scenes.push_back(make_scene(spec));
    });
    ASSERT_EQ(said, "");
    const std::string folder = file.parent_path().filename().string();
    for (const Scene& scene : scenes) {
        EXPECT_EQ(scene.name.substr(0, scene.name.find('-')), folder.substr(0, folder.find('-')));
        // Of many sections, height and place of the source follow from each; of a back-analysis, from its
        // ranges.
        EXPECT_TRUE(scene.assumed.empty() || scenes.size() > 1 ||
                    fs::exists(file.parent_path() / "ranges.csv"));
        EXPECT_GT(scene.source.area, 0);
    }
}

// --- effects

constexpr const char* sound_text =
    "[section]\nfile = \"section.csv\"\n[source]\ntype = \"B\"\nheight_m = 0.2\n"
    "[material]\nfriction_angle_deg = 38\n";

TEST_F(SceneTest, EffectsAreThereOnlyWhereTheCaseNamesThem) {
    EXPECT_TRUE(effect_settings(make_scene(sound_case()).effects, Profile{}).empty());
    const Scene scene = make_scene(sound_case(
        "[effects.cohesion]\ncohesion_kpa = 0.5\n[effects.base_friction]\nranges = [[0.5, 1, 10]]\n"
        "[effects.barrier]\nchainage_m = 1\nheight_m = 0.1\n"
        "[[gauge]]\nchainage_m = 0.5\n[[gauge]]\nname = \"house\"\nchainage_m = 0.75\n"));
    EXPECT_EQ(scene.effects.cohesion->strength, 500);
    EXPECT_NEAR(scene.effects.base_friction->ranges.at(0).from, 0.05, 1e-12);  // the toe is at 0.45
    EXPECT_NEAR(scene.effects.barrier->x, 0.55, 1e-12);
    EXPECT_NEAR(scene.effects.barrier->thickness, 0.05, 1e-12);
    EXPECT_FALSE(scene.effects.rate || scene.effects.pore_pressure || scene.effects.release);
    ASSERT_EQ(scene.gauges.size(), 2U);
    EXPECT_EQ(scene.gauges[0].name, "gauge-1");
    EXPECT_EQ(scene.gauges[1].name, "house");
    EXPECT_NEAR(scene.gauges[1].x, 0.3, 1e-12);
    EXPECT_EQ(scene.run.friction_iterations, 60);
    EXPECT_EQ(scene.run.pressure_tolerance, 1e-3);
    ASSERT_GE(scene.assumed.size(), 2U);
    EXPECT_EQ(scene.assumed.end()[-2], "run.friction_iterations = 60, for a cohesive soil");
    EXPECT_EQ(scene.assumed.end()[-1], "run.pressure_tolerance = 0.001, for a cohesive soil");
}

TEST_F(SceneTest, LaterMassesLeaveTheHillOneAfterTheOther) {
    const Scene scene = make_scene(sound_case(
        "[[effects.release.mass]]\ntime_s = 1\npoints = [[0.2, 0.4], [0.3, 0.4], [0.3, 0.5], [0.2, 0.5]]\n"));
    ASSERT_EQ(scene.effects.release->masses.size(), 1U);
    EXPECT_NEAR(scene.effects.release->masses[0].area, 0.01, 1e-12);
}

TEST_F(SceneTest, AShakingRecordIsRead) {
    write("quake.csv", "time_s,horizontal_m_s2\n0,0\n0.5,2 # peak\n1,0\n");
    const Scene scene = make_scene(sound_case("[effects.shaking]\nrecord = \"quake.csv\"\n"));
    EXPECT_EQ(scene.effects.shaking->time, (std::vector<double>{0, 0.5, 1}));
    EXPECT_EQ(scene.effects.shaking->horizontal, (std::vector<double>{0, 2, 0}));
    const Scene constant = make_scene(sound_case("[effects.shaking]\nhorizontal_coefficient = 0.1\n"));
    EXPECT_NEAR(constant.effects.shaking->horizontal.at(0), -0.981, 1e-12);
}

TEST_F(SceneTest, EffectsThatContradictThemselvesAreRefused) {
    const auto expect = [&](const std::string& more, const std::vector<std::string>& parts) {
        SCOPED_TRACE(more);
        expect_complaint(complaint(sound_text + more), parts);
    };
    write("quake.csv", "time_s,horizontal_m_s2\n0,0\n0.5,2\n1,0\n");
    write("late.csv", "time_s,horizontal_m_s2\n0.5,0\n1,0\n");
    expect("[effects.cohesion]\n", {"bad.toml, line 8", "effects.cohesion", "is named without a key"});
    expect("[effects.cohesion]\ntension_cut_off_kpa = 1\n", {"needs effects.cohesion.cohesion_kpa"});
    expect("[effects.cohesion]\ncohesion_kpa = 1\ntension_cut_off_kpa = 2\n",
           {"more than this soil can bear", "1.28 kPa"});
    expect("[effects.rate]\nfriction_increase = 0.2\n", {"needs effects.rate.grain_diameter_m"});
    expect("[effects.pore_pressure]\ndissipation_time_s = 2\n",
           {"needs effects.pore_pressure.base_excess_ratio"});
    expect("[effects.pore_pressure]\nratio = 0.1\nratio_points = [[0, 0.1]]\n", {"excludes"});
    expect("[effects.pore_pressure]\nratio_points = [[0, 0.1, 3]]\n",
           {"row 1 that is not complete", "[chainage m, r_u]"});
    expect("[effects.pore_pressure]\nratio_points = [[0, 1.1]]\n", {"r_u = 1.1", "0 <= r_u <= 1"});
    expect("[effects.barrier]\nchainage_m = 1\n", {"needs effects.barrier.height_m"});
    expect("[effects.barrier]\nchainage_m = 1\nheight_m = inf\n", {"is not a finite number"});
    expect("[effects.barrier]\nchainage_m = 9\nheight_m = 0.1\n", {"is not on the section at chainage 9 m"});
    expect("[effects.barrier]\nchainage_m = 0.4\nheight_m = 0.1\n", {"into the source or uphill of it"});
    expect("[effects.shaking]\nrecord = \"quake.csv\"\n[run]\ntime_limit_s = 3\n",
           {"ends at 1 s, before run.time_limit_s = 3"});
    expect("[effects.shaking]\nrecord = \"late.csv\"\n", {"late.csv, line 2", "is not 0 in the first row"});
    expect("[effects.shaking]\nrecord = \"none.csv\"\n", {"none.csv", "does not exist"});
    expect("[effects.side_walls]\nwidth_m = 3\n", {"needs effects.side_walls.friction_angle_deg"});
    expect("[effects.base_friction]\nranges = [[1, 0.5, 10]]\n", {"from 1 to 0.5 m"});
    expect("[effects.base_friction]\nranges = [[0.5, 1, 10], [0.8, 1.2, 12]]\n", {"overlap"});
    expect("[effects.erodible_bed]\ndepth_m = 0.1\n", {"needs effects.erodible_bed.from_chainage_m"});
    expect("[[effects.release.mass]]\ntime_s = 2\n", {"needs effects.release.mass.points"});
    expect("[[effects.rate]]\ngrain_diameter_m = 2\n", {"stands several times"});
    expect("[[gauge]]\nname = \"a\"\n", {"gauge.name", "needs gauge.chainage_m"});
    expect("[[gauge]]\nchainage_m = 1\n[[gauge]]\nname = \"b\"\n", {"is missing for [[gauge]] 2"});
    expect("[[gauge]]\nchainage_m = 99\n", {"is not on the section"});
    expect("[effects.glue]\nx = 1\n", {"effects.glue"});
}

/// A folder of the validation that makes no run has no case file; `numerics` is the only one.
TEST(ShippedCases, AllMakeScenes) {
    int count = 0;
    for (const auto& folder : fs::directory_iterator(fs::path(RUNOUT_SOURCE_DIR) / "cases")) {
        SCOPED_TRACE(folder.path());
        EXPECT_TRUE(fs::exists(folder.path() / "README.md"));
        int files = 0;
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            if (entry.path().extension() != ".toml" || is_study(entry.path())) continue;
            expect_sound_case(entry.path());
            ++files;
        }
        EXPECT_TRUE(files > 0 || folder.path().filename() == "numerics");
        count += files;
    }
    EXPECT_GE(count, 5);
}

TEST(ShippedCases, Fig15IsTheSourceOfThePaper) {
    const Scene scene = make_scene(read_case(std::string(RUNOUT_SOURCE_DIR) + "/cases/fig15/case.toml"));
    EXPECT_NEAR(scene.source.area / 0.0043, 1, 1e-12);
    EXPECT_NEAR(scene.source.front_area / scene.source.area, 0.68782, 5e-6);
}

}  // namespace
}  // namespace runout
