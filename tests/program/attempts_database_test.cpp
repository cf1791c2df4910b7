// More attempts, on databases, drawings and maps that someone sends; attempts_test.cpp has the first thirty.

#include <SQLiteCpp/SQLiteCpp.h>

#include <chrono>
#include <limits>
#include <optional>
#include <thread>

#include "program_fixture.h"
#include "study/study_identity.h"

namespace runout {
namespace {

using SQLite::Database;

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int k = 0; k < times; ++k) all += text;
    return all;
}

class DatabaseAttemptsTest : public ProgramTest {
  protected:
    DatabaseAttemptsTest() {
        EXPECT_EQ(
            runout({"run", "case.toml", "--db", "v.db", "--no-pilots", "--frames", "3", "--quiet"}).exit_code,
            0);
    }
    [[nodiscard]] Outcome run_into(const std::string& database) const {
        return runout({"run", "case.toml", "--db", database, "--no-pilots", "--quiet", "--frames", "0",
                       "--set", "material.friction_angle_deg=36"});
    }
    void change(const std::string& name, const std::string& sql) const {
        Database database(work(name).string(), SQLite::OPEN_READWRITE);
        database.exec("PRAGMA foreign_keys = OFF; " + sql);
    }
    void copy_with(const std::string& name, const std::string& sql) const {
        fs::copy_file(work("v.db"), work(name), fs::copy_options::overwrite_existing);
        change(name, sql);
    }
    /// The definition of a table with `before` in place of `after`.
    void redefine(const std::string& name, const std::string& before, const std::string& after) const {
        copy_with(name, fmt::format("PRAGMA writable_schema = ON; UPDATE sqlite_schema SET sql ="
                                    " replace(sql, '{}', '{}') WHERE type = 'table'",
                                    before, after));
    }
    [[nodiscard]] long count(const std::string& name, const std::string& what) const {
        return Database(work(name).string(), SQLite::OPEN_READONLY)
            .execAndGet("SELECT count(*) FROM " + what)
            .getInt64();
    }
    [[nodiscard]] bool says_soon(const std::string& part) const {
        for (int i = 0; i < 3000; ++i) {
            if (contains(text_of(folder_.path() / "streams" / "err"), part)) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return false;
    }
    void expect_unreadable(const std::string& name, const std::vector<std::string>& parts) const {
        expect_refused({"profile", name}, parts);
    }
};

// ---- databases

TEST_F(DatabaseAttemptsTest, A31AnInfinityIsNoResult) {
    copy_with("x.db",
              "UPDATE measure SET run_out_m = 9e999, reach_angle_deg = -9e999, peak_front_speed_m_s = 9e999;"
              "UPDATE run SET particle_spacing_m = 9e999");
    const Json row = Json::parse(runout({"table", "x.db", "--format", "json"}).out)[0];
    for (const char* key : {"run_out_m", "reach_angle_deg"}) EXPECT_TRUE(row[key].is_null()) << key;
    expect_refused({"compare", "x.db"}, {"x.db: run = 1: cannot be compared"});
    EXPECT_EQ(runout({"report", "x.db", "-o", "x.html"}).exit_code, 0);
    EXPECT_FALSE(contains(text_of(work("x.html")), ">inf")) << "beside a house nobody is to read that";
}

TEST_F(DatabaseAttemptsTest, A32NoPlaceIsInfinitelyFar) {
    for (const char* sql :
         {"UPDATE section_point SET y_m = 9e999 WHERE point_index = 2",
          "UPDATE source_point SET x_m = -9e999", "UPDATE section SET toe_chainage_m = 9e999",
          "UPDATE frame SET x_step_m = 9e999"}) {
        copy_with("x.db", sql);
        expect_refused({"report", "x.db", "-o", "x.html"}, {"x.db: has an infinite number"});
    }
}

TEST_F(DatabaseAttemptsTest, A33OtherPagesAndEncodingsHoldTheSame) {
    const std::string usual = runout({"table", "v.db"}).out;
    for (const char* sql : {"PRAGMA page_size = 512; VACUUM", "PRAGMA page_size = 65536; VACUUM",
                            "PRAGMA auto_vacuum = FULL; VACUUM", "PRAGMA secure_delete = ON; VACUUM"}) {
        copy_with("x.db", sql);
        EXPECT_EQ(runout({"table", "x.db"}).out, usual) << sql;
        EXPECT_EQ(run_into("x.db").exit_code, 0) << sql;
    }
    fs::copy_file(work("v.db"), work("longer.db"));
    fs::resize_file(work("longer.db"), 3'000'000);
    EXPECT_EQ(runout({"table", "longer.db"}).out, usual) << "zeros behind the last page";
}

TEST_F(DatabaseAttemptsTest, A34TheLastNumberIsTaken) {
    copy_with("x.db", "UPDATE sqlite_sequence SET seq = 9223372036854775807 WHERE name = 'run'");
    const Outcome outcome = run_into("x.db");
    EXPECT_EQ(outcome.exit_code, 4) << "stored elsewhere: " << outcome.err;
    EXPECT_EQ(count("x.db", "run"), 1);
    copy_with("y.db", "UPDATE run SET run_id = -5; UPDATE measure SET run_id = -5");
    EXPECT_TRUE(contains(runout({"compare", "y.db", "--run", "-5"}).out, "run -5, "));
    EXPECT_EQ(run_into("y.db").exit_code, 0);
}

TEST_F(DatabaseAttemptsTest, A35ConditionsThatRefuseOurRows) {
    for (const char* sql :
         {"CREATE UNIQUE INDEX u ON run(status)", "CREATE UNIQUE INDEX u ON measure(run_out_m)"}) {
        copy_with("x.db", sql);
        expect_refused({"table", "x.db"}, {"x.db: has a table", "conditions that are not Runout's"});
        expect_refused({"merge", "v.db", "x.db"}, {"x.db: has a table"});
    }
    for (const char* condition : {"CHECK (run_out_m < 0)", "check(run_out_m IN (SELECT 1))", "UNIQUE"}) {
        redefine("x.db", "run_out_m                REAL,", fmt::format("run_out_m REAL {},", condition));
        expect_refused({"run", "case.toml", "--db", "x.db", "--quiet"}, {"x.db: "});
    }
}

TEST_F(DatabaseAttemptsTest, A36ColumnsThatAnswerWhatTheyLike) {
    for (const char* generated : {"AS (12.5) VIRTUAL", "GENERATED ALWAYS AS (7.0)"}) {
        redefine("x.db", "run_out_m                REAL,", fmt::format("run_out_m REAL {},", generated));
        expect_refused({"table", "x.db"}, {"x.db: has a table measure without the column run_out_m"});
    }
    copy_with(
        "x.db",
        "CREATE VIEW a AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT * FROM n;"
        "CREATE VIEW b AS SELECT * FROM c; CREATE VIEW c AS SELECT * FROM b;"
        "DROP VIEW result; CREATE VIEW result AS SELECT 1 AS run_id, 99.0 AS run_out_m");
    EXPECT_EQ(runout({"table", "x.db"}).out, runout({"table", "v.db"}).out);
}

TEST_F(DatabaseAttemptsTest, A37FilesThatOnlyLookLikeOne) {
    const std::string whole = text_of(work("v.db"));
    std::string scrambled = whole;
    for (std::size_t i = 16; i < scrambled.size(); ++i)
        scrambled[i] = static_cast<char>(scrambled[i] ^ (7 * i + 91));
    write("scrambled.db", scrambled);
    write("head.db", whole.substr(0, 100));
    write("turned.db", std::string(whole.rbegin(), whole.rend()));
    copy_with("other.db", "PRAGMA application_id = 1196444487");
    copy_with("future.db", "PRAGMA user_version = 99");
    for (const char* name : {"scrambled.db", "head.db", "turned.db", "other.db", "future.db"})
        for (const Arguments& arguments : {Arguments{"table", name}, Arguments{"merge", "v.db", name},
                                           Arguments{"delete", name, "--run", "1", "--yes"},
                                           Arguments{"run", "case.toml", "--db", name, "--quiet"}})
            expect_refused(arguments, {std::string("error: ") + name + ": "});
    EXPECT_EQ(text_of(work("v.db")), whole);
}

TEST_F(DatabaseAttemptsTest, A38MergingWithItselfByAnyName) {
    fs::create_hard_link(work("v.db"), work("hard.db"));
    fs::create_symlink("v.db", work("soft.db"));
    for (const Arguments& arguments :
         {Arguments{"merge", "v.db", "hard.db"}, Arguments{"merge", "soft.db", "v.db"},
          Arguments{"merge", "hard.db", "soft.db"}})
        expect_refused(arguments, {"is the database to merge into"});
    const Outcome thrice = runout({"merge", "m.db", "v.db", "hard.db", "soft.db"});
    EXPECT_EQ(thrice.exit_code, 0) << thrice.err;
    EXPECT_EQ(count("m.db", "run"), 1);
}

TEST_F(DatabaseAttemptsTest, A39NothingInIt) {
    ASSERT_EQ(runout({"delete", "v.db", "--run", "1", "--yes"}).exit_code, 0);
    EXPECT_EQ(runout({"table", "v.db"}).out, "no runs stored\n");
    for (const Arguments& arguments :
         {Arguments{"report", "v.db"}, Arguments{"compare", "v.db"},
          Arguments{"export", "v.db", "--csv", "out"}, Arguments{"map", "v.db", "-o", "m.gpkg"},
          Arguments{"report", "v.db", "--section", "1"}, Arguments{"report", "v.db", "--study", "s"},
          Arguments{"estimate", "v.db", "case.toml"}})
        expect_refused(arguments, {});
}

TEST_F(DatabaseAttemptsTest, A40OneRunNamedTwiceGoesOnce) {
    ASSERT_EQ(run_into("v.db").exit_code, 0);
    const Outcome outcome = runout({"delete", "v.db", "--run", "2", "--run", "2", "--yes"});
    EXPECT_TRUE(contains(outcome.out, "To be removed from v.db: 1 run\n")) << outcome.out;
    EXPECT_EQ(count("v.db", "run"), 1);
    for (const char* id : {"01x", "1;2", "1e0"})
        expect_refused({"delete", "v.db", "--run", id, "--yes"}, {"--run"});
}

TEST_F(DatabaseAttemptsTest, A41NothingIsTakenFromASweepAtWork) {
    write("study.toml",
          "[study]\ncase = \"case.toml\"\n[vary]\nmaterial.friction_angle_deg = { from = 30, to = 45, step = "
          "0.5 }\n");
    Child sweep(folder_.path(), {"sweep", "study.toml", "--db", "v.db", "-j", "1", "--quiet"});
    for (int i = 0; i < 1000 && !fs::exists(work("v.db-wal")); ++i) usleep(10'000);
    const fs::path own = folder_.path() / "other";
    fs::create_directories(own);
    fs::create_symlink(work(), own / "work");
    const Outcome removal = Child(own, {"delete", "v.db", "--older-than", "2999-01-01", "--yes"}).wait();
    EXPECT_EQ(removal.exit_code, 2) << removal.out;
    EXPECT_TRUE(contains(removal.err, "v.db: is in use by another program")) << removal.err;
    const Outcome outcome = sweep.wait();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(count("v.db", "study_scenario"), 31);
}

TEST_F(DatabaseAttemptsTest, A42WhoWaitsSaysForWhatAndLosesNothing) {
    write("study.toml", "[study]\ncase = \"case.toml\"\n[vary]\nmaterial.friction_angle_deg = [34, 35]\n");
    for (const Arguments& arguments :
         {Arguments{"sweep", "study.toml", "--db", "v.db", "-j", "1", "--quiet"},
          Arguments{"accuracy", "case.toml", "--db", "v.db", "--lattices", "1", "--budget", "0.1", "--quiet"},
          Arguments{"stress", "--scenes", "1", "--db", "v.db", "-j", "1", "--quiet"}}) {
        const long before = count("v.db", "run");
        std::optional<Database> other(std::in_place, work("v.db").string(), SQLite::OPEN_READWRITE);
        other->exec("BEGIN");
        (void)other->execAndGet("SELECT count(*) FROM run");
        Child child(folder_.path(), arguments);
        EXPECT_TRUE(says_soon("v.db is in use by another program; what has ended waits for it"))
            << arguments[0];
        other.reset();
        const Outcome outcome = child.wait();
        EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << arguments[0] << outcome.err;
        EXPECT_GT(count("v.db", "run"), before) << arguments[0];
    }
}

TEST_F(DatabaseAttemptsTest, A43NamesAsLongAsABook) {
    copy_with("x.db",
              "UPDATE run SET name = hex(zeroblob(1000000)), status_detail = hex(zeroblob(1000000)),"
              " machine = hex(zeroblob(1000000))");
    for (const Arguments& arguments :
         {Arguments{"table", "x.db"}, Arguments{"report", "x.db", "-o", "x.html"},
          Arguments{"compare", "x.db"}, Arguments{"export", "x.db", "--csv", "out"}})
        EXPECT_EQ(runout(arguments).exit_code, 0) << arguments[0];
}

TEST_F(DatabaseAttemptsTest, A44TimesOfAClockThatWasSetBack) {
    copy_with("x.db", "UPDATE run SET ended_utc = '9999-12-31T23:59:59Z', started_utc = 'yesterday'");
    EXPECT_EQ(run_into("x.db").exit_code, 0);
    EXPECT_EQ(runout({"report", "x.db", "-o", "x.html"}).exit_code, 0);
    EXPECT_TRUE(contains(runout({"delete", "x.db", "--older-than", "1h", "--yes"}).out, ": 0 runs"));
    EXPECT_EQ(count("x.db", "run"), 2);
}

// ---- drawings and maps

TEST_F(DatabaseAttemptsTest, A45XmlThatGrowsAndXmlThatReaches) {
    std::string bomb = "<?xml version=\"1.0\"?>\n<!DOCTYPE l [<!ENTITY a \"aaaaaaaaaa\">";
    for (char name = 'b'; name < 'k'; ++name)
        bomb += fmt::format("<!ENTITY {} \"{}\">", name,
                            repeated(fmt::format("&{};", static_cast<char>(name - 1)), 10));
    const std::string land = "<LandXML xmlns=\"http://www.landxml.org/schema/LandXML-1.2\">";
    write("bomb.xml", bomb + "]>" + land + "<Alignments><Alignment name=\"&j;\"/></Alignments></LandXML>");
    write(
        "bomb.kml",
        bomb +
            "]><kml xmlns=\"http://www.opengis.net/kml/2.2\"><Placemark><name>&j;</name></Placemark></kml>");
    write("deep.xml", "<?xml version=\"1.0\"?>" + land + repeated("<a>", 300'000));
    for (const char* name : {"bomb.xml", "bomb.kml", "deep.xml"}) expect_unreadable(name, {name});
    write(
        "reach.xml",
        "<?xml version=\"1.0\"?><!DOCTYPE l [<!ENTITY x SYSTEM \"file:///etc/passwd\">]>" + land +
            "<Units><Metric linearUnit=\"meter\"/></Units><Alignments><Alignment name=\"&x;\"><CrossSects>"
            "<CrossSect sta=\"0\"><CrossSectSurf name=\"g\"><PntList2D>0 0.4 0.3 0.4 0.45 0 2.5 0</PntList2D>"
            "</CrossSectSurf></CrossSect></CrossSects></Alignment></Alignments></LandXML>");
    const Outcome reach = runout({"profile", "reach.xml"});
    EXPECT_FALSE(contains(reach.out + reach.err, "root:")) << reach.out;
}

TEST_F(DatabaseAttemptsTest, A46BlocksThatHoldThemselves) {
    const auto block = [](const std::string& name, const std::string& held) {
        return "0\nBLOCK\n2\n" + name + "\n70\n0\n10\n0\n20\n0\n" + held + "0\nENDBLK\n";
    };
    const auto insert = [](const std::string& name) {
        return "0\nINSERT\n8\n0\n2\n" + name + "\n10\n0\n20\n0\n";
    };
    const std::string line = "0\nLINE\n8\n0\n10\n0\n20\n0\n11\n1\n21\n1\n";
    const auto drawing = [](const std::string& blocks, const std::string& entities) {
        return "0\nSECTION\n2\nBLOCKS\n" + blocks + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities +
               "0\nENDSEC\n0\nEOF\n";
    };
    write("circle.dxf", drawing(block("A", insert("B") + insert("B")) + block("B", insert("A") + insert("A")),
                                insert("A")));
    std::string tower = block("N0", line);
    for (int k = 1; k < 14; ++k)
        tower += block(fmt::format("N{}", k), repeated(insert(fmt::format("N{}", k - 1)), 10));
    write("tower.dxf", drawing(tower, insert("N13")));
    write("array.dxf", drawing(block("N", line), insert("N") + "70\n32000\n71\n32000\n44\n1\n45\n1\n"));
    for (const char* name : {"circle.dxf", "tower.dxf", "array.dxf"}) expect_unreadable(name, {name});
}

class MapAttemptsTest : public DatabaseAttemptsTest {
  protected:
    MapAttemptsTest() {
        write(
            "line.geojson",
            R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:2326"}},"features":[)"
            R"({"type":"Feature","properties":{"select":"a","order":1,"group":"b"},"geometry":{"type":"LineString",)"
            R"("coordinates":[[834001,816005],[834199,816005]]}}]})");
        write("map.toml",
              "[section]\nline = \"line.geojson\"\nraster = \"r.asc\"\nraster_crs = "
              "\"EPSG:2326\"\n[source]\ntype = \"B\"\n"
              "base_angle_deg = 35\nscarp_angle_deg = 88\n[material]\nfriction_angle_deg = "
              "38\n[run]\nresolution = 8\n");
    }
    /// 200 x 10 cells of a metre, a slope of 45 deg between 30 and 50.
    static std::string grid(const std::string& head, int rows = 10) {
        std::string row;
        for (int i = 0; i < 200; ++i) row += fmt::format("{} ", std::clamp(62.5 - i, 12.5, 32.5));
        return head + repeated(row + "\n", rows);
    }
    static std::string head(const std::string& columns, const std::string& rows, const std::string& cell) {
        return fmt::format(
            "ncols {}\nnrows {}\nxllcorner 834000\nyllcorner 816000\ncellsize {}\nNODATA_value -9999\n",
            columns, rows, cell);
    }
};

TEST_F(MapAttemptsTest, A47RastersThatAreMostlyPromise) {
    write("r.asc", grid(head("200", "10", "1")));
    EXPECT_EQ(runout({"profile", "map.toml"}).exit_code, 0);
    const std::vector<std::pair<std::string, std::string>> grids = {
        {grid(head("1000000", "1000000", "1"), 1), "is cut off"},
        {grid(head("200", "10000000", "1"), 1), "is cut off"},
        {grid(head("2147483647", "2147483647", "1"), 1), "r.asc: "},
        {grid(head("200", "10", "0")), "is not placed on a map"},
        {grid(head("200", "10", "-1")), "lies outside the raster"},
        {grid(head("200", "10", "1e-300")), "r.asc: "},
        {head("200", "10", "1") + repeated("nan ", 2000), "r.asc: "},
        {head("200", "10", "1") + repeated("-9999 ", 2000), "meets a cell without data"},
        {head("200", "10", "1") + repeated("1e300 ", 2000), "is no elevation"}};
    for (const auto& [text, problem] : grids) {
        write("r.asc", text);
        expect_refused({"profile", "map.toml"}, {problem});
    }
}

TEST_F(MapAttemptsTest, A48MapsCalledAsStatements) {
    write("r.asc", grid(head("200", "10", "1")));
    ASSERT_EQ(runout({"run", "map.toml", "--db", "m.db", "--no-pilots", "--quiet"}).exit_code, 0);
    for (const char* name : {"select.gpkg", "order by.gpkg", "a'b\";--.gpkg", "GPKG:x.gpkg", "a?b=c#d.gpkg",
                             "u\xff.gpkg", "drop table.geojson", "a'b.geojson", "u\xff.geojson"}) {
        const auto before = files();
        const Outcome outcome = runout({"map", "m.db", "-o", name});
        EXPECT_EQ(outcome.exit_code, 0) << name << outcome.err;
        EXPECT_EQ(files().size(), before.size() + 1) << name;
        EXPECT_TRUE(fs::exists(work(name))) << name;
        EXPECT_TRUE(fs::path(name).extension() == ".gpkg" || Json::accept(text_of(work(name)))) << name;
    }
    for (const char* name : {"/vsimem/x.gpkg", "x", ".gpkg", "x.gpkg/", "x.shp"})
        expect_refused({"map", "m.db", "-o", name}, {});
}

TEST_F(MapAttemptsTest, A49AStudyKnowsWhatBelongsToItsFiles) {
    write("r.asc", grid(head("200", "10", "1")));
    write("study.toml", "[study]\ncase = \"map.toml\"\n[vary]\nmaterial.friction_angle_deg = [34, 36]\n");
    const auto identity = [&] { return study_identity(read_study(work("study.toml").string())); };
    const std::string before = identity();
    EXPECT_EQ(identity(), before);
    write("r.prj", "PROJCS[\"another\"]");
    const std::string with_system = identity();
    EXPECT_NE(with_system, before) << "the raster lies elsewhere";
    write("r.prj", "PROJCS[\"a third\"]");
    EXPECT_NE(identity(), with_system);
    expect_refused({"run", "map.toml", "--db", "m.db", "--refused", "r.prj", "--overwrite", "--quiet"},
                   {"r.prj", "reads or writes itself"});
}

TEST_F(MapAttemptsTest, A50ASectionThatChangesWhileItIsUsed) {
    std::string longer = slope;
    longer.replace(longer.find("2.5,0"), 5, "2.6,0");
    ASSERT_EQ(run_into("v.db").exit_code, 0);
    write("section.csv", longer);
    const Outcome other = run_into("v.db");
    EXPECT_EQ(other.exit_code, 0) << other.err;
    EXPECT_EQ(count("v.db", "section"), 2) << "one name, and two grounds";
    EXPECT_EQ(count("v.db", "scenario"), 3);
    write("section.csv", "chainage_m,elevation_m\n0,0.4\n0.3,");
    expect_refused({"run", "case.toml", "--db", "v.db", "--quiet"}, {"section.csv"});
    EXPECT_EQ(count("v.db", "run"), 3);
}

}  // namespace
}  // namespace runout
