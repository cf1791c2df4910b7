// Every mistake in a case file is one sentence that names file, line, key, value and what is valid.

#include "scene_fixture.h"
#include "source/source_types.h"

namespace runout {
namespace {

// --- mistakes in the file

TEST_F(SceneTest, MissingAndWrongFiles) {
    expect_complaint(input_error([&] { read_case(path("none.toml")); }), {"none.toml", "does not exist"});
    expect_complaint(input_error([&] { read_case(path("none")); }), {"none", "does not exist"});
    expect_complaint(input_error([&] { read_case(path("")); }), {"folder"});
    expect_complaint(input_error([&] { read_case(write("notes.md", "x")); }),
                     {"notes.md", "neither", ".toml", ".csv"});
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
    expect_complaint(complaint("\"run.resolution\" = 38\n"), {"line 1", "dotted key in quotes"});
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
        for (const SourceTypeRow& row : source_types()) {
            const SourceType type = row.type;
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

}  // namespace
}  // namespace runout
