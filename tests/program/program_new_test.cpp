// runout new, as a shell sees it.

#include "drawn_files.h"
#include "program_fixture.h"

namespace runout {
namespace {

const Polyline drawn_slope{{0, 40}, {30, 40}, {45, 10}, {250, 10}};

class NewCommand : public ProgramTest {};

TEST_F(NewCommand, WritesACaseThatRuns) {
    write("s.dxf", DxfText().polyline("ground", drawn_slope).polyline("slip", {{28, 40}, {45, 10}}).whole());
    write("s.xml", landxml_text(metric_units, cross_section("20", surface_text("EG", {drawn_slope}))));
    fs::create_directories(work("cases"));
    for (const std::string name : {"section.csv", "s.dxf", "s.xml"}) {
        const std::string file = "cases/" + name + ".toml";
        const Outcome made = runout({"new", name, "-o", file});
        EXPECT_EQ(made.exit_code, 0) << made.err;
        EXPECT_TRUE(contains(made.out, "next: runout run " + file));
        EXPECT_TRUE(contains(made.err, "friction_angle_deg = 38 is an example"));
        EXPECT_TRUE(contains(text_of(work(file)), "file = \"../" + name + "\""));
        EXPECT_EQ(runout({"source", file}).exit_code, 0);
        const Outcome run = runout({"run", file, "--resolution", "6", "--db", "runs.db"});
        EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
    }
}

TEST_F(NewCommand, PrintsTheCaseWhereNoFileIsNamed) {
    const Outcome printed = runout({"new", "section.csv", "--friction-angle", "30"});
    EXPECT_EQ(printed.exit_code, 0);
    EXPECT_TRUE(contains(printed.out, "file = \"section.csv\""));
    EXPECT_TRUE(contains(printed.out, "friction_angle_deg = 30"));
    EXPECT_EQ(printed.err, "");
}

TEST_F(NewCommand, OverwritesNothing) {
    const std::string before = text_of(work("case.toml"));
    expect_refused({"new", "section.csv", "-o", "case.toml"}, {"case.toml", "exists already"});
    EXPECT_EQ(text_of(work("case.toml")), before);
    expect_refused({"new", "case.toml", "-o", "other.toml"}, {"is a case already"});
    expect_refused({"new", "none.dxf", "-o", "other.toml"}, {"none.dxf", "cannot be opened"});
    write("flat.csv", "chainage_m,elevation_m\n0,1\n9,1\n");
    expect_refused({"new", "flat.csv", "-o", "other.toml"}, {"no face", "give toe and crest"});
}

TEST_F(NewCommand, LayersAndUnitsAreOptions) {
    write("s.dxf", DxfText()
                       .variable("$INSUNITS", 4)
                       .polyline("EG", drawn_slope)
                       .line("road", {60, 10}, {70, 10})
                       .whole());
    expect_refused({"profile", "s.dxf"}, {"--layer ground=NAME", "EG (1 line), road (1 line)"});
    expect_refused({"profile", "s.dxf", "--layer", "EG"}, {"$INSUNITS says millimetres", "--unit m"});
    const Outcome made = runout({"new", "s.dxf", "--layer", "ground=EG", "--unit", "m"});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    EXPECT_TRUE(contains(made.out, "dxf_layers = \"ground=EG\""));
    EXPECT_TRUE(contains(made.out, "unit = \"m\""));
}

}  // namespace
}  // namespace runout
