// What a careless user does to files, and what others may have left where an output goes. No input is lost,
// nothing is written where it was not asked for.

#include <SQLiteCpp/SQLiteCpp.h>
#include <sys/stat.h>

#include <thread>

#include "program_fixture.h"

namespace runout {
namespace {

const Arguments run_it = {"run", "case.toml", "--db", "v.db", "--no-pilots", "--quiet"};

class OutputsTest : public ProgramTest {
  protected:
    OutputsTest() { EXPECT_EQ(runout(run_it).exit_code, 0); }

    /// Refused, and the file keeps its bytes.
    void expect_spared(const std::string& file, const Arguments& arguments,
                       const std::vector<std::string>& parts = {}) const {
        const std::string before = text_of(work(file));
        ASSERT_FALSE(before.empty());
        Arguments insisting = arguments;
        expect_refused(arguments, parts);
        EXPECT_EQ(text_of(work(file)), before);
        if (arguments.front() == "run") return;
        insisting.push_back("--overwrite");
        expect_refused(insisting, parts);
        EXPECT_EQ(text_of(work(file)), before);
    }
};

TEST_F(OutputsTest, NoOutputReplacesAnInputWhateverIsSaid) {
    fs::create_hard_link(work("v.db"), work("hard.html"));
    fs::create_symlink("v.db", work("soft.html"));
    fs::create_directory(work("d"));
    for (const std::string name : {"v.db", "d/../v.db", "hard.html", "soft.html"})
        expect_spared("v.db", {"report", "v.db", "-o", name}, {"reads or writes itself"});
    expect_spared("v.db", {"compare", "v.db", "-o", "v.db"}, {"reads or writes itself"});
    expect_spared("v.db", {"accuracy", "--survey", "v.db", "--db", "v.db"}, {"reads or writes itself"});
    expect_spared("section.csv", {"profile", "section.csv", "--svg", "section.csv"},
                  {"reads or writes itself"});
    expect_spared("section.csv", {"profile", "case.toml", "--svg", "section.csv"},
                  {"reads or writes itself"});
    expect_spared("case.toml", {"profile", "case.toml", "--svg", "case.toml"}, {"reads or writes itself"});
    expect_spared("section.csv", {"accuracy", "case.toml", "--chart", "section.csv"},
                  {"reads or writes itself"});
    expect_spared("v.db", {"accuracy", "case.toml", "--db", "v.db", "--chart", "v.db"},
                  {"reads or writes itself"});
    fs::copy_file(work("v.db"), work("v.gpkg"));
    expect_spared("v.gpkg", {"map", "v.gpkg", "-o", "v.gpkg"}, {"reads or writes itself"});
    expect_spared("section.csv", {"run", "case.toml", "--db", "section.csv", "--quiet"},
                  {"is not a database"});
}

TEST_F(OutputsTest, AReportIsNoJournalOfTheDatabase) {
    for (const char* name : {"v.db-journal", "v.db-wal", "v.db-shm"})
        expect_refused({"report", "v.db", "-o", name, "--overwrite"}, {"reads or writes itself"});
}

TEST_F(OutputsTest, TwoOutputsOfOneCallAreTwoFiles) {
    expect_refused({"accuracy", "case.toml", "--chart", "x.svg", "--survey", "./x.svg"},
                   {"--survey", "x.svg"});
    expect_refused({"accuracy", "case.toml", "--db", "new.db", "--chart", "new.db"}, {"--chart", "new.db"});
}

TEST_F(OutputsTest, WhatAPersonWroteIsReplacedOnlyWhenAskedTo) {
    write("mine.html", "<p>weeks of work</p>\n");
    expect_refused({"report", "v.db", "-o", "mine.html"}, {"mine.html", "exists", "--overwrite"});
    EXPECT_EQ(text_of(work("mine.html")), "<p>weeks of work</p>\n");
    EXPECT_EQ(runout({"report", "v.db", "-o", "mine.html", "--overwrite"}).exit_code, 0);
    EXPECT_TRUE(contains(text_of(work("mine.html")), "</html>"));
}

TEST_F(OutputsTest, AnEarlierOutputIsReplacedUnaskedUntilItWasEdited) {
    const std::vector<std::pair<std::string, Arguments>> outputs = {
        {"r.html", {"report", "v.db", "-o", "r.html"}},
        {"c.html", {"compare", "v.db", "-o", "c.html"}},
        {"p.svg", {"profile", "case.toml", "--svg", "p.svg"}}};
    for (const auto& [file, arguments] : outputs) {
        for (int time = 0; time < 2; ++time) EXPECT_EQ(runout(arguments).exit_code, 0) << file;
        std::string edited = text_of(work(file));
        edited[edited.size() / 2] = edited[edited.size() / 2] == 'x' ? 'y' : 'x';
        write(file, edited);
        expect_refused(arguments, {"exists", "--overwrite"});
        EXPECT_EQ(text_of(work(file)), edited);
        write(file, edited + "\n<!-- checked by a colleague -->\n");
        expect_refused(arguments, {"exists"});
    }
}

TEST_F(OutputsTest, ExportedTablesHaveNoPlaceForAMarkAndParticlesDo) {
    const Arguments tables = {"export", "v.db", "--csv", "out"},
                    particles = {"export", "v.db", "--vtk", "out"};
    EXPECT_EQ(runout(tables).exit_code, 0);
    expect_refused(tables, {"series.csv", "exists", "--overwrite"});
    EXPECT_EQ(runout({"export", "v.db", "--csv", "out", "--overwrite"}).exit_code, 0);
    EXPECT_EQ(runout(particles).exit_code, 0);
    EXPECT_EQ(runout(particles).exit_code, 0);
    EXPECT_TRUE(text_of(work("out/particles.pvd")).ends_with(" -->\n"));
}

TEST_F(OutputsTest, OfManyFilesNoneIsWrittenWhenOneMayNotBe) {
    fs::create_directory(work("out"));
    write("out/deposit.csv", "mine\n");
    expect_refused({"export", "v.db", "--csv", "out", "--vtk", "points"}, {"deposit.csv", "exists"});
    EXPECT_EQ(text_of(work("out/deposit.csv")), "mine\n");
}

TEST_F(OutputsTest, APipeIsWrittenToAndStaysAPipe) {
    const std::string pipe = work("pipe").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::string received;
    std::thread reader([&] { received = text_of(pipe); });
    const Outcome outcome = runout({"report", "v.db", "-o", "pipe"});
    reader.join();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(received.starts_with("<!DOCTYPE html>"));
    EXPECT_TRUE(contains(received, "</html>"));
    EXPECT_EQ(fs::status(pipe).type(), fs::file_type::fifo);
}

TEST_F(OutputsTest, StandardOutputTakesAPageAfterWhatWasPrinted) {
    const Outcome page = runout({"report", "v.db", "-o", "/dev/stdout"});
    EXPECT_EQ(page.exit_code, 0) << page.err;
    EXPECT_TRUE(page.out.starts_with("<!DOCTYPE html>")) << page.out.substr(0, 100);
    const Outcome both = runout({"compare", "v.db", "-o", "/dev/stdout"});
    EXPECT_EQ(both.exit_code, 0) << both.err;
    EXPECT_GT(both.out.find("<!DOCTYPE html>"), 10u) << "the text comes first, whole";
    EXPECT_TRUE(contains(both.out, "</html>"));
}

TEST_F(OutputsTest, AnAnswerThatDoesNotGetOutIsAFailure) {
    const Outcome full = runout({"report", "v.db", "-o", "/dev/full"});
    EXPECT_EQ(full.exit_code, 2);
    EXPECT_TRUE(contains(full.err, "/dev/full: cannot be written (No space left on device)")) << full.err;
    const std::string command =
        fmt::format("cd '{}' && '{}' table v.db > /dev/full 2> message", work().string(), RUNOUT_PROGRAM);
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 2);
    EXPECT_TRUE(contains(text_of(work("message")), "standard output cannot be written"));
}

TEST_F(OutputsTest, AClosedStreamIsNoDoorToTheDatabase) {
    const std::string before = text_of(work("v.db"));
    for (const char* closed : {">&-", "2>&-", "<&- >&- 2>&-"}) {
        const std::string command =
            fmt::format("cd '{}' && '{}' table v.db {} && '{}' profile case.toml --svg s.svg {}",
                        work().string(), RUNOUT_PROGRAM, closed, RUNOUT_PROGRAM, closed);
        EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 0) << closed;
        EXPECT_EQ(text_of(work("v.db")), before);
        EXPECT_TRUE(text_of(work("s.svg")).starts_with("<"));
    }
}

