// Careless and hostile input of a case or a study: each attempt that once got through is tried again.

#include <cmath>

#include "scene_fixture.h"
#include "study/scenarios.h"
#include "study/study_file.h"

namespace runout {
namespace {

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int k = 0; k < times; ++k) all += text;
    return all;
}

constexpr int very_deep = 50'000;
constexpr const char* sound_text =
    "[section]\nfile = \"section.csv\"\n[source]\nbase_angle_deg = 35\nscarp_angle_deg = 80\nheight_m = 0.2\n"
    "[material]\nfriction_angle_deg = 38\n";  // 8 lines

class Security : public SceneTest {
  protected:
    [[nodiscard]] std::string said_of_study(const std::string& text) const {
        const std::string file = write("study.toml", text);
        return input_error([&] { const Combinations all(read_study(file)); });
    }
    [[nodiscard]] std::string said_with(const std::string& more) const {
        return complaint(sound_text + more);
    }
};

// ---- names and nesting

TEST_F(Security, AZeroByteEndsNoPath) {
    write("x.csv", "chainage_m,elevation_m\n0,0.4\n0.3,0.4\n0.45,0\n2,0\n");
    for (const char* key : {"section.file", "section.raster", "section.line", "section.layer",
                            "section.where", "effects.shaking.record", "run.name", "place.name"}) {
        const std::string name(key);
        const std::size_t dot = name.rfind('.');
        expect_complaint(complaint(fmt::format("[{}]\n{} = \"x.csv\\u0000.png\"\n", name.substr(0, dot),
                                               name.substr(dot + 1))),
                         {"bad.toml, line 2", name, "zero byte"});
    }
    expect_complaint(said_of_study("[study]\ncase = \"x.csv\\u0000.png\"\n[vary]\na = [1]\n"),
                     {"line 2", "study.case", "zero byte"});
    expect_complaint(said_of_study("[study]\nname = \"x\\u0000\"\n[vary]\na = [1]\n"), {"study.name"});
    EXPECT_FALSE(input_error([&] {
                     CaseSpec spec;
                     override_value(spec, "section.file", std::string("x.csv\0.png", 10), "--set");
                 }).empty());
}

TEST_F(Security, NestingEndsBeforeTheParser) {
    const std::vector<std::string> deep = {
        "a" + repeated(".a", very_deep) + " = 1\n",
        "\"a\"" + repeated(" . 'a'", very_deep) + " = 1\n",
        "[a" + repeated(".a", very_deep) + "]\n",
        "a = " + repeated("[", very_deep) + "\n",
        "a = " + repeated("{ a = ", very_deep) + "\n",
        "a = [ \"\"\"b\"\"\"\", " + repeated("[", very_deep) + "\n",
        "a = [ '''b''''', \"\\\"\", '\\', " + repeated("[", very_deep) + "\n",
    };
    for (const std::string& text : deep) {
        expect_complaint(complaint(text), {"bad.toml, line 1: has "});
        expect_complaint(said_of_study("[vary]\n" + text), {"study.toml, line 2: has "});
    }
    CaseSpec spec;
    expect_complaint(
        input_error([&] { override_value(spec, "source.points", repeated("[", very_deep), "--set"); }),
        {"is not a list"});
    // What only looks deep is not.
    const std::string dots = repeated("a.", 1000), brackets = repeated("[", 1000);
    const CaseSpec sound = read_case(write("dots.toml", "[run]\nname = \"" + dots + "\" # " + brackets +
                                                            dots + "\n[section]\nwhere = '" + brackets +
                                                            "'\nlayer = \"\"\"\n" + brackets + "\n\"\"\"\n"));
    EXPECT_EQ(sound.name, dots);
    EXPECT_EQ(sound.section.map.line.where, brackets);
    std::string many = "[source]\npoints = [[0.5, 0.5]";
    for (int k = 0; k < 1000; ++k) many += fmt::format(", [{}.5, 0.25]", k);
    EXPECT_EQ(read_case(write("many.toml", many + "]\n")).source.points.size(), 1001U);
}

