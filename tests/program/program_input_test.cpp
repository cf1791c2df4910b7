// Bad input of every kind: one sentence, exit code 2, nothing written.

#include <chrono>

#include "program_fixture.h"

namespace runout {
namespace {

TEST_F(ProgramTest, BadFiles) {
    expect_refused({"run", "none.toml"}, {"none.toml", "does not exist"});
    expect_refused({"run", "none.csv", "--friction-angle", "38"}, {"none.csv"});
    write("empty.toml", "");
    expect_refused({"run", "empty.toml"}, {"empty.toml", "is empty"});
    write("empty.csv", "");
    expect_refused({"run", "empty.csv", "--friction-angle", "38"}, {"empty.csv"});
    write("broken.toml", "[section\n");
    expect_refused({"run", "broken.toml"}, {"broken.toml, line 1", "TOML"});
    expect_refused({"run", "."}, {"folder"});
}

TEST_F(ProgramTest, BadSections) {
    const auto refused = [&](const std::string& text, const std::vector<std::string>& parts) {
        write("bad.csv", text);
        expect_refused({"run", "bad.csv", "--friction-angle", "38"}, parts);
        expect_refused({"source", "bad.csv"}, parts);
    };
    const std::string header = "chainage_m,elevation_m\n";
    refused(header + "0,1\n", {"bad.csv", "one point"});
    refused(header + "0,1\n1,high\n", {"bad.csv, line 3", "elevation_m", "high"});
    refused(header + "0,1\nnan,0\n", {"bad.csv, line 3", "chainage_m", "nan"});
    refused("chainage_m,colour\n0,red\n1,red\n", {"bad.csv", "--columns"});
    refused("a,b\n0,1\n1,0\n", {"bad.csv, line 1", "'a', 'b'", "--columns"});
    refused(header + "0,1\n1,0\n0.5,-1\n", {"bad.csv, line 4", "chainage_m = 0.5", "overhang"});
    refused(header + "0,1\n1,0\n1,0\n2,0\n", {"bad.csv, line 4", "repeats"});
}

TEST_F(ProgramTest, BadKeys) {
    const std::string section = "[section]\nfile = \"section.csv\"\n[material]\n";
    const auto refused = [&](const std::string& text, const std::vector<std::string>& parts) {
        write("bad.toml", text);
        expect_refused({"run", "bad.toml"}, parts);
    };
    refused(section + "friction_angel_deg = 38\n",
            {"bad.toml, line 4", "friction_angel_deg = 38", "friction_angle_deg"});
    refused(section + "friction_angle_deg = 95\n", {"bad.toml, line 4", "= 95", "0 <= number < 80 deg"});
    refused(section + "friction_angle_deg = \"x\"\n", {"bad.toml, line 4", "not a number"});
    refused(section + "density_kg_m3 = 2000\n", {"bad.toml", "material.friction_angle_deg", "missing"});
    refused(section + "friction_angle_deg = 38\n[run]\nresolution = 40\nparticle_spacing_m = 0.01\n",
            {"bad.toml, line 7", "excludes run.resolution"});
    refused(section + "friction_angle_deg = 38\n[run]\nparticle_spacing_m = 10\n",
            {"bad.toml, line 6", "particles"});
    expect_refused({"run", "case.toml", "--friction-angle", "-1"},
                   {"--friction-angle", "= -1", "out of range"});
    expect_refused({"run", "case.toml", "--set", "run.speed=3"},
                   {"--set", "run.speed = 3", "not a known key"});
}

TEST_F(ProgramTest, BadSources) {
    const Arguments bare = {"run", "section.csv", "--friction-angle", "38"};
    const auto with = [&](Arguments more) {
        more.insert(more.begin(), bare.begin(), bare.end());
        return more;
    };
    expect_refused(with({"--height", "0.2", "--area", "0.5"}), {"source.area_m2", "height"});
    expect_refused(with({"--scarp-angle", "60"}),
                   {"--scarp-angle", "source.scarp_angle_deg = 60", "steeper than the face"});
    expect_refused(with({"--height", "3"}), {"--height", "source.height_m = 3"});
    expect_refused(with({"--drop-height", "2"}), {"--drop-height", "source.drop_height_m = 2"});
    expect_refused(with({"--length", "2"}), {"--length", "does not apply to source.type = B"});
    expect_refused(with({"--source", "polygon", "--set", "source.points=[[5,0.5],[6,0.5],[6,0.6],[5,0.6]]"}),
                   {"source.points"});
}

/// The database's version number stands in bytes 60 to 63 of the file, most significant first.
void write_user_version(const fs::path& database, char version) {
    std::fstream file(database, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(60);
    const char bytes[4] = {0, 0, 0, version};
    file.write(bytes, 4);
}

TEST_F(ProgramTest, BadDatabasesAreFoundBeforeTheWork) {
    // This resolution would keep the program busy for hours.
    const auto refused = [&](const std::string& database, const std::vector<std::string>& parts) {
        const auto start = std::chrono::steady_clock::now();
        expect_refused({"run", "case.toml", "--resolution", "1000", "--db", database}, parts);
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
    };
    refused("no/such/folder/runs.db", {"no/such/folder/runs.db"});
    fs::create_directories(work("folder.db"));
    refused("folder.db", {"folder.db"});
    refused("section.csv", {"section.csv"});
    EXPECT_EQ(text_of(work("section.csv")), slope);

    ASSERT_EQ(runout({"run", "case.toml", "--db", "newer.db"}).exit_code, 0);
    write_user_version(work("newer.db"), 99);
    refused("newer.db", {"newer.db", "99"});
}

TEST_F(ProgramTest, ADatabaseIsNotMadeForBadInput) {
    expect_refused({"run", "case.toml", "--base-angle", "75", "--db", "new.db"}, {"source.base_angle_deg"});
    EXPECT_FALSE(fs::exists(work("new.db")));
}

}  // namespace
}  // namespace runout