TEST_F(OutputsTest, ALinkIsFollowedAndStays) {
    fs::create_directory(work("www"));
    EXPECT_EQ(runout({"report", "v.db", "-o", "www/r.html"}).exit_code, 0);
    fs::create_symlink("www/r.html", work("latest.html"));
    EXPECT_EQ(runout({"report", "v.db", "-o", "latest.html"}).exit_code, 0);
    EXPECT_TRUE(fs::is_symlink(work("latest.html")));
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(work("www/r.html"))));
    fs::create_symlink("nowhere/x.html", work("dangling.html"));
    expect_refused({"report", "v.db", "-o", "dangling.html"}, {"is a link to a file that does not exist"});
    fs::create_symlink("circle.html", work("circle.html"));
    const Outcome circle = runout({"report", "v.db", "-o", "circle.html"});
    EXPECT_EQ(circle.exit_code, 2);
    EXPECT_TRUE(contains(circle.err, "circle.html: is a link to a file")) << circle.err;
}

TEST_F(OutputsTest, ALinkToAStrangersFileIsNotFollowedUnasked) {
    write("precious.txt", "keep me\n");
    fs::create_symlink("precious.txt", work("report.html"));
    expect_refused({"report", "v.db"}, {"report.html", "exists"});
    EXPECT_EQ(text_of(work("precious.txt")), "keep me\n");
}

