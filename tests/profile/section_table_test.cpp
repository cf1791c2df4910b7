// Tables of points as people have them: read as they were meant, or refused with what to give.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "profile/check_elevations.h"
#include "profile/profile.h"
#include "profile/read_section_table.h"
#include "said.h"
#include "temporary_folder.h"

using namespace runout;

namespace {

const std::vector<Vec2> slope{{0, 32}, {30, 32}, {41.547, 12}, {201.547, 12}};

class SectionTable : public testing::Test {
  protected:
    [[nodiscard]] SectionPoints read(const std::string& bytes, const TableOptions& options = {}) const {
        const std::string path = folder_.file("section.csv");
        std::ofstream(path, std::ios::binary) << bytes;
        return read_section_table(path, options);
    }

    /// What is said of how the file was read; the points have to be those of the slope.
    std::string said_of_slope(const std::string& bytes, const TableOptions& options = {}) const {
        const std::string error = input_error([&] {
            const SectionPoints section = read(bytes, options);
            said_ = section.read_as;
            EXPECT_EQ(section.points.size(), slope.size()) << bytes;
            for (std::size_t i = 0; i < std::min(section.points.size(), slope.size()); ++i)
                EXPECT_LT((section.points[i] - slope[i]).norm(), 1e-9) << bytes << " point " << i;
        });
        EXPECT_EQ(error, "") << bytes;
        return said_;
    }

    [[nodiscard]] std::string refusal(const std::string& bytes, const TableOptions& options = {}) const {
        const std::string error = input_error([&] { said_ = read(bytes, options).read_as; });
        EXPECT_NE(error, "") << bytes << said_;
        return error;
    }

