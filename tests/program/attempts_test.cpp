// A list of attempts to break the program by its command line, its environment, a case or a study: numbered,
// so that a reader can count them. Those on databases and maps are in attempts_database_test.cpp, from 31 on.

#include <SQLiteCpp/SQLiteCpp.h>

#include "program_fixture.h"

namespace runout {
namespace {

const Arguments quick = {"run", "case.toml", "--no-pilots", "--quiet", "--frames", "0"};

Arguments with(Arguments arguments, const Arguments& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

class AttemptsTest : public ProgramTest {
  protected:
    /// The run-out that a run of case.toml tells, after what a shell does first.
    [[nodiscard]] double run_out(const std::string& before, const std::string& more = "") const {
        const Outcome outcome =
            runout_in_shell(before, "run case.toml --no-pilots --quiet --no-store --json " + more);
        EXPECT_EQ(outcome.exit_code, 0) << before << outcome.err;
        return outcome.exit_code == 0 ? Json::parse(outcome.out)["run_out_m"].get<double>() : -1.0;
    }
    /// The sound case with `before` in place of `after`.
    [[nodiscard]] static std::string changed(const std::string& before, const std::string& after) {
        std::string text = sound_case;
        return text.replace(text.find(before), before.size(), after);
    }
    void expect_case_refused(const std::string& text, const std::vector<std::string>& parts) const {
        write("bad.toml", text);
        expect_refused({"run", "bad.toml", "--no-store", "--quiet"}, parts);
    }
    void expect_study_refused(const std::string& text, const std::vector<std::string>& parts) const {
        write("study.toml", "[study]\ncase = \"case.toml\"\n" + text);
        expect_refused({"sweep", "study.toml", "--db", "s.db", "-j", "1", "--quiet"}, parts);
    }
};

// ---- the command line

TEST_F(AttemptsTest, A01NumbersThatOnlyAMachineReads) {
    for (const char* number :
         {"nan", "inf", "-inf", "1e400", "0x10", "1,5", "5 s", " 5", "5m", "+", "-1", "0"})
        expect_refused(with(quick, {"--budget", number}), {"--budget = ", "valid: 0 < number"});
    for (const char* number : {"nan", "0x10", "1e400", "1e-400", "0"})
        expect_refused({"compare", "v.db", "--width", number}, {"--width = "});
    expect_refused({"estimate", "v.db", "--slope-angle", "nan"}, {"--slope-angle = nan: is not a number"});
}

TEST_F(AttemptsTest, A02ARunIsFoundByItsNumberOrNot) {
    for (int k = 0; k < 8; ++k) ASSERT_EQ(runout(with(quick, {"--db", "v.db"})).exit_code, 0);
    const std::string eighth = runout({"compare", "v.db", "--run", "8"}).out;
    EXPECT_EQ(runout({"compare", "v.db", "--run", "010"}).exit_code, 2) << "eight in another system";
    EXPECT_TRUE(contains(eighth, "run 8, "));
    for (const char* number : {"0x8", "8.0", "8;9", "eight"})
        expect_refused({"compare", "v.db", "--run", number}, {"--run = ", "is not a whole number"});
    for (const char* number : {"9223372036854775808", "-99999999999999999999"})
        expect_refused({"compare", "v.db", "--run", number}, {number, "is out of range"});
}

TEST_F(AttemptsTest, A03CountsThatNoMachineHas) {
    expect_refused({"stress", "--seed", "-1"}, {"--seed = -1"});
    expect_refused({"stress", "--seed", "99999999999999999999"}, {"--seed", "is out of range"});
    for (const char* jobs : {"0", "-1", "100000", "2.5", "99999999999999999999"})
        expect_refused({"stress", "-j", jobs}, {"--jobs = ", "valid: 1 <= whole number <= 1024"});
    expect_refused(with(quick, {"--threads", "100000"}), {"--threads", "100000", "out of range"});
    expect_refused({"run", "case.toml", "--frames", "1e3"}, {"--frames = 1e3"});
}

TEST_F(AttemptsTest, A04AShortOptionWithAnEqualsSignNamesNoFile) {
    expect_refused({"report", "v.db", "-o=page.html"}, {"-o=page.html", "write -o page.html"});
    expect_refused({"new", "section.csv", "-o=-"}, {"write -o -"});
}

TEST_F(AttemptsTest, A05VariablesOfAShellThatAreNotSet) {
    for (const Arguments& arguments :
         {Arguments{"run", ""}, Arguments{"run", "case.toml", "--db", ""}, Arguments{"table", ""},
          Arguments{"profile", "case.toml", "--svg", ""}, Arguments{"new", "section.csv", "-o", ""},
          Arguments{"merge", "", "v.db"}, Arguments{"merge", "v.db", ""},
          Arguments{"export", "v.db", "--csv", ""}, Arguments{"delete", "v.db", "--study", "", "--yes"},
          Arguments{"sweep", ""}})
        expect_refused(arguments, {"is empty"});
}

TEST_F(AttemptsTest, A06OptionsThatContradict) {
    expect_refused(with(quick, {"--resolution", "10", "--resolution", "20"}), {"--resolution"});
    expect_refused(with(quick, {"--db", "a.db", "--db", "b.db"}), {"--db"});
    expect_refused(with(quick, {"--friction-angle", "38", "--set", "material.friction_angle_deg=37"}),
                   {"was given before by --friction-angle as 38"});
    expect_refused(with(quick, {"--set", "run.resolution=10", "--set", "run.resolution=11"}),
                   {"given before"});
}

TEST_F(AttemptsTest, A07NamesThatLookLikeOptions) {
    write("-case.toml", sound_case);
    write("--help", sound_case);
    EXPECT_EQ(runout({"run", "--no-pilots", "--quiet", "--db", "./-v.db", "--", "-case.toml"}).exit_code, 0);
    EXPECT_TRUE(contains(runout({"table", "--", "-v.db"}).out, "settled"));
    expect_refused({"run", "--no-store", "--", "--help"}, {"--help: ", "neither a case nor a section"});
}

TEST_F(AttemptsTest, A08FoldersWhereFilesAreDueAndFilesWithASlash) {
    fs::create_directory(work("folder"));
    for (const Arguments& arguments :
         {Arguments{"run", "folder"}, with(quick, {"--set", "section.file=folder"}),
          with(quick, {"--db", "folder"}), Arguments{"sweep", "folder"}, Arguments{"table", "folder"},
          Arguments{"merge", "m.db", "folder"}, Arguments{"run", "case.toml/"},
          with(quick, {"--db", "x.db/"}), Arguments{"profile", "section.csv/"},
          Arguments{"profile", "case.toml", "--svg", "s.svg/"}, Arguments{"back-analysis", "section.csv"},
          Arguments{"run", "case.toml/../case.toml"}})
        expect_refused(arguments, {});
    EXPECT_EQ(runout({"run", "folder/../case.toml", "--no-store", "--no-pilots", "--quiet"}).exit_code, 0);
}

TEST_F(AttemptsTest, A09ArgumentsAsLongAsABook) {
    const std::string book(100'000, 'x');
    for (const Arguments& arguments :
         {Arguments{"run", book}, with(quick, {"--set", book}),
          with(quick, {"--set", fmt::format("material.{}=1", book)}), with(quick, {"--db", book}),
          Arguments{"table", "v.db", "--study", book}, with(quick, {"--budget", book})})
        EXPECT_EQ(runout(arguments).exit_code, 2);
    EXPECT_EQ(files(), (std::set<std::string>{"case.toml", "section.csv"}));
}

TEST_F(AttemptsTest, A10ANewCaseOverTheOldOne) {
    const std::string before = text_of(work("case.toml"));
    fs::create_hard_link(work("case.toml"), work("twin.toml"));
    fs::create_symlink("case.toml", work("link.toml"));
    for (const char* name : {"case.toml", "./case.toml", "twin.toml", "link.toml", "section.csv"})
        expect_refused({"new", "section.csv", "-o", name}, {name, "exists already"});
    EXPECT_EQ(text_of(work("case.toml")), before);
}

// ---- the environment

TEST_F(AttemptsTest, A11ThreadsThatAreNotThere) {
    const double usual = run_out("");
    for (const char* setting : {"OMP_NUM_THREADS=0", "OMP_NUM_THREADS=-1", "OMP_NUM_THREADS=many",
                                "OMP_NUM_THREADS=100000", "OMP_STACKSIZE=1", "OMP_DYNAMIC=true",
                                "OMP_THREAD_LIMIT=1", "OMP_DISPLAY_ENV=true", "OMP_SCHEDULE=x"})
        EXPECT_EQ(run_out(fmt::format("export {};", setting)), usual) << setting;
}

TEST_F(AttemptsTest, A12PlacesAndTongues) {
    const double usual = run_out("");
    for (const char* setting :
         {"export LC_ALL=de_DE.UTF-8;", "export LC_NUMERIC=fr_FR.UTF-8;", "export LANG=xx_YY;",
          "export TZ=Mars/Phobos;", "export TZ=:/etc/passwd;", "unset HOME;", "export HOME=;",
          "export TMPDIR=/nowhere;", "export SQLITE_TMPDIR=/nowhere;", "unset PATH;"})
        EXPECT_EQ(run_out(setting), usual) << setting;
}

TEST_F(AttemptsTest, A13SettingsOfLibrariesThatLeadElsewhere) {
    write(
        "lines.geojson",
        R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:2326"}},"features":[)"
        R"({"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":)"
        R"([[834000,816000,32],[834030,816000,32],[834041.5,816000,12],[834200,816000,12]]}}]})");
    const Outcome usual = runout({"profile", "lines.geojson"});
    ASSERT_EQ(usual.exit_code, 0) << usual.err;
    for (const char* setting :
         {"GDAL_DRIVER_PATH=.", "GDAL_SKIP=GeoJSON", "OGR_SKIP=GeoJSON", "GDAL_DATA=/nowhere",
          "PROJ_NETWORK=ON", "GDAL_CONFIG_FILE=section.csv", "OGR_SQLITE_LOAD_EXTENSIONS=evil.so",
          "GDAL_CACHEMAX=1", "OSR_DEFAULT_AXIS_MAPPING_STRATEGY=AUTHORITY_COMPLIANT", "CPL_DEBUG=OFF",
          "GDAL_PAM_PROXY_DIR=pam"})
        EXPECT_EQ(runout_in_shell(fmt::format("export {};", setting), "profile lines.geojson").out, usual.out)
            << setting;
    for (const char* key : {"PROJ_DATA", "PROJ_LIB"}) {
        const Outcome lost =
            runout_in_shell(fmt::format("export {}=/nowhere;", key), "profile lines.geojson");
        EXPECT_EQ(lost.exit_code, 2) << "degrees would be taken for what is metres";
        EXPECT_TRUE(contains(lost.err, "PROJ_DATA: leads to no list of coordinate systems")) << lost.err;
    }
}

// ---- limits and signals

TEST_F(AttemptsTest, A14AQuotaOfTheShellIsADiskThatIsFull) {
    ASSERT_EQ(runout(with(quick, {"--db", "v.db"})).exit_code, 0);
    const auto before = files();
    const Outcome page = runout_in_shell("ulimit -f 20;", "report v.db -o r.html");
    EXPECT_EQ(page.exit_code, 2) << "and not killed";
    EXPECT_TRUE(contains(page.err, "r.html: cannot be written")) << page.err;
    const Outcome run = runout_in_shell("ulimit -f 20;", "run case.toml --db f.db --no-pilots --quiet");
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_TRUE(contains(run.err, "f.db: ")) << run.err;
    EXPECT_EQ(files(), before);
}

TEST_F(AttemptsTest, A15FewFilesMayBeOpen) {
    const auto before = files();
    for (int most = 4; most <= 7; ++most) {
        const Outcome outcome = runout_in_shell(fmt::format("ulimit -n {};", most),
                                                "run case.toml --db f.db --no-pilots --quiet");
        if (outcome.exit_code == 0) break;
        EXPECT_TRUE(outcome.exit_code == 2 || outcome.exit_code == 127) << most << outcome.err;
        EXPECT_EQ(files(), before) << most;
    }
}

TEST_F(AttemptsTest, A16LittleMemory) {
    const auto before = files();
    const Outcome outcome = runout_in_shell(
        "ulimit -v 250000;", "run case.toml --db f.db --no-pilots --quiet --set run.resolution=1500");
    if (outcome.exit_code == 127 || contains(outcome.err, "ERROR: AddressSanitizer"))
        GTEST_SKIP() << "too little to load the program";
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_EQ(outcome.err,
              "runout: error: the memory does not suffice; run coarser, or fewer runs at a time\n");
    EXPECT_EQ(files(), before);
}

TEST_F(AttemptsTest, A17ATerminalThatCloses) {
    Arguments fine = {"run", "case.toml", "--db", "v.db", "--no-pilots", "--set", "run.resolution=150"};
    for (const int signal : {SIGHUP, SIGTERM}) {
        Child child(folder_.path(), fine);
        for (int i = 0; i < 1000 && !fs::exists(work("v.db-wal")); ++i) usleep(10'000);
        usleep(300'000);
        child.send(signal);
        EXPECT_EQ(child.wait().exit_code, 130);
        EXPECT_FALSE(fs::exists(work("v.db-wal")));
    }
    const Outcome table = runout({"table", "v.db"});
    EXPECT_TRUE(contains(table.out, "interrupted")) << table.out;
}

TEST_F(AttemptsTest, A18NohupMeansIt) {
    const Outcome outcome =
        runout_in_shell("trap '' HUP; sleep 0.4 && kill -HUP $$ &",
                        "run case.toml --db v.db --no-pilots --quiet --set run.resolution=30");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST_F(AttemptsTest, A19ASweepThatIsStoppedGoesOn) {
    write("study.toml",
          "[study]\ncase = \"case.toml\"\n[vary]\nmaterial.friction_angle_deg = { from = 30, to = 45, step = "
          "0.5 }\n");
    const Arguments sweep = {"sweep", "study.toml", "--db", "v.db", "-j", "1", "--quiet"};
    Child child(folder_.path(), sweep);
    for (int i = 0; i < 1000 && !fs::exists(work("v.db-wal")); ++i) usleep(10'000);
    usleep(500'000);
    child.send(SIGHUP);
    EXPECT_EQ(child.wait().exit_code, 130);
    EXPECT_FALSE(fs::exists(work("v.db-wal"))) << "the one file is whole";
    const int stored =
        SQLite::Database(work("v.db").string()).execAndGet("SELECT count(*) FROM run").getInt();
    const Outcome again = runout(sweep);
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_TRUE(contains(again.out, "31 of 31 scenarios")) << again.out;
    EXPECT_TRUE(contains(again.out, fmt::format(" {} known before", stored))) << again.out;
}

// ---- cases

TEST_F(AttemptsTest, A20TextsOfOtherEditorsSayTheSame) {
    const double usual = run_out("");
    std::string crlf;
    for (const char* c = sound_case; *c != '\0'; ++c) crlf.append(*c == '\n' ? 1 : 0, '\r').append(1, *c);
    for (const std::string& text :
         {std::string("\xef\xbb\xbf") + sound_case, crlf, changed("section.csv", "section\\u002ecsv"),
          changed("= 38", "= 0x26"), changed("= 38", "= 3_8.0e0"), changed("= 38", "= +38"),
          fmt::format("# {:x<3000000}\n{}", "", sound_case)}) {
        write("case.toml", text);
        EXPECT_EQ(run_out(""), usual) << text.substr(0, 200);
    }
}

TEST_F(AttemptsTest, A21TextsThatAreNotOurs) {
    std::string wide = "\xff\xfe", mac = sound_case;
    for (const char* c = sound_case; *c != '\0'; ++c) wide.append({*c, '\0'});
    std::ranges::replace(mac, '\n', '\r');
    for (const std::string& text : {wide, mac,
                                    "# Stra\xdf"
                                    "e\n" +
                                        std::string(sound_case)})
        expect_case_refused(text, {"bad.toml, line 1: is not valid TOML"});
    expect_case_refused(fmt::format("# {:x<10000000}", ""), {"is longer than 4 MB"});
    expect_case_refused(std::string(sound_case) + "[material]\ndensity_kg_m3 = 1900\n",
                        {"line 13", "redefine"});
    expect_case_refused(std::string("material.density_kg_m3 = 1900\n") + sound_case, {"line 10", "redefine"});
}

TEST_F(AttemptsTest, A22ValuesOfAnotherKind) {
    for (const char* value :
         {"2024-05-31", "true", "\"38\"", "[38]", "{ a = 38 }", "nan", "inf", "1e400", "07:32:00"})
        expect_case_refused(changed("= 38", fmt::format("= {}", value)), {"bad.toml, line 10"});
    expect_case_refused(std::string("place = []\n") + sound_case, {"line 1: place"});
    expect_case_refused(std::string(sound_case) + "name = 2024-05-31\n", {"line 13: run.name", "not a text"});
}

TEST_F(AttemptsTest, A23LettersThatLookAlike) {
    expect_case_refused(changed("[material]", "[m\xd0\xb0terial]"), {"line 9"});
    expect_case_refused(changed("friction_angle", "Friction_Angle"),
                        {"line 10", "nearest is material.friction"});
    expect_case_refused(changed("section.csv", "section\xe2\x80\x8b.csv"),
                        {"section\\xe2\\x80\\x8b.csv: does not exist"});
    expect_case_refused(changed("section.csv", "sec\xc2\xadtion.csv"), {"sec\\xc2\\xadtion.csv"});
    expect_case_refused(changed("section.csv", "SECTION.CSV"), {"SECTION.CSV: does not exist"});
}

TEST_F(AttemptsTest, A24SectionsThatAreNone) {
    for (const char* name :
         {"bad.toml", "/etc/passwd", "~/section.csv", "|cat section.csv", "$HOME/section.csv",
          "https://example.com/section.csv", "`id`", "section.csv;section.csv", "-"})
        expect_case_refused(changed("section.csv", name), {});
}

TEST_F(AttemptsTest, A25NamesThatAreNoText) {
    const std::string name = "s\xff<&.csv";
    write(name, slope);
    expect_refused({"new", name, "-o", "n.toml"}, {"s\\xff<&.csv", "is no UTF-8"});
    const Arguments source = {"--source",      "B",  "--base-angle",     "35",
                              "--scarp-angle", "80", "--friction-angle", "38"};
    EXPECT_EQ(
        runout(with({"run", name, "--db", "v.db", "--no-pilots", "--resolution", "10"}, source)).exit_code,
        0);
    EXPECT_EQ(runout({"profile", name, "--svg", "s.svg"}).exit_code, 0);
    EXPECT_EQ(runout({"report", "v.db", "-o", "r.html"}).exit_code, 0);
    for (const char* page : {"s.svg", "r.html"}) {
        EXPECT_TRUE(contains(text_of(work(page)), "s\\xff&lt;&amp;")) << page;
        EXPECT_FALSE(contains(text_of(work(page)), "\xff")) << page;
    }
    EXPECT_TRUE(Json::accept(runout({"table", "v.db", "--format", "json"}).out));
}

TEST_F(AttemptsTest, A26PlacesOfOneName) {
    const std::string two =
        "[[place]]\nname = \"road\"\nchainage_m = 0.5\n[[place]]\nname = \"{}\"\nchainage_m = 0.6\n";
    const auto places = [&](const char* name) { return sound_case + fmt::format(fmt::runtime(two), name); };
    expect_case_refused(places("road"), {"place.name", "[[place]] 1 and 2 alike: road"});
    expect_case_refused(std::string(sound_case) +
                            "[[place]]\nname = \"place-2\"\nchainage_m = 0.5\n"
                            "[[place]]\nchainage_m = 0.6\n",
                        {"alike: place-2"});
    write("case.toml", places("house"));
    EXPECT_GT(run_out(""), 0);
}

TEST_F(AttemptsTest, A27ThingsAtTheEndOfTheWorld) {
    for (const char* chainage : {"0", "2.5", "2.6", "-1", "1e300"}) {
        expect_case_refused(sound_case + fmt::format("[[place]]\nchainage_m = {}\n", chainage),
                            {"place.chainage_m"});
        expect_case_refused(
            sound_case + fmt::format("[effects.barrier]\nheight_m = 0.1\nchainage_m = {}\n", chainage),
            {"effects.barrier.chainage_m"});
    }
    expect_case_refused(std::string(sound_case) + "[effects.barrier]\nheight_m = 0.1\nchainage_m = 0.35\n",
                        {"into the source"});
}

// ---- studies

TEST_F(AttemptsTest, A28AValueThatCountsTwice) {
    for (const char* values :
         {"[36, 36]", "[36, 3.6e1]", "[36, \"36.0\"]", "{ from = 36, to = 36.0000000001, step = 1e-12 }"})
        expect_study_refused(fmt::format("[vary]\nmaterial.friction_angle_deg = {}\n", values),
                             {"study.toml, line 4: material.friction_angle_deg", "twice"});
    expect_study_refused("[vary]\nsection.file = [\"section.csv\", \"./x/../section.csv\"]\n",
                         {"section.csv twice"});
}

TEST_F(AttemptsTest, A29RangesThatLeadNowhere) {
    for (const char* range :
         {"from = 40, to = 30, step = 1", "from = 30, to = 40, step = 0", "from = nan, to = 40, step = 1",
          "from = 30, to = inf, step = 1", "from = 30, to = 40, step = 1e-300", "from = 30, to = 40",
          "from = 30, to = 40, step = \"1\"", "from = 30, to = 40, step = 1, weights = [-1, 1]"})
        expect_study_refused(fmt::format("[vary]\nmaterial.friction_angle_deg = {{ {} }}\n", range),
                             {"study.toml, line 4"});
}

TEST_F(AttemptsTest, A30StudiesThatDoNotMeanIt) {
    const auto vary = [](const std::string& text) { return "[vary]\n" + text + "\n"; };
    for (const char* text :
         {"material.friction_angle_deg = [36, true]", "material.friction_angle_deg = [[36]]",
          "source.length_m = [1, 2]", "effects.rate.b = [1]", "study.case = [\"a\"]"})
        expect_study_refused(vary(text), {"study.toml, line 4: "});
    const std::string pair = "[[correlation]]\nbetween = [\"{}\", \"{}\"]\nrank = {}\n";
    const std::string f = "material.friction_angle_deg", h = "source.height_m";
    expect_study_refused(
        "samples = 3\n[vary]\n" + f + " = { distribution = \"uniform\", low = 30, high = 40 }\n" + h +
            " = { distribution = \"uniform\", low = 0.1, high = 0.15 }\n" +
            fmt::format(fmt::runtime(pair), f, h, 0.9) + fmt::format(fmt::runtime(pair), h, f, -0.9),
        {"correlation.between", "correlated before"});
    write("self.toml", "[study]\ncase = \"self.toml\"\n[vary]\nmaterial.friction_angle_deg = [36]\n");
    expect_refused({"sweep", "self.toml", "--db", "s.db"}, {"self.toml, line 2"});
    write("study.toml", "[study]\ncase = \"case.toml\"\n[vary]\nmaterial.friction_angle_deg = [36, 38]\n");
    for (const char* input : {"section.csv", "case.toml", "study.toml", "s.db"})
        expect_refused({"sweep", "study.toml", "--db", "s.db", "--refused", input, "--overwrite"},
                       {input, "reads or writes itself"});
}

}  // namespace
}  // namespace runout
