// From a case file to a scene: what is read, what is assumed, what is shipped.

#include <sstream>

#include "core/units.h"
#include "scene/effect_settings.h"
#include "scene/section_cases.h"
#include "scene_fixture.h"

namespace runout {
namespace {

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
    EXPECT_EQ(spec.source.points[0], SectionPoint(0, 0.5));
    EXPECT_EQ(spec.source.points[1], SectionPoint(1.5, 2));
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
    fs::create_directories(folder_.path() / "cases" / "one");
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

// --- effects

constexpr const char* sound_text =
    "[section]\nfile = \"section.csv\"\n[source]\ntype = \"B\"\nheight_m = 0.2\n"
    "[material]\nfriction_angle_deg = 38\n";

TEST_F(SceneTest, EffectsAreThereOnlyWhereTheCaseNamesThem) {
    EXPECT_TRUE(effect_settings(make_scene(sound_case()).effects, Profile{}).empty());
    const Scene scene = make_scene(sound_case(
        "[effects.cohesion]\ncohesion_kpa = 0.5\n[effects.base_friction]\nranges = [[0.5, 1, 10]]\n"
        "[effects.barrier]\nchainage_m = 1\nheight_m = 0.1\n"
        "[[place]]\nchainage_m = 0.5\n[[place]]\nname = \"house\"\nchainage_m = 0.75\n"));
    EXPECT_EQ(scene.effects.cohesion->strength, 500);
    EXPECT_NEAR(scene.effects.base_friction->ranges.at(0).from, 0.05, 1e-12);  // the toe is at 0.45
    EXPECT_NEAR(scene.effects.barrier->x, 0.55, 1e-12);
    EXPECT_NEAR(scene.effects.barrier->thickness, 0.05, 1e-12);
    EXPECT_FALSE(scene.effects.rate || scene.effects.pore_pressure || scene.effects.release);
    ASSERT_EQ(scene.places.size(), 2U);
    EXPECT_EQ(scene.places[0].name, "place-1");
    EXPECT_EQ(scene.places[1].name, "house");
    EXPECT_NEAR(scene.places[1].x, 0.3, 1e-12);
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
    EXPECT_NEAR(scene.effects.release->masses[0].mass.area, 0.01, 1e-12);
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
    expect("[[place]]\nname = \"a\"\n", {"place.name", "needs place.chainage_m"});
    expect("[[place]]\nchainage_m = 1\n[[place]]\nname = \"b\"\n", {"is missing for [[place]] 2"});
    expect("[[place]]\nchainage_m = 99\n", {"is not on the section"});
    expect("[effects.glue]\nx = 1\n", {"effects.glue"});
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
        for (const auto& [spec, line] : section_cases(read_case(file.string())))
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
