// Many lines as a user has them: one that is no section does not stop the others, and is never missing
// unsaid.

#include <SQLiteCpp/Database.h>

#include "program_fixture.h"

namespace runout {
namespace {

class ProgramLines : public ProgramTest {
  protected:
    /// A line of 2.5 m with a cut of 0.4 m, at a northing; with its elevations or in the plane.
    static std::string feature(const std::string& name, int row, bool good = true) {
        const double y = 815900 + 10 * row;
        const auto vertex = [&](double x, double z) {
            return good ? fmt::format("[{},{},{}]", 834000 + x, y, z) : fmt::format("[{},{}]", 834000 + x, y);
        };
        return fmt::format(
            R"({{"type":"Feature","properties":{{"name":"{}"}},"geometry":{{"type":"LineString",)"
            R"("coordinates":[{},{},{},{}]}}}})",
            name, vertex(0, 10.4), vertex(0.3, 10.4), vertex(0.45, 10), vertex(2.5, 10));
    }
    void write_layer(const std::string& file, const std::vector<std::string>& features) const {
        write(file,
              fmt::format(R"({{"type":"FeatureCollection","name":"cuts","crs":{{"type":"name","properties":)"
                          R"({{"name":"urn:ogc:def:crs:EPSG::2326"}}}},"features":[{}]}})",
                          fmt::join(features, ",")));
    }
    static Arguments with_source(Arguments arguments) {
        for (const char* word : {"--base-angle", "35", "--height", "0.15", "--drop-height", "0.3",
                                 "--friction-angle", "38", "--resolution", "6", "--no-pilots"})
            arguments.emplace_back(word);
        return arguments;
    }
};

TEST_F(ProgramLines, OneBadLineDoesNotStopTheOthers) {
    write_layer("l.geojson", {feature("A", 0), feature("B", 1, false), feature("C", 2)});
    const Outcome profile = runout({"profile", "l.geojson", "--refused", "bad.csv"});
    EXPECT_EQ(profile.exit_code, 1);
    EXPECT_TRUE(contains(profile.out, "l-A"));
    EXPECT_TRUE(contains(profile.out, "l-C"));
    EXPECT_TRUE(profile.out.ends_with("2 good, 1 refused\n")) << profile.out;
    EXPECT_TRUE(contains(profile.err,
                         "feature 1 (B) is refused: l.geojson: feature 1 = LINESTRING: has no elevations"));
    EXPECT_TRUE(
        contains(text_of(work("bad.csv")), "origin,feature_id,name,reason\n\"l.geojson, layer cuts\",1,B,"));

    const Outcome run = runout(with_source({"run", "l.geojson", "--db", "l.db", "--quiet"}));
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_TRUE(run.out.ends_with("2 good, 1 refused\n")) << run.out;
    EXPECT_TRUE(contains(run.err, "feature 1 (B) is refused"));
    EXPECT_TRUE(contains(runout({"table", "l.db"}).out, "l-C"));

    EXPECT_EQ(runout({"map", "l.db", "-o", "m.geojson"}).exit_code, 0);
    const Json map = Json::parse(text_of(work("m.geojson")));
    int refused = 0;
    for (const Json& feature : map["features"]) {
        if (feature["properties"]["layer"] != "refused") continue;
        ++refused;
        EXPECT_EQ(feature["properties"]["name"], "B");
        EXPECT_EQ(feature["properties"]["feature_id"], 1);
        EXPECT_TRUE(contains(feature["properties"]["reason"], "has no elevations"));
        EXPECT_EQ(feature["geometry"]["type"], "LineString");
    }
    EXPECT_EQ(refused, 1);
}

TEST_F(ProgramLines, ALineThatIsMendedIsStruckOff) {
    write_layer("l.geojson", {feature("A", 0), feature("B", 1, false)});
    EXPECT_EQ(runout(with_source({"run", "l.geojson", "--db", "l.db", "--quiet"})).exit_code, 1);
    const auto refused = [this] {
        return SQLite::Database(work("l.db")).execAndGet("SELECT count(*) FROM refused_section").getInt();
    };
    EXPECT_EQ(refused(), 1);
    write_layer("l.geojson", {feature("A", 0), feature("B", 1)});
    EXPECT_EQ(runout(with_source({"run", "l.geojson", "--db", "l.db", "--quiet"})).exit_code, 0);
    EXPECT_EQ(refused(), 0);
}

TEST_F(ProgramLines, WhenAllAreBadNothingIsWritten) {
    write_layer("l.geojson", {feature("A", 0, false), R"({"type":"Feature","properties":{"name":"P"},)"
                                                      R"("geometry":{"type":"Point","coordinates":[1,2]}})"});
    for (const Arguments& arguments :
         {Arguments{"profile", "l.geojson"}, with_source({"run", "l.geojson", "--db", "l.db"})}) {
        const std::set<std::string> before = files();
        const Outcome outcome = runout(arguments);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_TRUE(contains(outcome.err, "feature 0 (A) is refused"));
        EXPECT_TRUE(
            contains(outcome.err, "feature 1 (P) is refused: l.geojson: feature 1 = POINT: is not a line"));
        EXPECT_TRUE(contains(outcome.err, "has no line that can be taken: 0 good, 2 refused"));
        EXPECT_EQ(files(), before);
    }
}

TEST_F(ProgramLines, LinesThatCannotBeDrawnAreRefusedAsWell) {
    std::vector<std::string> features = {feature("A", 0)};
    for (const char* geometry : {R"({"type":"LineString","coordinates":[]})",
                                 R"({"type":"LineString","coordinates":[[834000,815900,1]]})", "null",
                                 R"({"type":"MultiLineString","coordinates":[[[1,2],[3,4]],[[5,6],[7,8]]]})"})
        features.push_back(fmt::format(R"({{"type":"Feature","properties":{{}},"geometry":{}}})", geometry));
    write_layer("l.geojson", features);
    EXPECT_EQ(runout(with_source({"run", "l.geojson", "--db", "l.db", "--quiet"})).exit_code, 1);
    const Outcome map = runout({"map", "l.db", "-o", "m.gpkg"});
    EXPECT_EQ(map.exit_code, 0) << map.err;
    EXPECT_TRUE(contains(map.out, "refused                      4"));
}

TEST_F(ProgramLines, AMistakeOfTheCaseIsSaidOnce) {
    write_layer("l.geojson", {feature("A", 0), feature("B", 1)});
    expect_refused({"run", "l.geojson"}, {"material.friction_angle_deg: is missing"});
    expect_refused({"profile", "l.geojson", "--raster", "none.tif"}, {"none.tif: cannot be opened"});
}

TEST_F(ProgramLines, ASweepGoesOnAndCountsItsSections) {
    write_layer("l.geojson", {feature("A", 0), feature("B", 1, false), feature("C", 2)});
    write("study.toml",
          "[study]\nname = \"s\"\ncase = \"case.toml\"\n[vary]\nmaterial.friction_angle_deg = [36, 38]\n");
    write("case.toml",
          "[section]\nline = \"l.geojson\"\n[source]\nbase_angle_deg = 35\nheight_m = 0.15\ndrop_height_m = "
          "0.3\n"
          "[run]\nresolution = 6\n");
    const Outcome sweep = runout({"sweep", "study.toml", "--db", "s.db", "--refused", "bad.csv", "--quiet"});
    EXPECT_EQ(sweep.exit_code, 1) << sweep.err;
    EXPECT_TRUE(contains(sweep.out, "6 of 6 scenarios: 2 simulated, 2 known before, 2 refused")) << sweep.out;
    EXPECT_TRUE(contains(sweep.out, "sections: 2 good, 1 refused"));
    EXPECT_EQ(sweep.err.find("feature 1 (B)"), sweep.err.rfind("feature 1 (B)")) << "told once";
    EXPECT_TRUE(contains(text_of(work("bad.csv")), "has no elevations"));
    EXPECT_EQ(SQLite::Database(work("s.db")).execAndGet("SELECT count(*) FROM refused_section").getInt(), 1);
}

// ---- names

TEST_F(ProgramLines, ASingleLineGivesItsNameToTheRun) {
    write_layer("one.geojson", {feature("A-A", 0)});
    write_layer("two.geojson", {feature("A-A", 0), feature("B-B", 1)});
    const auto name_of = [this](Arguments arguments) {
        for (const char* word : {"--json", "--no-store", "--quiet"}) arguments.emplace_back(word);
        return Json::parse(runout(with_source(arguments)).out)["name"];
    };
    EXPECT_EQ(name_of({"run", "one.geojson"}), "one-A-A");
    EXPECT_EQ(name_of({"run", "two.geojson", "--where", "name = 'B-B'"}), "two-B-B");
    EXPECT_EQ(name_of({"run", "one.geojson", "--name", "mine"}), "mine");
}

TEST_F(ProgramLines, AFileIsKnownByWhatItHolds) {
    write_layer("sections.json", {feature("A", 0)});
    EXPECT_EQ(runout({"profile", "sections.json"}).exit_code, 0);
    write_layer("sections", {feature("A", 0)});
    EXPECT_EQ(runout({"profile", "sections"}).exit_code, 0);
    write("picture.png", "\x89PNG\r\n\x1a\n");
    expect_refused({"profile", "picture.png"}, {"picture.png: is neither a case nor a section"});
}

// ---- a table on the map

TEST_F(ProgramLines, ATableIsPutOnTheMap) {
    for (const Arguments& direction :
         {Arguments{"--bearing", "90"}, Arguments{"--towards", "834100,815900"}}) {
        fs::remove(work("t.db"));
        Arguments arguments = {"run",       "section.csv", "--origin", "834000,815900", "--crs",
                               "EPSG:2326", "--db",        "t.db",     "--quiet"};
        arguments.insert(arguments.end(), direction.begin(), direction.end());
        const Outcome run = runout(with_source(arguments));
        ASSERT_EQ(run.exit_code, 0) << run.err;
        SQLite::Database database(work("t.db"));
        EXPECT_NEAR(database.execAndGet("SELECT max(x) FROM map_line_point").getDouble(), 834002.5, 1e-6);
        EXPECT_NEAR(database.execAndGet("SELECT max(y) FROM map_line_point").getDouble(), 815900, 1e-6);
        const Outcome map = runout({"map", "t.db", "-o", "t.gpkg", "--overwrite"});
        EXPECT_EQ(map.exit_code, 0) << map.err;
        EXPECT_TRUE(contains(map.out, "runout_extent"));
    }
}

TEST_F(ProgramLines, APlacedTableHasTrueMetresAndItsOwnChainages) {
    const double north = 1 / std::cos(47 * std::acos(-1.0) / 180);  // Mercator at 47 deg north, about
    const Outcome run = runout(
        with_source({"run", "section.csv", "--origin", "890555.93,5942074.07", "--bearing", "180", "--crs",
                     "EPSG:3857", "--set", "section.origin_chainage_m=1", "--db", "t.db", "--quiet"}));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    SQLite::Database database(work("t.db"));
    const double first = database.execAndGet("SELECT y FROM map_line_point WHERE chainage_m = 0").getDouble();
    const double last =
        database.execAndGet("SELECT y FROM map_line_point WHERE chainage_m = 2.5").getDouble();
    EXPECT_NEAR((first - last) / 2.5, north, 0.01);
    EXPECT_NEAR(first - 5942074.07, north, 0.01) << "a metre before the origin";
}

TEST_F(ProgramLines, APlacingSaysWhatIsMissing) {
    expect_refused({"profile", "section.csv", "--origin", "834000,815900"},
                   {"section.origin", "needs section.crs"});
    expect_refused({"profile", "section.csv", "--origin", "834000,815900", "--crs", "EPSG:2326"},
                   {"does not say which way the section goes; give section.bearing_deg"});
    expect_refused({"profile", "section.csv", "--origin", "834000", "--crs", "EPSG:2326", "--bearing", "9"},
                   {"is not a pair of numbers"});
    expect_refused(
        {"profile", "section.csv", "--origin", "834000,815900", "--crs", "EPSG:99999999", "--bearing", "9"},
        {"section.crs = EPSG:99999999: is not a known coordinate system"});
    expect_refused(
        {"profile", "section.csv", "--origin", "834000,815900", "--crs", "EPSG:4326", "--bearing", "9"},
        {"is not in degrees"});
    expect_refused({"profile", "section.csv", "--bearing", "9"}, {"needs section.origin"});
}

TEST_F(ProgramLines, TheNetworkIsOffUnlessItIsAllowed) {
    expect_refused({"profile", "--raster", "/vsicurl/http://127.0.0.1:9/z.tif", "l.geojson"}, {"l.geojson"});
    write_layer("l.geojson", {feature("A", 0)});
    expect_refused({"profile", "l.geojson", "--raster", "/vsicurl/http://127.0.0.1:9/z.tif"},
                   {"is not a file on this machine", "--allow-network"});
    const Outcome allowed =
        runout({"profile", "l.geojson", "--raster", "/vsicurl/http://127.0.0.1:9/z.tif", "--allow-network"});
    EXPECT_EQ(allowed.exit_code, 2);
    EXPECT_TRUE(contains(allowed.err, "cannot be opened")) << "it has tried";
}

}  // namespace
}  // namespace runout
