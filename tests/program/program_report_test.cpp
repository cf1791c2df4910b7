// What is made of stored runs: reports, comparisons, exports, maps.

#include "program_fixture.h"
#include "store/store.h"

namespace runout {
namespace {

// --- reports

TEST_F(ProgramTest, ReportsComparesAndExportsAStoredRun) {
    ASSERT_EQ(runout({"run", "case.toml", "--quiet", "--frames", "10"}).exit_code, 0);
    const Outcome report = runout({"report", "runout.db", "-o", "page.html"});
    EXPECT_EQ(report.exit_code, 0) << report.err;
    EXPECT_EQ(report.out, "");
    const std::string page = text_of(work() / "page.html");
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
    EXPECT_TRUE(contains(page, "\"animation\":{"));

    const Outcome compare = runout({"compare", "runout.db", "--width", "2"});
    EXPECT_EQ(compare.exit_code, 0) << compare.err;
    EXPECT_TRUE(contains(compare.out, "Hunter & Fell"));
    EXPECT_TRUE(contains(compare.out, "over a width of 2 m"));

    const Outcome files = runout({"export", "runout.db", "--vtk", "made/points", "--csv", "tables"});
    EXPECT_EQ(files.exit_code, 0) << files.err;
    EXPECT_TRUE(fs::exists(work() / "made/points/particles.pvd"));
    EXPECT_TRUE(fs::exists(work() / "made/points/particles_0000.vtp"));
    EXPECT_TRUE(fs::exists(work() / "tables/series.csv"));

    EXPECT_EQ(runout({"report", "runout.db", "--section", "1", "-o", "section.html"}).exit_code, 0);
}

TEST_F(ProgramTest, ADoubtfulToeIsToldInEveryAnswer) {
    write("two.csv", "chainage_m,elevation_m\n0,60\n20,60\n29,45\n60,44\n68,30\n160,30\n");
    const std::string doubt = "section.toe_chainage_m = 68, section.crest_chainage_m = 60";
    Arguments run = {"run", "two.csv",     "--friction-angle", "35",       "--resolution",
                     "10",  "--no-pilots", "--quiet",          "--frames", "0"};
    const Outcome text = runout(run);
    EXPECT_TRUE(contains(text.out, "Toe at chainage 29 m, elevation 45 m, found; crest at 20 m, found"));
    EXPECT_TRUE(contains(text.out, "WARNING: The cut was taken")) << text.out;
    EXPECT_TRUE(contains(text.out, doubt));
    run.insert(run.end(), {"--json", "--no-store"});
    const Outcome json = runout(run);
    EXPECT_TRUE(contains(json.out, "\"toe_chainage_m\": 29.0")) << json.out;
    EXPECT_TRUE(contains(json.out, "\"toe_origin\": \"found\""));
    EXPECT_TRUE(contains(json.out, doubt));
    EXPECT_TRUE(contains(runout({"profile", "two.csv"}).out, doubt));
    ASSERT_EQ(runout({"report", "runout.db", "-o", "page.html"}).exit_code, 0);
    EXPECT_TRUE(contains(text_of(work("page.html")), doubt));
    EXPECT_EQ(Store(work("runout.db").string(), Store::Mode::read).run(1).crest_chainage_m, 20);
}

TEST_F(ProgramTest, RefusesReportsItCannotMake) {
    expect_refused({"report", "none.db"}, {"none.db", "no such file"});
    ASSERT_EQ(runout({"run", "case.toml", "--quiet", "--frames", "0"}).exit_code, 0);
    expect_refused({"report", "runout.db", "--run", "7"}, {"7", "no such run"});
    expect_refused({"report", "runout.db", "--section", "7"}, {"7", "section"});
    expect_refused({"report", "runout.db", "--study", "none"}, {"--study = none", "it holds no study"});
    expect_refused({"report", "runout.db", "--run", "1", "--study", "none"}, {"--study"});
    expect_refused({"report", "runout.db", "--run", "1", "--section", "1"}, {"--section"});
    expect_refused({"report", "runout.db", "-o", "absent/page.html"}, {"absent", "does not exist"});
    expect_refused({"report", "runout.db", "-o", "."}, {"is a directory"});
    expect_refused({"compare", "runout.db", "--width", "-3"}, {"--width"});
    expect_refused({"export", "runout.db"}, {"--vtk", "--csv"});
    expect_refused({"export", "runout.db", "--vtk", "points"}, {"no particles stored"});
    expect_refused({"back-analysis", "absent"}, {"absent", "is not a folder"});
    EXPECT_FALSE(fs::exists(work() / "report.html"));
    EXPECT_FALSE(fs::exists(work() / "points"));
    EXPECT_FALSE(fs::exists(work() / "back-analysis.db"));
}

TEST_F(ProgramTest, AnEmptyDatabaseHasNothingToReport) {
    { const Store store((work() / "empty.db").string(), Store::Mode::write); }
    expect_refused({"report", "empty.db"}, {"empty.db", "holds no runs"});
    expect_refused({"compare", "empty.db"}, {"empty.db", "holds no runs"});
    expect_refused({"export", "empty.db", "--csv", "x"}, {"empty.db", "holds no runs"});
}

TEST_F(ProgramTest, ARunThatFailedIsReportedAsSuchAndNotCompared) {
    ASSERT_EQ(runout({"run", "case.toml", "--quiet", "--time-limit", "0.05"}).exit_code, 1);
    EXPECT_EQ(runout({"report", "runout.db", "-o", "page.html"}).exit_code, 0);
    EXPECT_TRUE(contains(text_of(work() / "page.html"), "Last state, not a result"));
    expect_refused({"compare", "runout.db"}, {"cannot be compared", "time_limit"});
}

// --- from map to map

const std::string terrain = RUNOUT_SOURCE_DIR "/cases/terrain/case.toml";

TEST_F(ProgramTest, ShowsTheSectionsOfALayer) {
    const Outcome all = runout({"profile", terrain});
    EXPECT_EQ(all.exit_code, 0) << all.err;
    EXPECT_EQ(std::ranges::count(all.out, '\n'), 12) << "a title of two lines and ten sections\n" << all.out;
    EXPECT_TRUE(contains(all.out, "terrain-J-J"));

    const Outcome one = runout({"profile", terrain, "--where", "name = 'C-C'", "--svg", "c.svg"});
    EXPECT_EQ(one.exit_code, 0) << one.err;
    for (const char* part :
         {"terrain.tif along", "layer sections, feature 3", "toe ", "crest ", "face ", "T toe", "# source"})
        EXPECT_TRUE(contains(one.out, part)) << part;
    EXPECT_TRUE(text_of(work("c.svg")).starts_with("<svg")) << text_of(work("c.svg")).substr(0, 60);
}

TEST_F(ProgramTest, ASectionWithoutASourceIsShownAllTheSame) {
    write("flat.csv", "chainage_m,elevation_m\n0,1\n10,1\n20,0.9\n");
    const Outcome ground = runout({"profile", "flat.csv"});
    EXPECT_EQ(ground.exit_code, 0);
    EXPECT_TRUE(contains(ground.err, "no source is shown: ")) << ground.err;
    expect_refused({"profile", "flat.csv", "--source", "C"}, {});
}

TEST_F(ProgramTest, SectionsOfAMapAreRunAndDrawn) {
    const Outcome run = runout({"run", terrain, "--where", "id in (4, 5)", "--resolution", "8", "--db",
                                "t.db", "--threads", "1", "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_TRUE(contains(run.out, "terrain-D-D: the front stops"));
    EXPECT_TRUE(contains(run.out, "terrain-E-E: the front stops"));
    const Json rows = Json::parse(runout({"table", "t.db", "--format", "json"}).out);
    EXPECT_EQ(rows.at(0).at("section_attributes").at("slope_no"), "11SW-D/C101");

    const Outcome map = runout({"map", "t.db", "-o", "t.gpkg"});
    EXPECT_EQ(map.exit_code, 0) << map.err;
    for (const char* layer :
         {"hazard_band ", "section ", "deposit ", "thickness ", "source ", "runout_extent "})
        EXPECT_TRUE(contains(map.out, layer)) << layer << map.out;
    EXPECT_TRUE(fs::exists(work("t.gpkg")));
    EXPECT_EQ(runout({"map", "t.db", "-o", "t.gpkg"}).exit_code, 0) << "an unedited map of ours";
    EXPECT_EQ(runout({"map", "t.db", "-o", "t.geojson"}).exit_code, 0);
    const Json features = Json::parse(text_of(work("t.geojson"))).at("features");
    EXPECT_GT(features.size(), 10u);
    EXPECT_TRUE(features.at(0).at("properties").contains("layer"));
}

TEST_F(ProgramTest, BadMaps) {
    expect_refused({"map", "none.db", "-o", "t.gpkg"}, {"none.db"});
    expect_refused({"map", "none.db"}, {"--output"});
    expect_refused({"run", terrain, "--where", "id = 99"},
                   {"section.where = id = 99", "holds for no feature"});
    expect_refused({"run", terrain, "--set", "section.layer=roads"},
                   {"section.layer = roads", "name one of sections"});
}

}  // namespace
}  // namespace runout
