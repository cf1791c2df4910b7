// Places that a map gives: features near the section line, projected onto it.

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "gis/near_features.h"
#include "map_fixture.h"
#include "scene/case_file.h"
#include "scene/input_files.h"
#include "scene/scene.h"
#include "scene/section_cases.h"
#include "store/store.h"

namespace runout {
namespace {

/// WKT, name and kind; empty: not said.
struct Drawn {
    std::string wkt, name{}, kind{};
};

/// East along y = 816000, chainage 0 at x = 834000; the toe is at 22.5, the end at 125.
constexpr const char* eastward = "origin = [834000, 816000]\nbearing_deg = 90\ncrs = \"EPSG:2326\"\n";

class MapPlaces : public MapFiles {
  protected:
    std::string layer(const std::string& name, const std::vector<Drawn>& drawn,
                      const std::string& crs = "EPSG:2326", const char* driver = "GPKG") const {
        GDALDatasetUniquePtr data(GetGDALDriverManager()->GetDriverByName(driver)->Create(
            path(name).c_str(), 0, 0, 0, GDT_Unknown, nullptr));
        OGRSpatialReference reference = crs.empty() ? OGRSpatialReference() : test_reference(crs);
        OGRLayer* layer =
            data->CreateLayer("things", crs.empty() ? nullptr : &reference, wkbUnknown, nullptr);
        for (const char* field : {"name", "kind"}) {
            OGRFieldDefn text(field, OFTString);
            layer->CreateField(&text);
        }
        for (const Drawn& each : drawn) {
            OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(layer->GetLayerDefn()));
            if (!each.name.empty()) feature->SetField("name", each.name.c_str());
            if (!each.kind.empty()) feature->SetField("kind", each.kind.c_str());
            OGRGeometry* geometry = nullptr;
            OGRGeometryFactory::createFromWkt(each.wkt.c_str(), crs.empty() ? nullptr : &reference,
                                              &geometry);
            feature->SetGeometryDirectly(geometry);
            EXPECT_EQ(layer->CreateFeature(feature.get()), OGRERR_NONE);
        }
        return path(name);
    }

    CaseSpec spec(const std::string& more, const std::string& placing = eastward,
                  const std::string& section = "0,20\n15,20\n22.5,0\n125,0\n") const {
        write("section.csv", "chainage_m,elevation_m\n" + section);
        return read_case(
            write("case.toml", "[section]\nfile = \"section.csv\"\n" + placing +
                                   "[source]\ntype = \"B\"\nbase_angle_deg = 35\nscarp_angle_deg = 80\n"
                                   "height_m = 7.5\ndrop_height_m = 15\n[material]\n"
                                   "friction_angle_deg = 38\n[run]\nresolution = 10\n" +
                                   more));
    }

    Scene scene(const std::string& more) const { return make_scene(spec(more)); }

