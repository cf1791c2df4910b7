// Lines that carry their own elevations, in true metres: what is missing is never taken for 0, and a wall
// stays a wall.

#include <fmt/format.h>

#include <cmath>

#include "core/units.h"
#include "map_fixture.h"

namespace runout {
namespace {

std::string field_file(const std::string& name) {
    return std::string(RUNOUT_SOURCE_DIR) + "/tests/field/" + name;
}

Profile line_profile(const std::string& file) {
    return read_map_section({.line = {.file = file}}, {});
}

class MapLines : public MapFiles {
  protected:
    /// A GeoJSON line in the Hong Kong 1980 Grid.
    [[nodiscard]] std::string json_line(const std::string& name, const std::string& coordinates,
                                        const std::string& kind = "LineString") const {
        return write(name, R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":)"
                           R"("urn:ogc:def:crs:EPSG::2326"}},"features":[{"type":"Feature","properties":{},)"
                           R"("geometry":{"type":")" +
                               kind + R"(","coordinates":)" + coordinates + "}}]}");
    }
    [[nodiscard]] std::string json_error(const std::string& coordinates,
                                         const std::string& kind = "LineString") const {
        return section_error({.line = {.file = json_line("line.geojson", coordinates, kind)}});
    }
    [[nodiscard]] std::string wkt_error(const std::string& wkt, const char* driver = "GPKG") const {
        static int count = 0;
        return section_error({.line = {.file = write_lines(fmt::format("w{}.{}", count++, driver),
                                                           "EPSG:2326", {wkt}, driver)}});
    }
};

// ---- missing elevations

TEST_F(MapLines, AVertexWithoutElevationIsNamed) {
    EXPECT_TRUE(
        has_part(section_error({.line = {.file = field_file("z-missing.geojson")}}),
                 "feature 0, vertex 4 of 5 = (834120, 815900): has no elevation; give it one, or give "
                 "section.raster"));
}

TEST_F(MapLines, AMissingElevationIsFoundWhereverItStands) {
    const std::vector<std::string> places = {"834000,815900", "834030,815900", "834041,815900",
                                             "834120,815900"};
    const auto coordinates = [&](std::size_t missing, const std::string& third) {
        std::string text = "[";
        for (std::size_t i = 0; i < places.size(); ++i)
            text += (i > 0 ? ",[" : "[") + places[i] + (i == missing ? third : ",12.5") + "]";
        return text + "]";
    };
    for (std::size_t missing = 0; missing < places.size(); ++missing) {
        const std::string line = coordinates(missing, "");
        const std::string vertex = fmt::format("vertex {} of 4", missing + 1);
        for (const std::string& said : {json_error(line), json_error("[" + line + "]", "MultiLineString")}) {
            EXPECT_TRUE(has_part(said, vertex)) << line;
            EXPECT_TRUE(has_part(said, "has no elevation; give it one"));
        }
        EXPECT_NE(json_error(coordinates(missing, ",null")), "no error") << "GDAL drops such a line";
    }
}

TEST_F(MapLines, MissingElevationsDoNotMatterWhereARasterIsSampled) {
    const std::string raster = write_raster("z.tif", plane_raster());
    const std::string line =
        json_line("line.geojson", "[[834021,815901,7],[834200,815901],[834341,815901,0]]");
    EXPECT_EQ(section_error({.raster = raster, .line = {.file = line}}), "no error");
}

TEST_F(MapLines, AnElevationOfZeroThatIsWrittenIsOne) {
    // At the level end, where a local datum has its 0.
    EXPECT_EQ(json_error("[[834000,815900,20],[834030,815900,20],[834041,815900,0],[834120,815900,0]]"),
              "no error");
}

