// LandXML, and lines in a local system; and that a section is the same whatever format it comes in.

#include "drawn_files.h"
#include "gis/drawn_geometry.h"
#include "map_fixture.h"
#include "profile/section_file.h"
#include "random_sections.h"
#include "said.h"
#include "scene/case_file.h"
#include "scene/read_ground.h"
#include "scene/scene.h"
#include "scene/section_cases.h"

namespace runout {
namespace {

const Polyline cut{{0, 32}, {30, 32}, {41.547, 12}, {201.547, 12}};

class SectionFormats : public MapFiles {
  protected:
    SectionPoints landxml(const std::string& text, const LandXmlChoice& choice = {}) const {
        return read_section_file(write("section.xml", text), {.unit = choice.unit, .landxml = choice})
            .section;
    }
    [[nodiscard]] std::string refusal(const std::string& text, const LandXmlChoice& choice = {}) const {
        return input_error([&] { landxml(text, choice); });
    }
    [[nodiscard]] static std::string wkt(const Polyline& points) {
        std::string text;
        for (const Vec2& p : points)
            text += fmt::format("{}{:.17g} {:.17g}", text.empty() ? "" : ", ", p.x(), p.y());
        return "LINESTRING (" + text + ")";
    }
};

std::string one_surface(const Polyline& points) {
    return landxml_text(metric_units, cross_section("20", surface_text("EG", {points})));
}

// ---- LandXML

TEST_F(SectionFormats, ACrossSectionIsItsOffsetsAndElevations) {
    const SectionPoints read = landxml(one_surface(cut));
    EXPECT_EQ(read.points, cut);
    EXPECT_EQ(read.read_as,
              "read as: cross-section at station 20, surface EG, alignment A; offset = chainage, in metres");
    EXPECT_EQ(read.lines, std::vector<int>(4, 7));
}

TEST_F(SectionFormats, ALongProfileIsASectionToo) {
    const SectionPoints read =
        landxml(landxml_text(metric_units, "<Profile name=\"P\"><ProfSurf name=\"EG\"><PntList2D>" +
                                               pairs_text(cut) + "</PntList2D></ProfSurf></Profile>"));
    EXPECT_EQ(read.points, cut);
    EXPECT_TRUE(contains(read.read_as, "long profile, surface EG"));
}

TEST_F(SectionFormats, FeetAreOfEitherKind) {
    const auto factor = [&](const std::string& unit) {
        const std::string units = "<Units><Imperial linearUnit=\"" + unit + "\"/></Units>";
        const SectionPoints read =
            landxml(landxml_text(units, cross_section("1", surface_text("EG", {{{0, 1000}, {3000, 500}}}))));
        return read.points[1].x() / 3000;
    };
    EXPECT_DOUBLE_EQ(factor("foot"), 0.3048);
    EXPECT_DOUBLE_EQ(factor("USSurveyFoot"), 1200.0 / 3937.0);
    EXPECT_TRUE(contains(input_error([&] { factor("furlong"); }), "linearUnit = furlong"));
    EXPECT_TRUE(contains(refusal(landxml_text("", cross_section("1", surface_text("EG", {cut})))),
                         "names no linear unit"));
    EXPECT_EQ(landxml(landxml_text("", cross_section("1", surface_text("EG", {cut}))), {.unit = "m"}).points,
              cut);
}

TEST_F(SectionFormats, SeveralSectionsAreListedAndChosen) {
    Polyline lower = cut;
    for (Vec2& p : lower) p.y() -= 5;
    const std::string text =
        landxml_text(metric_units, "<CrossSects><CrossSect sta=\"20\">" + surface_text("EG", {lower}) +
                                       surface_text("FG", {cut}) + "</CrossSect><CrossSect sta=\"1040.5\">" +
                                       surface_text("EG", {cut}) + "</CrossSect></CrossSects>");
    EXPECT_TRUE(contains(refusal(text), "section.station: must be said"));
    EXPECT_TRUE(contains(refusal(text), "give one of 20, 1040.5"));
    EXPECT_EQ(landxml(text, {.station = "1040.500"}).points, cut);
    EXPECT_EQ(landxml(text, {.station = "1+040.5"}).points, cut);
    EXPECT_EQ(landxml(text, {.station = "10+40.5"}).points, cut);
    EXPECT_TRUE(contains(refusal(text, {.station = "30"}), "section.station = 30: is not in the file"));
    EXPECT_TRUE(contains(refusal(text, {.station = "20"}), "give one of EG, FG"));
    EXPECT_EQ(landxml(text, {.station = "20", .surface = "FG"}).points, cut);
    EXPECT_EQ(landxml(text, {.station = "20", .surface = "EG"}).points, lower);
}

TEST_F(SectionFormats, PartsOfASurfaceAreJoinedAndHolesAreNot) {
    const Polyline left{cut[0], cut[1]};
    const Polyline middle{cut[1], cut[2]};
    const Polyline right{cut[2], cut[3]};
    const auto text = [](const std::vector<Polyline>& parts) {
        return landxml_text(metric_units, cross_section("20", surface_text("EG", parts)));
    };
    EXPECT_EQ(landxml(text({right, left, middle})).points, cut);
    EXPECT_TRUE(contains(refusal(text({left, right})), "has a gap between (30, 32) and (41.547, 12)"));
    const std::string hole = refusal(one_surface({{0, 32}, {30, -9999}, {41.547, 12}}));
    EXPECT_TRUE(contains(hole, "-9999"));
    EXPECT_TRUE(contains(hole, "line 7"));
}

TEST_F(SectionFormats, SectionsFromRightToLeftAndRepeatedPointsAreTaken) {
    EXPECT_EQ(landxml(one_surface({cut.rbegin(), cut.rend()})).points, cut);
    EXPECT_EQ(landxml(one_surface({cut[0], cut[1], cut[1], cut[2], cut[3], cut[3]})).points, cut);
}

TEST_F(SectionFormats, OtherEncodingsAndPrefixesAreXmlToo) {
    std::string prefixed = one_surface(cut);
    for (std::size_t at = 0; (at = prefixed.find('<', at)) != std::string::npos; ++at)
        if (prefixed[at + 1] != '?') prefixed.insert(prefixed[at + 1] == '/' ? at + 2 : at + 1, "lx:");
    EXPECT_EQ(landxml(prefixed).points, cut);
    std::string wide = "\xFF\xFE";
    const std::string plain = one_surface(cut);
    for (const char c : plain.substr(plain.find("<Land"))) wide += {c, '\0'};
    EXPECT_EQ(landxml(wide).points, cut);
    EXPECT_EQ(landxml("\xEF\xBB\xBF" + one_surface(cut)).points, cut);
}

TEST_F(SectionFormats, BrokenXmlIsRefusedWithItsLine) {
    const std::string whole = one_surface(cut);
    EXPECT_TRUE(contains(refusal(whole.substr(0, whole.find("</CrossSect>"))), "is not well-formed XML"));
    EXPECT_TRUE(contains(refusal("<kml/>"), "is XML of another kind (kml)"));
    EXPECT_TRUE(contains(refusal(landxml_text(metric_units, "")), "has no cross-section"));
    const auto list = [](const std::string& numbers) {
        return landxml_text(metric_units,
                            cross_section("1", "<CrossSectSurf name=\"EG\"><PntList2D>0 32\n30 " + numbers +
                                                   "</PntList2D></CrossSectSurf>"));
    };
    EXPECT_TRUE(contains(refusal(list("32 41.5")), "line 7: PntList2D: has an odd count of numbers"));
    EXPECT_TRUE(contains(refusal(list("32,5 40 12")), "PntList2D = 32,5: is not a number"));
    EXPECT_TRUE(contains(refusal(list("nan 40 12")), "section.xml"));
    EXPECT_TRUE(contains(refusal(std::string(200000, '<')), "section.xml"));
}

TEST_F(SectionFormats, AFileOfManySectionsIsReadInATimeThatGrowsWithIt) {
    std::string stations = "<CrossSects>";
    for (int i = 0; i < 20000; ++i)
        stations += fmt::format("<CrossSect sta=\"{}\">{}</CrossSect>\n", i, surface_text("EG", {cut}));
    EXPECT_EQ(landxml(landxml_text(metric_units, stations + "</CrossSects>"), {.station = "19999"}).points,
              cut);
}

// ---- lines in a local system

TEST_F(SectionFormats, AFlatLineWithoutASystemIsASection) {
    for (const auto& [name, driver] :
         {std::pair{"local.gpkg", "GPKG"}, std::pair{"local.shp", "ESRI Shapefile"}}) {
        const std::string file = write_lines(name, "", {wkt(cut)}, driver);
        const CaseSpec spec = read_case(file);
        EXPECT_TRUE(spec.has("section.line")) << name;
        const Profile profile = make_ground(spec);
        ASSERT_EQ(profile.ground.size(), cut.size()) << name;
        EXPECT_NEAR(profile.toe_chainage_m, 41.547, 1e-9);
        EXPECT_FALSE(profile.map_line.has_value());
        EXPECT_TRUE(contains(profile.read_as, "x = chainage and y = elevation"));
        EXPECT_EQ(section_cases(spec).size(), 1u);
        EXPECT_EQ(read_section_file(file, {}).section.points, cut);
    }
}

TEST_F(SectionFormats, GeoJsonIsLocalOnlyAsASectionFile) {
    const auto json = [&](const std::string& name, const std::string& coordinates) {
        return write(name, R"({"type": "Feature", "properties": {}, "geometry": {"type": "LineString",
            "coordinates": )" + coordinates +
                               "}}");
    };
    const std::string local = json("local.geojson", "[[0, 32], [30, 32], [41.547, 12], [201.547, 12]]");
    EXPECT_EQ(read_section_file(local, {}).section.points, cut);
    EXPECT_TRUE(is_on_map(read_case(local).section));
    const std::string degrees = json("degrees.geojson", "[[114.1, 22.3], [114.102, 22.301]]");
    EXPECT_TRUE(contains(input_error([&] { read_section_file(degrees, {}); }), "lies on the map, in WGS 84"));
}

TEST_F(SectionFormats, ALineOnTheMapStaysOne) {
    EXPECT_TRUE(is_on_map(read_case(write_lines("map.gpkg", "EPSG:2326", {across})).section));
    // Without a system and with elevations it is a map line whose system is missing.
    const std::string high =
        write_lines("high.shp", "", {"LINESTRING Z (0 0 32, 30 0 32, 41 0 12, 200 0 12)"}, "ESRI Shapefile");
    EXPECT_TRUE(contains(input_error([&] { make_ground(read_case(high)); }), "section.line_crs"));
    // So is a drawing that is named as one.
    CaseSpec plan;
    override_value(plan, "section.line", write("plan.dxf", DxfText().polyline("g", cut).whole()), "--set");
    EXPECT_TRUE(is_on_map(plan.section));
    // With a raster or a system given, a line without one is a plan.
    CaseSpec spec = read_case(write_lines("plan.shp", "", {across}, "ESRI Shapefile"));
    EXPECT_TRUE(contains(input_error([&] { make_ground(spec); }), "is the elevation of no ground"));
    override_value(spec, "section.raster", write_raster("z.tif", plane_raster()), "--raster");
    EXPECT_TRUE(contains(input_error([&] { make_ground(spec); }), "section.line_crs"));
    override_value(spec, "section.line_crs", "EPSG:2326", "--set");
    EXPECT_TRUE(make_ground(spec).map_line.has_value());
}

TEST_F(SectionFormats, KeysOfTheMapHaveNoEffectOnALocalSection) {
    CaseSpec spec = read_case(write_lines("local.gpkg", "", {wkt(cut)}));
    override_value(spec, "section.elevation_unit", "ft", "--set");
    EXPECT_TRUE(contains(input_error([&] { make_ground(spec); }), "section.unit is the unit of both"));
    CaseSpec feet = read_case(path("local.gpkg"));
    override_value(feet, "section.unit", "ft", "--unit");
    EXPECT_NEAR(make_ground(feet).toe_chainage_m, 41.547 * 0.3048, 1e-9);
}

TEST_F(SectionFormats, MorePointsThanASectionHasAreRefused) {
    DrawnPointCount count("section.dxf");
    count.add(most_drawn_points);
    EXPECT_TRUE(contains(input_error([&] { count.add(1); }), "section.dxf: has more than 1000000 points"));
}

TEST_F(SectionFormats, LinesOfALocalLayerAreJoined) {
    EXPECT_EQ(make_ground(read_case(write_lines("parts.gpkg", "",
                                                {wkt({cut[3], cut[2]}), wkt({cut[0], cut[1], cut[2]})})))
                  .ground.size(),
              4u);
    CaseSpec two =
        read_case(write_lines("two.gpkg", "", {wkt(cut), wkt({{0, 20}, {10, 20}, {20, 5}, {99, 5}})}));
    EXPECT_TRUE(contains(input_error([&] { make_ground(two); }), "one above the other"));
    override_value(two, "section.where", "name = 'B'", "--where");
    EXPECT_NEAR(make_ground(two).toe_chainage_m, 20, 1e-9);
}

// ---- every format alike

TEST_F(SectionFormats, ASectionIsTheSameInEveryFormat) {
    RandomSections sections(7);
    for (int k = 0; k < 25; ++k) {
        const Polyline section = sections.next();
        const SectionPoints table = read_section_file(write("s.csv", csv_text(section)), {}).section;
        EXPECT_EQ(table.points, section);
        const std::string file = write_lines(fmt::format("s{}.gpkg", k), "", {wkt(section)});
        const std::string shape =
            write_lines(fmt::format("s{}.shp", k), "", {wkt(section)}, "ESRI Shapefile");
        for (const std::string& other :
             {write("r12.dxf", DxfText(DxfText::Release::r12).polyline("g", section).whole()),
              write("r2000.dxf", DxfText().polyline("g", section).whole()),
              write("s.xml", one_surface(section)), file, shape})
            ASSERT_EQ(read_section_file(other, {}).section.points, table.points) << other << ' ' << k;
        // One and the same profile follows.
        EXPECT_EQ(make_ground(read_case(path("r12.dxf"))).ground,
                  make_ground(read_case(path("s.csv"))).ground);
    }
}

}  // namespace
}  // namespace runout