    TemporaryFolder folder_;
    mutable std::string said_;
};

SectionPoints field(const std::string& name) {
    return read_section_table(RUNOUT_SOURCE_DIR "/tests/field/" + name, {});
}

void expect_slope(const SectionPoints& section, double tolerance) {
    ASSERT_EQ(section.points.size(), slope.size());
    for (std::size_t i = 0; i < slope.size(); ++i)
        EXPECT_LT((section.points[i] - slope[i]).norm(), tolerance) << i;
}

// ---- files as exported elsewhere

TEST(FieldTable, SemicolonsAndDecimalCommas) {
    const SectionPoints section = field("semicolon-decimal-comma.csv");
    expect_slope(section, 1e-9);
    EXPECT_EQ(
        section.read_as,
        "read as: chainage from column 1 'Station (m)', elevation from column 2 'Höhe (m)', separator ';', "
        "decimal comma, metres");
    EXPECT_EQ(section.lines, (std::vector{2, 3, 4, 5}));
}

TEST(FieldTable, Stations) {
    const SectionPoints section = field("stations.txt");
    expect_slope(section, 1e-9);
    EXPECT_EQ(
        section.read_as,
        "read as: chainage from column 1 'Station', elevation from column 2 'Elev', separator tab, decimal "
        "point, stations of 1000, metres as no unit is named");
}

TEST(FieldTable, Feet) {
    const SectionPoints section = field("feet.csv");
    expect_slope(section, 5e-4);
    EXPECT_DOUBLE_EQ(section.points[1].x(), 98.425 * 0.3048);
    EXPECT_PRED2(contains, section.read_as, "feet (0.3048 m)");
}

TEST(FieldTable, StrictFormSaysNothing) {
    const SectionPoints section = field("slope.csv");
    expect_slope(section, 1e-9);
    EXPECT_EQ(section.read_as, "");
}

TEST(FieldTable, NoDataIsRefusedWithLineAndValue) {
    const std::string error = input_error([] { field("nodata.csv"); });
    EXPECT_PRED2(contains, error, "nodata.csv, line 5: elevation_m = -9999: stands for missing data");
}

// ---- the strict form

TEST_F(SectionTable, ColumnsByNameCommentsBlanksBomAndCrlf) {
    const SectionPoints plain = read("chainage_m,elevation_m\n0,2\n2,0\n5,0\n");
    const SectionPoints other = read(
        "\xEF\xBB\xBF# surveyed\r\n\r\n elevation_m , \"chainage_m\"\r\n2,0 # crest\r\n+0.0, 2e0\r\n\r\n0,5");
    EXPECT_EQ(plain.points, other.points);
    EXPECT_EQ(plain.read_as + other.read_as, "");
    EXPECT_EQ(other.lines, (std::vector{4, 5, 7}));
}

TEST_F(SectionTable, ErrorsNameFileLineColumnAndValue) {
    const std::string header = "chainage_m,elevation_m\n";
    EXPECT_EQ(refusal("# c\n" + header + "0,2\n\n1,2m\n"),
              folder_.file("section.csv") +
                  ", line 5: elevation_m = 2m: is not a number; give a number, such as 12.5");
    EXPECT_PRED2(contains, refusal(""), "is empty");
    EXPECT_PRED2(contains, refusal("# only a comment\n\n"), "has no row with a chainage and an elevation");
    EXPECT_PRED2(contains, refusal(header), "line 1: has a header but no points");
    EXPECT_PRED2(contains, refusal(header + "0,2\n"), "line 2: has one point only");
    EXPECT_PRED2(contains, refusal(header + "0,2\n,1\n"), "line 3: chainage_m: is empty");
    EXPECT_PRED2(contains, refusal(header + "0,nan\n1,0\n"),
                 "line 2: elevation_m = nan: says that there is no value");
    EXPECT_PRED2(contains, refusal(header + "0,1e999\n1,0\n"), "is not a finite number");
    EXPECT_PRED2(contains, refusal(header + "0,2\n1,0,7\n"), "line 3: has 3 fields; the header names 2");
    EXPECT_PRED2(contains, refusal(header + "0,2\n1\n"), "line 3: has 1 field;");
    EXPECT_PRED2(contains, refusal(header + "0,2\n1;0\n"), "line 3: has 1 field;");
    EXPECT_PRED2(contains, refusal("chainage_m\n0\n1\n"), "--columns A,B");
    EXPECT_PRED2(contains, refusal(header + "0,2\n3,1\n2,0\n"), "line 4: chainage_m = 2: goes back behind 3");
    EXPECT_PRED2(contains, input_error([&] { read_section_table(folder_.file("none.csv"), {}); }),
                 "none.csv: does not exist");
}

// ---- separators, marks, quotes

TEST_F(SectionTable, EverySeparator) {
    for (const std::string mark : {",", ";", "|", "\t", " ", "   ", " \t", " ; "}) {
        std::string text = "Distance" + mark + "Elevation\n";
        for (const char* row : {"0@32", "30@32", "41.547@12", "201.547@12"}) {
            std::string line = row;
            text += line.replace(line.find('@'), 1, mark) + "\n";
        }
        said_of_slope(text);
    }
}

TEST_F(SectionTable, DecimalCommasBesideEverySeparatorButCommas) {
    for (const std::string mark : {";", "|", "\t", " "})
        EXPECT_PRED2(contains,
                     said_of_slope("Station" + mark + "Elev\n0,0" + mark + "32,0\n30,0" + mark +
                                   "32\n41,547" + mark + "12,00\n201,547" + mark + "12\n"),
                     "decimal comma");
    EXPECT_PRED2(
        contains,
        said_of_slope("\"Station\",\"Elev\"\n\"0,0\",\"32,0\"\n30,32\n\"41,547\",12\n\"201,547\",12\n"),
        "separator ',', decimal comma");
}

TEST_F(SectionTable, DecimalCommasBetweenCommasAreRefused) {
    EXPECT_PRED2(contains, refusal("Station,Elev\n0,00,32,00\n30,00,32,00\n"), "line 2: has 4 fields");
    EXPECT_PRED2(contains, refusal("0,00,32,00\n30,00,32,00\n"), "4 columns that no header names");
    EXPECT_PRED2(contains, refusal("0,32\n30,5,32\n", {.columns = "1,2"}), "line 2: has 3 fields");
}

TEST_F(SectionTable, NoHeader) {
    EXPECT_PRED2(contains, said_of_slope("0,32\n30,32\n41.547,12\n201.547,12\n"),
                 "chainage from column 1, elevation from column 2, separator ','");
    said_of_slope("0 32\n30 32\n41.547 12\n201.547 12\n");
    said_of_slope("0,0 32,0\n30,0 32,0\n41,547 12,0\n201,547 12,0\n");
    EXPECT_PRED2(contains, refusal("1,0,32\n2,30,32\n"), "--columns A,B");
    said_of_slope("1,0,32\n2,30,32\n3,41.547,12\n4,201.547,12\n", {.columns = "2,3"});
}

TEST_F(SectionTable, QuotedFields) {
    said_of_slope(
        "Name;\"Dist; "
        "\"\"true\"\"\";Elev\n\"a;b\";\"0\";32\n\"two\nlines\";30;32\nx;41.547;12\n\"\";201.547;12\n");
    EXPECT_PRED2(contains, refusal("Dist;Elev\n\"0;32\n30;32\n"), "quotation that is never closed");
}

TEST_F(SectionTable, TrailingSeparatorsBlankAndRepeatedRows) {
    const std::string rows = "Dist;Elev;Note\n0;32;;;\n30;32;crest\n\n41.547;12;\n201.547;12\n";
    said_of_slope(rows + ";;;\n\n  \n");
    EXPECT_PRED2(contains, said_of_slope(rows + "201.547;12\n"),
                 "line 7 left out as it repeats the last point");
    EXPECT_EQ(read("chainage_m,elevation_m\n0,1\n2,0\n2,0\n").points.size(), 2u);
}

TEST_F(SectionTable, MarkdownAndExcelHints) {
    said_of_slope(
        "| Chainage | Elevation |\n|---|---|\n| 0 | 32 |\n| 30 | 32 |\n| 41.547 | 12 |\n| 201.547 | 12 |\n");
    said_of_slope("sep=;\nChainage;Elevation\n0;32\n30;32\n41.547;12\n201.547;12\n");
}

// ---- text encodings

std::string utf16(const std::string& ascii, bool little_endian, bool mark) {
    std::string bytes = !mark ? "" : little_endian ? "\xFF\xFE" : "\xFE\xFF";
    for (const char c : ascii) bytes += little_endian ? std::string{c, '\0'} : std::string{'\0', c};
    return bytes;
}

TEST_F(SectionTable, EncodingsAndLineEnds) {
    const std::string rows = "0;32\n30;32\n41.547;12\n201.547;12\n";
    const std::string ascii = "Station;Elev\n" + rows;
    for (const bool little : {true, false})
        for (const bool mark : {true, false}) said_of_slope(utf16(ascii, little, mark));
    said_of_slope("\xEF\xBB\xBF" + ascii);
    said_of_slope("Station;H\xF6he\n" + rows);       // Windows-1252
    said_of_slope("Station;Ho\xCC\x88he\n" + rows);  // an accent of its own
    for (const std::string end : {"\r", "\r\n"}) {
        std::string text;
        for (const char c : ascii) text += c == '\n' ? end : std::string(1, c);
        said_of_slope(text);
        EXPECT_EQ(read(text).lines, (std::vector{2, 3, 4, 5}));
    }
    EXPECT_PRED2(contains, refusal(std::string("0;32\n30\0;32\n", 12)), "zero byte");
    EXPECT_PRED2(contains, refusal("PK\x03\x04zip"), "workbook");
}

TEST_F(SectionTable, SignsBlanksAndThousands) {
    const auto elevations = [&](const std::string& text) {
        std::vector<double> y;
        for (const Vec2& p : read(text).points) y.push_back(p.y());
        return y;
    };
    EXPECT_EQ(elevations("d;z\n0;+3\n5;\xE2\x88\x92"
                         "2.5\n"),
              (std::vector{3.0, -2.5}));
    EXPECT_EQ(elevations("Dist;Elev\n0;1'234.5\n5;1\xE2\x80\x99"
                         "230.25\n"),
              (std::vector{1234.5, 1230.25}));
    EXPECT_EQ(elevations("Dist;Elev\n0,5;1\xC2\xA0"
                         "234,5\n5;1\xE2\x80\xAF"
                         "230,25\n"),
              (std::vector{1234.5, 1230.25}));
    EXPECT_EQ(elevations("Dist;Elev\n0;1,234.5\n5;1,230\n"), (std::vector{1234.5, 1230.0}));
    EXPECT_EQ(elevations("Dist;Elev\n0;1.234,5\n5;1.230\n"), (std::vector{1234.5, 1230.0}));
    EXPECT_EQ(elevations("Dist,Elev\n0,\"1,234.5\"\n5,\"1,230\"\n"), (std::vector{1234.5, 1230.0}));
    EXPECT_EQ(elevations("Dist;Elev\n0;1.2345e3\n5;123.45E1\n"), (std::vector{1234.5, 1234.5}));
}

TEST_F(SectionTable, MarksThatMayBeThousandsAreRefused) {
    EXPECT_PRED2(contains, refusal("Dist;Elev\n0;1,250\n10;1,245\n"),
                 "line 2: number = 1,250: may have thousands or decimals");
    EXPECT_PRED2(contains, refusal("Dist;Elev\n0;1.250\n10;1.245\n"), "--decimal point or --decimal comma");
    EXPECT_PRED2(contains, refusal("Dist;Elev\n0.5;1,250\n10;1,245\n"), "may have thousands or decimals");
    EXPECT_PRED2(contains, refusal("Dist;Elev\n0.5;32\n10,5;31\n"),
                 "line 3: number = 10,5: has another decimal mark than 0.5");
    EXPECT_EQ(read("Dist;Elev\n0;1,250\n10;1,245\n", {.decimal = "point"}).points[0], Vec2(0, 1250));
    EXPECT_EQ(read("Dist;Elev\n0;1,250\n10;1,245\n", {.decimal = "comma"}).points[0], Vec2(0, 1.25));
    // No section is 200 km long, and no ground 132 km high.
    said_of_slope("Dist;Elev\n0;32\n30;32\n41.547;12\n201.547;12\n");
    EXPECT_EQ(read("Dist;Elev\n100,125;132,125\n110,250;130,250\n").points[0], Vec2(100.125, 132.125));
}

// ---- headers

TEST_F(SectionTable, NamesOfManyHouses) {
    const std::string rows = "\n0;32\n30;32\n41.547;12\n201.547;12\n";
    for (const char* header : {"Distance (m);Height (m)",
                               "Station;Elev",
                               "X;Z",
                               "x;y",
                               "Chainage;RL",
                               "Dist_m;Z [m]",
                               "Abstand;Höhe",
                               "STATION [m];HÖHE [m]",
                               "DISTANCE;ALTITUDE",
                               "FIRST_DIST;FIRST_Z",
                               "Chainage / m;Elevation / m",
                               "s;z",
                               "Distance along line;Ground level",
                               "Afstand;Hoogte",
                               "Distanza (m);Quota (m s.l.m.)",
                               "Dist. cumulée;Altitude",
                               "Distancia;Cota",
                               "Station m;Elevation in m",
                               "Horizontaldistanz;Geländehöhe m ü.M.",
                               "FirstDist;GroundElev",
                               "里程;高程",
                               "km + m chainage;Elevation (m AHD)",
                               "Vzdálenost;Výška",
                               "offset;elevation",
                               "d;h"})
        said_of_slope(header + rows);
}

TEST_F(SectionTable, FurtherColumnsInAnyOrder) {
    said_of_slope(
        "id,Name,ELEVATION,EASTING,NORTHING,DISTANCE,code\n1,a,32,7.1,8.1,0,k\n2,,32,7.2,8.2,30,\n3,c,12,7.3,"
        "8.3,41.547,f\n"
        "4,d,12,7,8,201.547,\n");
    said_of_slope("Distance;Altitude;X;Y\n0;32;5;6\n30;32;5;6\n41.547;12;5;6\n201.547;12;5;6\n");
    said_of_slope("Point Distance Elevation\nA1 0 32\nA2 30 32\nA3 41.547 12\nA4 201.547 12\n");
}

TEST_F(SectionTable, TitlesUnitRowsAndComments) {
    said_of_slope(
        "Cross-section 3 of 12\nProject: road; "
        "north\n\nStation;Elev\n(m);(m)\n0;32\n30;32\n41.547;12\n201.547;12\n");
    said_of_slope("# distance elevation\n0 32\n30 32\n41.547 12\n201.547 12\n");
    said_of_slope(
        "# surveyed\nchainage_m,elevation_m\n0,32 # crest\n30,32# more\n41.547,12\n# note\n201.547,12\n");
    EXPECT_DOUBLE_EQ(read("Station;Elev\n[ft];[ft]\n0;100\n100;50\n").points[1].x(), 30.48);
}

TEST_F(SectionTable, NamesThatLeaveAChoiceAreRefused) {
    EXPECT_PRED2(contains, refusal("Station;Offset;Elev\n0;1;32\n30;1;32\n"),
                 "'Station', 'Offset'; give --columns A,B");
    EXPECT_PRED2(contains, refusal("Distance;Elev;Altitude\n0;1;32\n30;1;32\n"),
                 "elevations in any of the columns");
    EXPECT_PRED2(contains, refusal("A;B\n0;32\n30;32\n"), "names the columns 'A', 'B'");
    EXPECT_PRED2(contains, refusal("Distance;Slope\n0;32\n30;32\n"), "--columns A,B");
    EXPECT_PRED2(contains, refusal("Slope distance;Elevation\n0;32\n30;32\n"), "--columns A,B");
    EXPECT_PRED2(contains, refusal("Distance;Groundwater level\n0;32\n30;32\n"), "--columns A,B");
    EXPECT_PRED2(contains, refusal("X;Y;Z\n0;32;3\n30;32;5\n"),
                 "places on a map and elevations, and no chainage");
    EXPECT_PRED2(contains, refusal("chainage_m,chainage_m\n0,32\n30,31\n"), "--columns A,B");
    said_of_slope("X;Y;Z\n0;0;32\n30;0;32\n41.547;0;12\n201.547;0;12\n", {.columns = "X,Z"});
    said_of_slope("Distance;DTM;DSM\n0;32;33\n30;32;33\n41.547;12;13\n201.547;12;13\n",
                  {.columns = "distance,dtm"});
    EXPECT_PRED2(contains, refusal("Distance;DTM\n0;32\n30;31\n", {.columns = "Distance,DEM"}),
                 "are not two columns");
    EXPECT_PRED2(contains, refusal("Distance;DTM\n0;32\n30;31\n", {.columns = "2"}),
                 "does not name two columns");
    EXPECT_PRED2(contains, refusal("Distance;DTM\n0;32\n30;31\n", {.columns = "2,9"}),
                 "the columns 2,9 that section.columns");
}

// ---- units and stations

TEST_F(SectionTable, Units) {
    const auto last = [&](const std::string& text, const TableOptions& options = {}) {
        return read(text, options).points.back();
    };
    EXPECT_EQ(last("Dist (ft);Elev (ft)\n0;100\n1000;50\n"), Vec2(304.8, 50 * 0.3048));
    EXPECT_EQ(last("dist_ft;elev_m\n0;100\n1000;50\n"), Vec2(304.8, 50));
    EXPECT_EQ(last("Dist (US survey feet);Elev (ftUS)\n0;100\n3937;50\n"),
              Vec2(3937 * (1200.0 / 3937), 50 * (1200.0 / 3937)));
    EXPECT_EQ(last("Dist (km);Elev (m)\n0;100\n0.5;50\n"), Vec2(500, 50));
    EXPECT_EQ(last("Dist;Elev\n0;100\n1000;50\n", {.unit = "ft"}), Vec2(304.8, 50 * 0.3048));
    EXPECT_PRED2(contains, refusal("Dist;Elev (ft)\n0;100\n1000;50\n"), "names no unit beside 'Elev (ft)'");
    EXPECT_PRED2(contains, refusal("Dist (yd);Elev (yd)\n0;100\n1000;50\n"), "--unit");
    EXPECT_PRED2(contains, refusal("All values in feet\nDist;Elev\n0;100\n1000;50\n"), "speaks of feet");
    EXPECT_PRED2(contains, read("Dist (ft);Elev (m)\n0;100\n1000;50\n").read_as,
                 "chainage in feet (0.3048 m), elevation in metres");
}

TEST_F(SectionTable, StationsOfAThousandMetresOrAHundredFeet) {
    said_of_slope("Station;Elev\n0+000;32\n0+030;32\n0+041.547;12\n0+201.547;12\n");
    said_of_slope("Station;Elev\nKm 0+000,0;32\nKm 0+030,0;32\nKm 0+041,547;12,0\nKm 0+201,547;12\n");
    EXPECT_EQ(read("Sta (ft);Elev (ft)\n12+00;100\n12+50.5;50\n").points[1].x(), 1250.5 * 0.3048);
    EXPECT_EQ(read("Sta;Elev\n12+00;100\n12+50;50\n", {.unit = "ft"}).points[1].x(), 1250 * 0.3048);
    EXPECT_EQ(read("Sta;Elev\n1+234.56;100\n1+240;50\n").points[0].x(), 1234.56);
    EXPECT_EQ(read("Sta;Elev\n-0+050;100\n0+010;50\n").points[0].x(), -50);
    EXPECT_PRED2(contains, refusal("Sta;Elev\n12+00;100\n12+50;50\n"), "--unit ft");
    EXPECT_PRED2(contains, refusal("Sta (m);Elev (m)\n12+00;100\n12+50;50\n"), "--unit ft");
    EXPECT_PRED2(contains, refusal("Sta (ft);Elev (ft)\n1+234;100\n1+250;50\n"), "is a station of 1000");
    EXPECT_PRED2(contains, refusal("Sta;Elev\n0+234;100\n250;50\n"),
                 "line 3: Sta = 250: is not written as the stations");
}

// ---- order

TEST_F(SectionTable, AWalkTheOtherWayIsReversed) {
    EXPECT_PRED2(contains, said_of_slope("chainage_m,elevation_m\n201.547,12\n41.547,12\n30,32\n0,32\n"),
                 "rows reversed as their chainage falls");
    EXPECT_EQ(read("d;z\n9;1\n5;1\n5;4\n0;4\n").points, (std::vector<Vec2>{{0, 4}, {5, 4}, {5, 1}, {9, 1}}));
    EXPECT_PRED2(contains, refusal("d;z\n9;1\n5;1\n7;2\n0;4\n"), "line 4: d = 7: rises behind 5");
    EXPECT_PRED2(contains, refusal("d;z\n0;4\n7;2\n5;1\n9;1\n"), "line 4: d = 5: goes back behind 7");
}

// ---- holes

TEST_F(SectionTable, HolesAreNeverBridged) {
    for (const char* hole :
         {"-9999", "-9999.0", "-99999", "-32768", "-32767", "1e20", "3.4e38", "-3.4028235e+38",
          "#N/A",  "#NV",     "#WERT!", "#REF!",  "####",   "NaN",  "nan",    "null",
          "-",     "--",      "*",      "",       "n/a",    "inf",  "-999",   "none",
          "9999",  "-501",    "9001",   "2100"}) {
        for (const std::string before : {"Dist;Elev;Note\n0;32;\n", "0;32\n"}) {
            const bool noted = before.starts_with("Dist");
            const std::string error =
                refusal(before + "30;" + hole + (noted ? ";x" : ";") + "\n41.547;12\n201.547;12\n");
            EXPECT_PRED2(contains, error, noted ? "line 3" : "line 2") << hole;
            EXPECT_PRED2(contains, error, hole);
        }
        EXPECT_PRED2(contains, refusal(std::string("Dist;Elev\n0;") + hole + "\n30;12\n201.547;12\n"), "line")
            << hole;
        EXPECT_PRED2(contains, refusal(std::string("0;") + hole + "\n30;12\n201.547;12\n"), "line") << hole;
    }
    EXPECT_PRED2(contains, refusal("Dist;Elev\n0;32\n;20\n201.547;12\n"), "line 3: Dist: is empty");
    EXPECT_PRED2(contains, refusal("Dist;Elev\tNote\n0;32\n;\tx\n201.547;12\n"), "line 3");
}

TEST_F(SectionTable, ElevationsThatNoGroundHas) {
    EXPECT_PRED2(contains, refusal("d;z\n0;10\n5;-600\n"), "line 3: chainage 5 m, elevation_m = -600");
    EXPECT_PRED2(contains, refusal("d;z\n0;8000\n5;6999\n"), "lies 1001 m below the point before it");
    EXPECT_EQ(read("d;z\n0;8000\n5;7000\n").points.size(), 2u);
    const SectionPoints of_a_map{{{0, 5}, {1, 5}, {2, -9999}}, {}, "dem.tif", {}, {}};
    EXPECT_PRED2(contains, input_error([&] { check_elevations(of_a_map); }),
                 "dem.tif: point 3, chainage 2 m, elevation_m = -9999");
}

// ---- files that are none

TEST_F(SectionTable, PathsThatAreNoFilesAreRefusedAtOnce) {
    const std::string pipe = folder_.file("pipe.csv");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_PRED2(contains, input_error([&] { read_section_table(pipe, {}); }), "pipe or a device");
    EXPECT_PRED2(contains, input_error([&] { read_section_table("/dev/zero", {}); }), "pipe or a device");
    EXPECT_PRED2(contains, input_error([&] { read_section_table(std::string("x.csv\0.png", 10), {}); }),
                 "zero byte");
    EXPECT_PRED2(contains, input_error([&] { read_section_table(folder_.path().string(), {}); }),
                 "is a directory");
    // A read that fails after the file was opened; opening it is left to root.
    EXPECT_NE(input_error([&] { read_section_table("/proc/self/mem", {}); }), "");
}

TEST_F(SectionTable, TooManyRowsAreRefusedWithTheLimit) {
    std::string text = "d;z\n";
    for (int i = 0; i < 1'000'001; ++i) text += "1;1\n";
    EXPECT_PRED2(contains, refusal(text), "more than 1000000 lines");
}

}  // namespace