TEST_F(MapLines, ValuesThatStandForNoDataAreRefused) {
    for (const char* driver : {"GPKG", "ESRI Shapefile"})
        for (const std::string bad :
             {"-9999", "-99999", "-32768", "1e20", "-3.4e38", "99999", "-501", "9001"}) {
            const std::string said = wkt_error(
                "LINESTRING Z (834000 815900 30,834020 815900 " + bad + ",834130 815900 10)", driver);
            EXPECT_TRUE(has_part(said, "vertex 2 of 3 = (834020, 815900): has ")) << driver << bad;
            EXPECT_TRUE(has_part(said, "which is no elevation between -500 and 9000 m"));
        }
    const std::string with_nan = write_lines("nan.gpkg", "EPSG:2326", {});
    {
        const GDALDatasetUniquePtr data(GDALDataset::Open(with_nan.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
        OGRLineString line;
        line.addPoint(834000, 815900, 30);
        line.addPoint(834020, 815900, std::nan(""));
        line.addPoint(834130, 815900, 10);
        OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(data->GetLayer(0)->GetLayerDefn()));
        feature->SetGeometry(&line);
        ASSERT_EQ(data->GetLayer(0)->CreateFeature(feature.get()), OGRERR_NONE);
    }
    EXPECT_TRUE(
        has_part(section_error({.line = {.file = with_nan}}), "vertex 2 of 3 = (834020, 815900): has "));
}

TEST_F(MapLines, ALoneZeroIsRefusedUnlessItIsSaidToBeGround) {
    const std::string lone =
        "LINESTRING Z (834000 815900 30,834020 815900 0,834030 815900 10,834130 815900 10)";
    EXPECT_TRUE(
        has_part(wkt_error(lone),
                 "vertex 2 of 4 = (834020, 815900): has the elevation 0 among others far from it, as where "
                 "one is missing; mend it, or say section.zero_elevation = \"ground\""));
    EXPECT_TRUE(has_part(
        wkt_error("LINESTRING Z (834000 815900 30,834020 815900 30,834030 815900 10,834130 815900 0)"),
        "vertex 4 of 4"));
    EXPECT_TRUE(has_part(
        wkt_error("LINESTRING Z (834000 815900 30,834020 815900 0,834025 815900 0,834030 815900 10)"),
        "vertex 2 of 4"));
    EXPECT_EQ(
        section_error({.line = {.file = write_lines("z.gpkg", "EPSG:2326", {lone})}, .zero_is_ground = true}),
        "no error");
}

TEST_F(MapLines, GroundMayComeToZero) {
    for (const char* wkt : {"LINESTRING Z (834000 815900 30,834020 815900 0.8,834030 815900 0)",
                            "LINESTRING Z (834000 815900 20,834030 815900 0,834130 815900 0)",
                            "LINESTRING Z (834000 815900 20,834030 815900 0,834130 815900 -3)",
                            "LINESTRING Z (834000 815900 0.3,834030 815900 0,834130 815900 -30)"})
        EXPECT_EQ(wkt_error(wkt), "no error") << wkt;
}

TEST_F(MapLines, ALineOfZerosHasNoElevations) {
    EXPECT_TRUE(has_part(wkt_error("LINESTRING Z (834000 815900 0,834020 815900 0,834130 815900 0)"),
                         "has no elevations: all are 0; give section.raster"));
    EXPECT_TRUE(has_part(wkt_error("LINESTRING (834000 815900,834020 815900)"),
                         "has no elevations; give section.raster"));
}

TEST_F(MapLines, HeightsAboveTheGroundAreNoElevations) {
    const auto kml = [this](const std::string& mode, const std::string& heights) {
        return section_error(
            {.line = {
                 .file = write(
                     "line.kml",
                     R"(<?xml version="1.0"?><kml xmlns="http://www.opengis.net/kml/2.2"><Document><Placemark>)"
                     "<name>A</name><LineString>" +
                         mode + "<coordinates>8,47," + heights + " 8,46.9995," + heights +
                         " 8,46.998,12</coordinates></LineString></Placemark></Document></kml>")}});
    };
    const std::string clamped =
        "has no elevations, because its heights are clampToGround; give section.raster";
    EXPECT_TRUE(has_part(kml("", "32"), clamped));
    EXPECT_TRUE(has_part(kml("<altitudeMode>clampToGround</altitudeMode>", "0"), clamped));
    EXPECT_TRUE(has_part(kml("<altitudeMode>relativeToGround</altitudeMode>", "0"), "relativeToGround"));
    EXPECT_EQ(kml("<altitudeMode>absolute</altitudeMode>", "32"), "no error");
}

// ---- walls

TEST_F(MapLines, ARetainingWallKeepsItsFace) {
    const Profile profile = line_profile(field_file("wall-3d.geojson"));
    EXPECT_NEAR(profile.toe_chainage_m, 39.238, 1e-9);
    EXPECT_EQ(profile.toe_elevation_m, 12);
    EXPECT_NEAR(profile.ground[profile.crest].y(), 20, 1e-9);
    const Polyline expected{{-39.238, 20}, {-9.238, 20}, {0, 4}, {0, 0}, {161.762, 0}};
    ASSERT_EQ(profile.ground.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_LT((profile.ground[i] - expected[i]).norm(), 1e-9) << i;
}

TEST_F(MapLines, AWallIsKeptInDegreesAndInBothDirections) {
    for (const char* wkt : {"LINESTRING Z (8 47 32,8 46.9997 32,8 46.9996 16,8 46.9996 12,8 46.998 12)",
                            "LINESTRING Z (8 46.998 12,8 46.9996 12,8 46.9996 16,8 46.9997 32,8 47 32)"}) {
        const std::string file = write_lines("d.gpkg", "EPSG:4326", {wkt});
        const Profile profile = line_profile(file);
        EXPECT_EQ(profile.toe_elevation_m, 12);
        EXPECT_EQ(profile.ground[profile.toe - 1], Vec2(0, 4)) << wkt;
        std::filesystem::remove(file);
    }
}

// ---- true metres

TEST_F(MapLines, DegreesAndWebMercatorGiveTheSameLineInMetres) {
    for (const char* name : {"degrees.geojson", "web-mercator.geojson"}) {
        const Profile profile = line_profile(field_file(name));
        EXPECT_NEAR(profile.map_line->chainage_m.back(), 201.55, 0.02) << name;
        EXPECT_NEAR(degrees(profile.slope_angle), 60.0, 0.05) << name;
    }
}

/// A line of 200 m about a place, north-east, in another system, as WKT with elevations.
std::string line_about(double longitude, double latitude, const std::string& crs) {
    OGRSpatialReference local = test_reference("EPSG:4326");
    local.SetTM(latitude, longitude, 1, 0, 0);
    OGRSpatialReference target = test_reference(crs);
    const std::unique_ptr<OGRCoordinateTransformation> there(
        OGRCreateCoordinateTransformation(&local, &target));
    std::string wkt = "LINESTRING Z (";
    for (const double at : {0.0, 60.0, 80.0, 200.0}) {
        double x = at * std::sqrt(0.75);
        double y = at / 2;
        EXPECT_TRUE(there->Transform(1, &x, &y));
        wkt += fmt::format("{}{:.9f} {:.9f} {}", at > 0 ? "," : "", x, y, at < 70 ? 30 : 10);
    }
    return wkt + ")";
}

TEST_F(MapLines, MetresAreTrueWhateverTheScaleOfTheSystem) {
    struct Place {
        const char* crs;
        double longitude, latitude;
    };
    for (const auto& [crs, longitude, latitude] :
         {Place{"EPSG:3857", 8, 47},      // Mercator, 1.47
          Place{"EPSG:3857", 20, -65},    // 2.4
          Place{"EPSG:32632", 25, 47},    // UTM 16 deg outside of its zone
          Place{"EPSG:32632", 9, 47},     // and on its central meridian: 0.9996 is a grid that surveys use
          Place{"EPSG:3995", 20, 75},     // polar stereographic
          Place{"EPSG:32662", 8, 47},     // equirectangular: 1.47 to the east, 1 to the north
          Place{"EPSG:3035", 30, 65}}) {  // equal areas, stretched one way and shrunk the other
        const std::string file = write_lines("t.gpkg", crs, {line_about(longitude, latitude, crs)});
        const Profile profile = line_profile(file);
        EXPECT_NEAR(profile.map_line->chainage_m.back(), 200, 0.2)
            << crs << " at " << longitude << " " << latitude;
        EXPECT_NEAR(degrees(profile.slope_angle), 45, 0.06) << crs;
        std::filesystem::remove(file);
    }
}

TEST_F(MapLines, AGridWithinAThousandthIsMeasuredAsItStands) {
    const std::string file =
        write_lines("g.gpkg", "EPSG:2326", {"LINESTRING Z (834000 815900 30,834300 815500 10)"});
    const Profile profile = line_profile(file);
    EXPECT_EQ(profile.map_line->points.size(), 2u) << "nothing is densified";
    EXPECT_NEAR(profile.map_line->chainage_m.back(), 500, 1e-9);
}

// ---- attributes

TEST_F(MapLines, AttributesNameToeAndCrestAlsoAsAShapefileCutsThem) {
    const auto with = [this](const std::string& properties) {
        return write("a.geojson",
                     R"({"type":"Feature","properties":{)" + properties +
                         R"(},"geometry":{"type":"LineString","coordinates":[[834000,815900,32],)"
                         "[834030,815900,32],[834041,815900,12],[834201,815900,12]]}}");
    };
    const auto read = [&](const std::string& properties) {
        return read_map_section({.line = {.file = with(properties), .crs = "EPSG:2326"}}, {});
    };
    for (const char* toe : {R"("toe_chaina":39.5)", R"("TOE_CHAINA":"39.5")", R"("toe_chaina":" 39.5 m ")",
                            R"("toe_chainage_m":"+39.50")", R"("toe_chainage_m":null,"toe_chaina":39.5)",
                            R"("toe_chainage_m":"  ","toe_chaina":39.5)"})
        EXPECT_EQ(read(toe).toe_chainage_m, 39.5) << toe;
    const Profile crest = read(R"("crest_chai":"31")");
    EXPECT_NEAR(crest.to_section(crest.ground[crest.crest]).x(), 31, 1e-9);
    EXPECT_FALSE(read(R"("toe_chaina":"","crest_chai":null)").toe_given);
    for (const char* bad : {"39,5", "about 39", "0+039.5", "nan", "39.5 ft", "inf"})
        EXPECT_TRUE(has_part(error_of([&] { read(R"("toe_chaina":")" + std::string(bad) + '"'); }),
                             "a.geojson: feature 0, toe_chaina = " + std::string(bad) +
                                 ": is not a number; give the chainage in metres"))
            << bad;
}

// ---- which layer

TEST_F(MapLines, OfManyLayersTheOneWithLinesIsTaken) {
    const std::string track = write(
        "t.gpx",
        R"(<?xml version="1.0"?><gpx version="1.1" creator="t" xmlns="http://www.topografix.com/GPX/1/1">)"
        R"(<wpt lat="47" lon="8"><ele>9</ele></wpt><trk><name>T</name><trkseg><trkpt lat="47" lon="8"><ele>32</ele>)"
        R"(</trkpt><trkpt lat="46.9997" lon="8"><ele>32</ele></trkpt><trkpt lat="46.9996" lon="8"><ele>12</ele>)"
        R"(</trkpt><trkpt lat="46.998" lon="8"><ele>12</ele></trkpt></trkseg></trk></gpx>)");
    EXPECT_NEAR(line_profile(track).map_line->chainage_m.back(), 222.3, 0.1);
    EXPECT_EQ(line_driver(track), "GPX");
}

}  // namespace
}  // namespace runout