    std::string refusal(const std::string& more, const std::string& placing = eastward) const {
        return error_of([&] { make_scene(spec(more, placing)); });
    }
};

constexpr const char* things = "[places]\nfile = \"things.gpkg\"\n";
const std::string house =
    "POLYGON ((834040 816005, 834050 816005, 834050 816015, 834040 816015, 834040 816005))";

// ---- where they lie

TEST_F(MapPlaces, LieWhereTheyProjectOntoTheSection) {
    layer("things.gpkg",
          {{"POINT (834060 816010)", "tap"},
           {house, "house", "building"},
           {"LINESTRING (834060 815980, 834100 816020)", "road", "road"},
           {"LINESTRING (834090 816020, 834095 816020)", "fence"},
           {"POINT (834060 816080)", "far"},
           {"POLYGON ((834030 816100, 834100 816100, 834100 816010, 834030 816100))", "hall"}});
    const std::vector<Place> places = scene(things).places;
    ASSERT_EQ(places.size(), 5U);
    const auto is = [&](std::size_t i, const char* name, double chainage, double width, double tolerance) {
        EXPECT_EQ(places[i].name, name);
        EXPECT_NEAR(places[i].x, chainage - 22.5, tolerance) << name;
        EXPECT_NEAR(places[i].width, width, tolerance) << name;
    };
    is(0, "house", 40, 10, 1e-6);
    is(1, "tap", 60, 0, 1e-6);
    const double cut = 30 + 70 * 50.0 / 90;  // of its edge, 50 m from the line
    is(2, "hall", cut, 100 - cut, 1e-6);
    is(3, "road", 80, 0, 1e-6);  // where it crosses, and not 50 m to either side of that
    is(4, "fence", 90, 5, 1e-6);
    EXPECT_EQ(places[0].kind, "building");
    EXPECT_EQ(places[1].kind, "");
    EXPECT_TRUE(make_scene(spec(things)).profile.doubts.empty());
    EXPECT_EQ(scene(std::string(things) + "max_offset_m = 9\n").places.size(), 2U) << "house and road";
    EXPECT_EQ(scene(std::string(things) + "where = \"kind = 'road'\"\nlayer = \"things\"\n").places.size(),
              1U);
}

TEST_F(MapPlaces, HaveTheirNearEdgeTowardsTheCutOfAMirroredSection) {
    layer("things.gpkg", {{house, "house"}});
    const Scene mirrored = make_scene(spec(things, eastward, "0,0\n102.5,0\n110,20\n125,20\n"));
    ASSERT_EQ(mirrored.places.size(), 1U);
    EXPECT_NEAR(mirrored.places[0].x, 102.5 - 50, 1e-6);
    EXPECT_NEAR(mirrored.places[0].width, 10, 1e-6);
}

TEST_F(MapPlaces, FollowTheBendsOfALineAndGoOnStraightBeyondItsEnds) {
    const MapLine line{test_wkt(), {{834000, 816000}, {834100, 816000}, {834100, 815900}}, {0, 100, 200}, {}};
    const std::string file =
        layer("things.gpkg",
              {{"POINT (834050 816020)", "first"},
               {"POINT (834130 815950)", "second"},
               {"POINT (833970 816010)", "before"},
               {"POINT (834100 815870)", "after"},
               {"POINT (833930 816000)", "too far before"},
               {"POLYGON ((833000 817000, 835000 817000, 835000 815000, 833000 815000, 833000 817000))",
                "district"}});
    const std::vector<NearFeature> near = features_near(line, {.file = file, .max_offset_m = 40});
    ASSERT_EQ(near.size(), 5U);
    EXPECT_NEAR(near[0].from_m, 50, 1e-6);
    EXPECT_NEAR(near[1].from_m, 150, 1e-6);
    EXPECT_NEAR(near[2].from_m, -30, 1e-6);
    EXPECT_NEAR(near[3].from_m, 230, 1e-6);
    EXPECT_EQ(near[4].name, "district");
    EXPECT_NEAR(near[4].from_m, -40, 1e-6);
    EXPECT_NEAR(near[4].to_m, 240, 1e-6);
}

TEST_F(MapPlaces, ComeFromAnotherCoordinateSystem) {
    OGRSpatialReference grid = test_reference("EPSG:2326"), degrees = test_reference("EPSG:4326");
    const std::unique_ptr<OGRCoordinateTransformation> there(
        OGRCreateCoordinateTransformation(&grid, &degrees));
    double x = 834060, y = 816010;
    ASSERT_TRUE(there->Transform(1, &x, &y));
    layer("things.geojson", {{fmt::format("POINT ({:.12f} {:.12f})", x, y), "tap"}}, "EPSG:4326", "GeoJSON");
    const std::vector<Place> places = scene("[places]\nfile = \"things.geojson\"\n").places;
    ASSERT_EQ(places.size(), 1U);
    EXPECT_NEAR(places[0].x, 60 - 22.5, 1e-3);
}

TEST_F(MapPlaces, OfALayerOfSectionsAreThoseOfEachLine) {
    TestRaster raster{.size = 0.5, .columns = 300, .rows = 300};
    raster.left = 833990;
    raster.top = 816050;
    raster.elevation = [](double x, double) { return std::clamp(20 - (x - 834015) / 7.5 * 20, 0.0, 20.0); };
    write_raster("dem.tif", raster);
    write_lines("lines.gpkg", "EPSG:2326",
                {"LINESTRING (834000 816000, 834125 816000)", "LINESTRING (834000 815950, 834125 815950)"});
    layer("things.gpkg", {{"POINT (834060 816010)", "north"}, {"POINT (834070 815940)", "south"}});
    CaseSpec all = spec(std::string(things) + "max_offset_m = 20\n", "");
    all.section = {};
    all.section.map.raster = path("dem.tif");
    all.section.map.line.file = path("lines.gpkg");
    all.given.erase("section.file");
    all.given["section.line"] = {};
    all.given["section.raster"] = {};
    const std::vector<SectionCase> cases = section_cases(all);
    ASSERT_EQ(cases.size(), 2U);
    const std::vector<Place> first = make_scene(cases[0].spec).places,
                             second = make_scene(cases[1].spec).places;
    ASSERT_EQ(first.size(), 1U);
    ASSERT_EQ(second.size(), 1U);
    EXPECT_EQ(first[0].name, "north");
    EXPECT_EQ(second[0].name, "south");
    EXPECT_NEAR(second[0].x - first[0].x, 10, 1e-6);
}

// ---- what they are called, and what they are to the question

TEST_F(MapPlaces, GetNamesThatTellThemApart) {
    layer("things.gpkg", {{"POINT (834040 816000)", "house"},
                          {"POINT (834050 816000)", "house"},
                          {"POINT (834060 816000)"},
                          {"POINT (834070 816000)", "shed"},
                          {"POINT (834080 816000)", "hut", "wood"}});
    const std::vector<Place> places =
        scene(std::string("[[place]]\nname = \"shed\"\nchainage_m = 90\n") + things).places;
    ASSERT_EQ(places.size(), 6U);
    const auto names = [&] {
        std::string all;
        for (const Place& place : places) all += place.name + "|";
        return all;
    };
    EXPECT_EQ(names(), "shed|house (1)|house (2)|feature 3|shed (4)|hut|");
    EXPECT_EQ(scene(std::string(things) + "name_field = \"KIND\"\nkind_field = \"name\"\n").places.at(4).name,
              "wood");
}

TEST_F(MapPlaces, ArePartOfTheIdentityAsThePlacesOfACaseAre) {
    layer("things.gpkg", {{house, "house", "building"}});
    CaseSpec with_map = spec(things);
    const std::vector<std::string> files = input_files(with_map);
    EXPECT_NE(std::ranges::find(files, path("things.gpkg")), files.end()) << "no output may replace it";
    const Scene from_map = make_scene(with_map);
    Scene from_case =
        scene("[[place]]\nname = \"house\"\nkind = \"building\"\nchainage_m = 40\nwidth_m = 10\n");
    EXPECT_NE(scenario_hash(from_map), scenario_hash(scene("")));
    from_case.places.at(0).x = from_map.places.at(0).x;  // the last digits
    from_case.places.at(0).width = from_map.places.at(0).width;
    EXPECT_EQ(scenario_hash(from_map), scenario_hash(from_case));
}

// ---- what is left out, and what is refused

TEST_F(MapPlaces, ThatTheRunSaysNothingOfAreLeftOutAndTold) {
    layer("things.gpkg", {{"POINT (834060 816010)", "tap"},
                          {"POINT (834150 816000)", "beyond"},
                          {"POINT (834001 816000)", "uphill"},
                          {"POINT (833980 816000)", "before"}});
    const Scene made = scene(things);
    ASSERT_EQ(made.places.size(), 1U);
    ASSERT_EQ(made.profile.doubts.size(), 1U);
    EXPECT_TRUE(has_part(made.profile.doubts[0], "are left out: beyond, uphill, before."));
    const Scene none = scene(std::string(things) + "where = \"name = 'nobody'\"\n");
    ASSERT_EQ(none.profile.doubts.size(), 1U);
    EXPECT_TRUE(has_part(none.profile.doubts[0], "is within 50 m of the section line."));
}

/// A town beside a cut must not stop its run.
TEST_F(MapPlaces, ThatReachIntoTheSourceOrOverTheEndAreCutAndTold) {
    layer("things.gpkg",
          {{"POLYGON ((834005 816000, 834060 816000, 834060 816010, 834005 816000))", "mansion"},
           {"POLYGON ((834120 816000, 834130 816000, 834130 816010, 834120 816000))", "mill"}});
    const Scene made = scene(things);
    ASSERT_EQ(made.places.size(), 2U);
    const double source_end =
        std::ranges::max(made.source.outline, {}, [](const Vec2& p) { return p.x(); }).x();
    EXPECT_NEAR(made.places[0].x, source_end, 1e-6);
    EXPECT_NEAR(made.places[1].x + made.places[1].width, made.profile.ground.back().x(), 1e-6);
    ASSERT_EQ(made.profile.doubts.size(), 1U);
    EXPECT_TRUE(has_part(made.profile.doubts[0], "to the end of the section only: mansion, mill."));
}

TEST_F(MapPlaces, ThatCannotBeAreWrongInput) {
    const std::string file = things;
    EXPECT_TRUE(has_part(refusal(file), "there is no such file"));
    EXPECT_TRUE(has_part(refusal("[places]\nfile = \"/vsicurl/http://example.com/things.gpkg\"\n"),
                         "is not a file on this machine"));
    layer("things.gpkg", {{house, "house"}});
    EXPECT_TRUE(has_part(refusal(file, ""), "places.file")) << refusal(file, "");
    EXPECT_TRUE(has_part(refusal(file, ""), "needs a section that lies on a map"));
    EXPECT_TRUE(has_part(refusal(file + "name_field = \"title\"\n"), "places.name_field = title"));
    EXPECT_TRUE(has_part(refusal(file + "name_field = \"title\"\n"), "name one of name, kind"));
    EXPECT_TRUE(has_part(refusal(file + "kind_field = \"title\"\n"), "places.kind_field = title"));
    EXPECT_TRUE(has_part(refusal(file + "layer = \"others\"\n"), "is not a layer of this file"));
    EXPECT_TRUE(has_part(refusal(file + "where = \"title = 3\"\n"), "is not a condition"));
    EXPECT_TRUE(has_part(refusal(file + "max_offset_m = 0\n"), "places.max_offset_m"));
    EXPECT_TRUE(has_part(refusal("[places]\nlayer = \"things\"\n"), "needs places.file"));
    layer("lost.shp", {{"POINT (834060 816010)", "tap"}}, "", "ESRI Shapefile");
    EXPECT_TRUE(has_part(refusal("[places]\nfile = \"lost.shp\"\n"), "names no coordinate system"));
    EXPECT_EQ(scene("[places]\nfile = \"lost.shp\"\ncrs = \"EPSG:2326\"\n").places.size(), 1U);
    write("grid.geojson", R"({"type": "Feature", "properties": {}, "geometry": {"type": "Point",
          "coordinates": [834060, 816010]}})");
    EXPECT_TRUE(has_part(refusal("[places]\nfile = \"grid.geojson\"\n"), "are not in degrees"));
    layer("long.gpkg", {{"POINT (834060 816010)", std::string(1001, 'a')}});
    EXPECT_TRUE(has_part(refusal("[places]\nfile = \"long.gpkg\"\n"), "has a name of 1001 bytes"));
}

// A bow tie has no area that GEOS would cut.
TEST_F(MapPlaces, OfAPolygonThatCrossesItselfAreMended) {
    layer("things.gpkg",
          {{"POLYGON ((834040 816000, 834050 816010, 834050 816000, 834040 816010, 834040 816000))",
            "bow tie"}});
    const std::vector<Place> places = scene(things).places;
    ASSERT_EQ(places.size(), 1U);
    EXPECT_NEAR(places[0].x, 40 - 22.5, 1e-6);
    EXPECT_NEAR(places[0].width, 10, 1e-6);
}

}  // namespace
}  // namespace runout