TEST_F(OutputsTest, PlantedTemporaryNamesAreNeitherFollowedNorRemoved) {
    write("precious.txt", "keep me\n");
    for (const char* name : {"r.html.part", "r.part", "r.partial.html"})
        fs::create_symlink("precious.txt", work(name));
    EXPECT_EQ(runout({"report", "v.db", "-o", "r.html"}).exit_code, 0);
    EXPECT_EQ(text_of(work("precious.txt")), "keep me\n");
    for (const char* name : {"r.html.part", "r.part", "r.partial.html"})
        EXPECT_TRUE(fs::is_symlink(work(name)));
    for (const std::string& file : files())
        EXPECT_FALSE(contains(file, ".runout-")) << "left behind: " << file;
}

TEST_F(OutputsTest, AFileThatWasMadeReadOnlyIsLeftAlone) {
    EXPECT_EQ(runout({"report", "v.db", "-o", "r.html"}).exit_code, 0);
    fs::permissions(work("r.html"), fs::perms::owner_read);
    expect_refused({"report", "v.db", "-o", "r.html", "--overwrite"}, {"is read-only"});
}

TEST_F(OutputsTest, AReplacedFileKeepsItsPermissions) {
    EXPECT_EQ(runout({"report", "v.db", "-o", "r.html"}).exit_code, 0);
    const auto private_file = fs::perms::owner_read | fs::perms::owner_write;
    fs::permissions(work("r.html"), private_file);
    EXPECT_EQ(runout({"report", "v.db", "-o", "r.html"}).exit_code, 0);
    EXPECT_EQ(fs::status(work("r.html")).permissions(), private_file);
}

TEST_F(OutputsTest, OtherNamesThatAreNoFiles) {
    expect_refused({"report", "v.db", "-o", ""}, {"is empty"});
    expect_refused({"report", "v.db", "-o", "."}, {"is a directory"});
    expect_refused({"report", "v.db", "-o", "no/where/r.html"}, {"lies in a folder that does not exist"});
    expect_refused({"report", "v.db", "-o", "section.csv/r.html"}, {"lies in a folder that does not exist"});
    expect_refused({"report", "v.db", "-o", std::string(300, 'x') + ".html"}, {"cannot be written"});
}

TEST_F(OutputsTest, ADatabaseIsNeitherAPipeNorADevice) {
    ASSERT_EQ(mkfifo(work("pipe").c_str(), 0600), 0);
    for (const std::string name : {"pipe", "/dev/null", "/dev/stdout"}) {
        expect_refused({"run", "case.toml", "--db", name, "--quiet"}, {name, "is no"});
        expect_refused({"table", name}, {name, "is no"});
    }
}

// ---- names