TEST_F(Security, TextsHaveALength) {
    expect_complaint(complaint("# " + std::string(5'000'000, 'x') + "\n"),
                     {"bad.toml", "is longer than 4 MB"});
    expect_complaint(complaint("[run]\nname = \"" + std::string(5000, 'x') + "\"\n"),
                     {"line 2: run.name", "is longer than 4096 characters"});
    // A message stays a line that a person reads.
    EXPECT_LT(complaint("[run]\n" + std::string(100'000, 'x') + " = 1\n").size(), 400U);
    EXPECT_LT(said_of_study("[vary]\nsource.type = \"" + std::string(100'000, 'x') + "\"\nx = []\n").size(),
              400U);
    expect_complaint(input_error([&] { read_case("/dev/zero.toml"); }), {"does not exist"});
    fs::create_symlink("/dev/zero", path("zero.toml"));
    expect_complaint(input_error([&] { read_case(path("zero.toml")); }), {"is a pipe or a device"});
    expect_complaint(input_error([&] { read_study(path("zero.toml")); }), {"is a pipe or a device"});
}

TEST_F(Security, ListsHaveALength) {
    const auto list = [](int count, const std::string& entry) {
        return "[" + repeated(entry + ", ", count) + entry + "]\n";
    };
    expect_complaint(complaint("[source]\npoints = " + list(10'000, "[1, 2]")),
                     {"line 2: source.points", "has 10001 entries", "at most 10000"});
    expect_complaint(complaint("[effects.base_friction]\nranges = " + list(10'000, "[1, 2, 3]")),
                     {"10001 entries"});
    expect_complaint(complaint("[run]\nsnapshot_times_s = " + list(10'000, "1")), {"10001 entries"});
    expect_complaint(complaint(repeated("[[place]]\nchainage_m = 1\n", 1001)),
                     {"line 1: place", "stands 1001 times", "at most 1000"});
}

// ---- what is said twice

TEST_F(Security, NoKeyCountsTwice) {
    const std::string mass =
        "[[effects.release.mass]]\ntime_s = 1\npoints = [[0.2, 0.4], [0.25, 0.4], [0.25, 0.45]]\n";
    expect_complaint(
        said_with(mass +
                  "[[\"effects.release.mass\"]]\ntime_s = 2\npoints = [[0, 0.4], [0.1, 0.4], [0, 0.5]]\n"),
        {"effects.release.mass", "is a dotted key in quotes", "without the quotes"});
    expect_complaint(said_with("[run]\n\"a.b\" = 1\n"), {"line 10: run.a.b = 1", "dotted key in quotes"});
    expect_complaint(said_with("[\"effects.cohesion\"]\ncohesion_kpa = 1\n"), {"dotted key in quotes"});
    expect_complaint(said_of_study("[vary]\nmaterial.friction_angle_deg = [31, 33]\n"
                                   "\"material.friction_angle_deg\" = [35, 37]\n"),
                     {"study.toml, line 3", "material.friction_angle_deg", "is varied in line 2 too"});
    expect_complaint(said_of_study("[vary]\nsource.area_m2 = [1]\n[vary.\"source\"]\nheight_m = [1]\n"),
                     {"line 3"});
    EXPECT_EQ(said_of_study("[vary]\n\"source.area_m2\" = [1, 2]\nsource.height_m = [1]\n"), "");
    // What is no table or no text is not passed over.
    expect_complaint(said_of_study("study = 5\n[vary]\na = [1]\n"), {"line 1: study = 5", "is not a table"});
    expect_complaint(said_of_study("[study]\nname = 5\n[vary]\na = [1]\n"), {"study.name = 5", "not a text"});
    expect_complaint(said_of_study("[vary]\na = { from = true, to = 3, step = 1 }\n"),
                     {"from", "not a number"});
    EXPECT_EQ(said_of_study("[vary]\na = { from = 9007199254740993, to = 9007199254740993, step = 1 }\n"),
              "");
}

TEST_F(Security, GroundLeavesTheHillOnce) {
    const auto mass = [](int time, const std::string& points) {
        return fmt::format("[[effects.release.mass]]\ntime_s = {}\npoints = {}\n", time, points);
    };
    const std::string behind = "[[0.1, 0.4], [0.1, 0.3], [0.2, 0.25], [0.25, 0.4]]";
    EXPECT_EQ(said_with(mass(1, behind)), "");
    expect_complaint(said_with(mass(1, behind) + mass(2, behind) + mass(3, behind)),
                     {"effects.release.mass.points", "of mass 2 have left the hill", "ground of its own"});
    expect_complaint(
        said_with(mass(1, behind) + mass(2, "[[0.05, 0.4], [0.05, 0.3], [0.15, 0.3], [0.15, 0.4]]")),
        {"overlaps", "mass 2"});
    // Two that share an edge do not overlap, nor do masses dumped at one place above the ground.
    EXPECT_EQ(said_with(mass(1, behind) + mass(2, "[[0, 0.4], [0, 0.3], [0.1, 0.3], [0.1, 0.4]]")), "");
    const std::string heap = "[[0.05, 0.4], [0.15, 0.4], [0.15, 0.5], [0.05, 0.5]]";
    EXPECT_EQ(said_with(mass(1, heap) + mass(2, heap)), "");
    // Nor may a mass be what the source has taken.
    expect_complaint(said_with(mass(1, "[[0.45, 0], [0.375, 0.2], [0.4, 0.1]]")), {"overlaps", "mass 1"});
}

TEST_F(Security, APolygonIsPartOfTheHillOrStandsOnIt) {
    const auto said = [&](const std::string& points) {
        return complaint("[section]\nfile = \"section.csv\"\n[source]\ntype = \"polygon\"\npoints = " +
                         points + "\n[material]\nfriction_angle_deg = 38\n");
    };
    EXPECT_EQ(said("[[0.3, 0.4], [0.45, 0], [0.25, 0.2], [0.25, 0.4]]"), "") << "in the hill";
    EXPECT_EQ(said("[[0.1, 0.4], [0.2, 0.4], [0.2, 0.6], [0.1, 0.6]]"), "") << "on it";
    EXPECT_EQ(said("[[0.3, 0.4], [0.45, 0], [0.25, 0.2], [0.25, 0.4005]]"), "") << "a drawing's rounding";
    expect_complaint(said("[[1, 1], [1.5, 1], [1.5, 1.5], [1, 1.5]]"),
                     {"line 5: source.points", "lies in the air", "all of its 0.25 m2", "0.5 m2 of air below",
                      "within the hill"});
    expect_complaint(said("[[0.1, 0.3], [0.2, 0.3], [0.2, 0.5], [0.1, 0.5]]"),
                     {"lies partly in the air: 0.01 of its 0.02 m2"});
    expect_complaint(said("[[0.1, 0.4], [0.4, 0.4], [0.4, 0.5], [0.1, 0.5]]"),
                     {"lies in the air", "air below it"});
}

// ---- numbers without end

TEST_F(Security, CombinationsAreCountedBeforeTheyAreMade) {
    const std::string range = " = { from = 1, to = 1000, step = 1 }\n";
    std::string text = "[vary]\n";
    for (const char* key : {"a", "b", "c", "d"}) text += key + range;
    expect_complaint(said_of_study(text), {"study.toml", "asks for 1e+12 combinations", "at most 1000000"});
    for (int k = 0; k < 200; ++k) text += fmt::format("k{}{}", k, range);
    expect_complaint(said_of_study(text), {"combinations", "at most 1000000"});
    const Study study = read_study(write("study.toml", "[vary]\na" + range + "b" + range));
    const Combinations all(study);
    ASSERT_EQ(all.size(), 1'000'000U);
    EXPECT_EQ(all[999'999], (std::vector<Setting>{{"a", "1000"}, {"b", "1000"}}));
    EXPECT_EQ(all[1'000], (std::vector<Setting>{{"a", "2"}, {"b", "1"}}));
}

TEST_F(Security, DistributionsHaveSomethingToDraw) {
    const auto said = [&](const std::string& spread) {
        return said_of_study("[study]\nsamples = 3\n[vary]\na = { distribution = " + spread + " }\n");
    };
    EXPECT_EQ(said("\"normal\", mean = 0, deviation = 1"), "");
    EXPECT_EQ(said("\"normal\", mean = 0, deviation = 1, low = 1, high = 2"), "");
    for (const char* spread :
         {"\"normal\", mean = 0, deviation = 1, low = 1e300, high = 1e301",
          "\"normal\", mean = 0, deviation = 1, low = 20", "\"uniform\", low = -1e308, high = 1e308",
          "\"normal\", mean = 1e308, deviation = 1e308", "\"lognormal\", mean = 1e-320, deviation = 1e300"})
        expect_complaint(said(spread), {"study.toml, line 4: a", "nothing can be drawn from"});
}

TEST_F(Security, RecordsAreOfAnEarthquake) {
    const auto said = [&](const std::string& rows, const std::string& more = "") {
        write("quake.csv", "time_s,horizontal_m_s2,vertical_m_s2\n0,0,0\n" + rows);
        return said_with("[effects.shaking]\nrecord = \"quake.csv\"\n" + more);
    };
    EXPECT_EQ(said("0.005,30,-9\n1,0,0\n"), "");
    expect_complaint(
        said("1,0,0\n1.000000001,3,0\n1.000000002,0,0\n"),
        {"quake.csv, line 4: time_s = 1.000000001", "comes 1e-09 s after the row before", "1e-05 s"});
    expect_complaint(said("0.1,300,0\n0.2,0,0\n"),
                     {"quake.csv, line 3: horizontal_m_s2 = 300", "30.6 times the gravity", "gal"});
    expect_complaint(said("0.1,0,-1e300\n0.2,0,0\n"),
                     {"line 3: vertical_m_s2 = -1e300", "times the gravity"});
    expect_complaint(said("0.1,0,0\n1e12,0,0\n"), {"line 4: time_s = 1e12", "3600 s"});
    EXPECT_EQ(said("0.1,300,0\n0.2,0,0\n", "[run]\ngravity_m_s2 = 490\ntime_limit_s = 0.1\n"), "")
        << "a model in a centrifuge";
}

TEST_F(Security, LengthsAreThoseOfTheMass) {
    expect_complaint(said_with("[run]\nfront_thickness_m = 1e300\n"),
                     {"line 10: run.front_thickness_m = 1e300", "out of proportion to the mass"});
    expect_complaint(said_with("[effects.side_walls]\nwidth_m = 5e-324\nfriction_angle_deg = 30\n"),
                     {"line 10: effects.side_walls.width_m = 5e-324", "out of proportion to the mass"});
    const std::string layers = "[effects.release]\nlayers = 3\nlayer_width_m = {}\nlayer_height_m = 0.1\n";
    for (const char* width : {"1e300", "1e-300"})
        expect_complaint(said_with(fmt::format(fmt::runtime(layers), width)),
                         {"effects.release.layer_width_m", "out of proportion to the mass"});
    EXPECT_EQ(said_with(fmt::format(fmt::runtime(layers), "0.1")), "");
    expect_complaint(
        said_with("[effects.erodible_bed]\ndepth_m = 1e308\nfrom_chainage_m = 1\nto_chainage_m = 2\n"),
        {"effects.erodible_bed.depth_m", "out of proportion to the mass"});
    expect_complaint(said_with("[run]\ngravity_m_s2 = 1e-300\n"), {"out of range"});
    EXPECT_EQ(said_with("[run]\nfront_thickness_m = 0.01\n"), "");
}

// ---- what never comes to rest

TEST_F(Security, ASlipperyWallIsNoSlipperyBed) {
    write("section.csv", "chainage_m,elevation_m\n0,0.4\n0.3,0.4\n0.45,0.1\n0.45,0\n2,0\n");
    const auto base = [](const std::string& text) { return "[effects.base_friction]\n" + text + "\n"; };
    EXPECT_EQ(said_with(base("ranges = [[0.44, 0.46, 0]]")), "") << "the wall";
    EXPECT_EQ(said_with(base("ranges = [[0.3, 0.45, 0]]")), "") << "steeper than any soil lies";
    expect_complaint(said_with(base("ranges = [[1, 1.8, 0]]")),
                     {"bad.toml, line 10: effects.base_friction.ranges = [[1, 1.8, 0]]",
                      "from chainage 1 to 1.8 m", "0.58 deg", "run.time_limit_s"});
    expect_complaint(said_with(base("angle_deg = 0")), {"line 10: effects.base_friction.angle_deg = 0",
                                                        "nothing that would bring the mass to rest"});
    EXPECT_EQ(said_with(base("angle_deg = 0\nranges = [[-1, 0.3, 20], [0.45, 3, 20]]")), "");
    EXPECT_EQ(said_with(base("angle_deg = 0") + "[run]\ntime_limit_s = 1\n"), "");
}

TEST_F(Security, WaterThatBearsAllLeavesNoFriction) {
    const auto water = [&](const std::string& text) {
        return said_with("[effects.pore_pressure]\n" + text + "\n");
    };
    EXPECT_EQ(water("ratio = 0.9"), "");
    expect_complaint(water("ratio = 1"), {"line 10: effects.pore_pressure.ratio = 1",
                                          "nothing that would bring the mass to rest", "up to 0.983"});
    expect_complaint(water("ratio_points = [[0, 0.2], [0.4, 1]]"), {"effects.pore_pressure.ratio_points"});
    EXPECT_EQ(water("ratio_points = [[0, 0.2], [0.4, 0.3], [1.5, 0.3], [1.6, 1]]"), "")
        << "no soil starts there";
    EXPECT_EQ(water("ratio_points = [[0, 1], [0.37, 0.2]]"), "") << "none there either";
    expect_complaint(water("ratio = 0.5\nbase_excess_ratio = 0.5"),
                     {"effects.pore_pressure.base_excess_ratio"});
    EXPECT_EQ(water("ratio = 0.5\nbase_excess_ratio = 0.5\ndissipation_time_s = 1"), "");
    EXPECT_EQ(water("ratio = 1\n[run]\ntime_limit_s = 1"), "");
    EXPECT_EQ(water("ratio = 1\n[effects.cohesion]\ncohesion_kpa = 1"), "");
}

}  // namespace
}  // namespace runout