TEST_F(OutputsTest, NamesDoNotLeadOutOfTheFolder) {
    write(
        "lines.geojson",
        R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:2326"}},"features":[)"
        R"({"type":"Feature","properties":{"name":"../../../evil"},"geometry":{"type":"LineString","coordinates":)"
        R"([[834000,816000,32],[834030,816000,32],[834041.5,816000,12],[834200,816000,12]]}},)"
        R"({"type":"Feature","properties":{"name":"a/b"},"geometry":{"type":"LineString","coordinates":)"
        R"([[834000,816100,32],[834030,816100,32],[834041.5,816100,12],[834200,816100,12]]}},)"
        R"({"type":"Feature","properties":{"name":"a:b"},"geometry":{"type":"LineString","coordinates":)"
        R"([[834000,816200,32],[834030,816200,32],[834041.5,816200,12],[834200,816200,12]]}}]})");
    fs::create_directories(work("deep/er"));
    const auto before = files();
    const Outcome outcome = runout({"profile", "lines.geojson", "--svg", "deep/er/s.svg"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    std::set<std::string> made;
    for (const std::string& file : files())
        if (!before.contains(file)) made.insert(file);
    EXPECT_EQ(made.size(), 3u) << "two names with one spelling are two files";
    for (const std::string& file : made) EXPECT_TRUE(file.starts_with("deep/er/s-")) << file;
}

TEST_F(OutputsTest, ANameForgesNoRowAndMovesNoCursor) {
    const std::string name =
        "a\nrun 99 settled\x1b[2J\xc2\x9b"
        "1m\xe2\x80\xae"
        "=1+1";
    const Outcome told = runout({"run", "case.toml", "--name", name, "--db", "n.db", "--no-pilots"});
    EXPECT_EQ(told.exit_code, 0) << told.err;
    const std::string shown = "a\\x0arun 99 settled\\x1b[2J\\xc2\\x9b1m\\xe2\\x80\\xae=1+1";
    EXPECT_TRUE(contains(told.out, shown)) << told.out;
    for (const Arguments& arguments :
         {Arguments{"table", "n.db"}, Arguments{"table", "n.db", "--format", "csv"},
          Arguments{"compare", "n.db"}, Arguments{"table", "n.db", "--format", "json"}}) {
        const Outcome outcome = runout(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        for (const char* raw : {"\x1b", "\xc2\x9b", "\xe2\x80\xae", "\nrun 99"})
            EXPECT_FALSE(contains(outcome.out + outcome.err, raw)) << outcome.out;
    }
    EXPECT_EQ(Json::parse(runout({"table", "n.db", "--format", "json"}).out)[0]["name"], name)
        << "JSON keeps the name";
    expect_refused({"table", "n.db", "--study", "\x1b[2J\nx"}, {"\\x1b[2J\\x0ax"});
    expect_refused({"\x1b[31mtable"}, {"\\x1b[31mtable"});
    expect_refused({"table", "n.db", "--\x1b[31m"}, {"\\x1b[31m"});
}

TEST_F(OutputsTest, ASpreadsheetComputesNoName) {
    EXPECT_EQ(
        runout({"run", "case.toml", "--name", "=cmd|'/C calc'!A0", "--db", "n.db", "--no-pilots", "--quiet"})
            .exit_code,
        0);
    EXPECT_TRUE(contains(runout({"table", "n.db", "--format", "csv"}).out, "\"'=cmd|'/C calc'!A0\""));
}

TEST_F(ProgramTest, DistributionsWithNothingBetweenTheirEndsAreWrongInput) {
    for (const char* spread :
         {R"({ distribution = "normal", mean = 35, deviation = 2, low = 1000, high = 1001 })",
          R"({ distribution = "normal", mean = 35, deviation = 2, high = -1000 })",
          R"({ distribution = "normal", mean = 35, deviation = 1e-320 })",
          R"({ distribution = "lognormal", mean = 35, deviation = 2, low = -2, high = -1 })",
          R"({ distribution = "lognormal", mean = 1e-300, deviation = 1e300 })"}) {
        write("study.toml", fmt::format("[study]\ncase = \"case.toml\"\nsamples = 5\n[vary]\n"
                                        "material.friction_angle_deg = {}\n",
                                        spread));
        expect_refused({"sweep", "study.toml"}, {"study.toml, line 5: material.friction_angle_deg"});
    }
}

}  // namespace
}  // namespace runout
