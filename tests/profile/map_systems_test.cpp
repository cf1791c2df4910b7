// Sections from rasters and lines in any coordinate system, in degrees and in feet.

#include <cmath>

#include "core/units.h"
#include "map_fixture.h"

namespace runout {
namespace {

/// The same line in another system, as WKT.
std::string brought_to(const std::string& crs, const std::string& wkt) {
    OGRSpatialReference from = test_reference("EPSG:2326");
    OGRSpatialReference to = test_reference(crs);
    OGRGeometry* geometry = nullptr;
    OGRGeometryFactory::createFromWkt(wkt.c_str(), &from, &geometry);
    const std::unique_ptr<OGRGeometry> owner(geometry);
    EXPECT_EQ(geometry->transformTo(&to), OGRERR_NONE);
    OGRWktOptions options;
    options.precision = 17;
    return geometry->exportToWkt(options);
}

TEST_F(MapFiles, LineAndRasterMayBeInDifferentSystems) {
    const std::string raster = write_raster("z.tif", plane_raster());
    const Profile same = read_map_section(
        {.raster = raster, .line = {.file = write_lines("a.gpkg", "EPSG:2326", {across})}, .sampling_m = 5},
        {});
    for (const char* crs : {"EPSG:4326", "EPSG:32650", "EPSG:3857"}) {
        const std::string file = write_lines("b.gpkg", crs, {brought_to(crs, across)});
        const Profile other =
            read_map_section({.raster = raster, .line = {.file = file}, .sampling_m = 5}, {});
        const double there = other.map_line->chainage_m.back();
        EXPECT_NEAR(there, 320, 0.32) << crs << ": metres are true to a thousandth";
        for (const double share : {0.1, 0.5, 0.9}) {
            const auto i = static_cast<std::size_t>(share * static_cast<double>(other.ground.size() - 1));
            const Vec2 at = other.to_section(other.ground[i]);
            const double x = 834021 + 320 * at.x() / there;
            EXPECT_NEAR(at.y(), plane(x, 815901), 2e-3) << crs;
        }
        std::filesystem::remove(file);
    }
    EXPECT_NEAR(same.map_line->chainage_m.back(), 320, 1e-9);
}

TEST_F(MapFiles, BothMayBeInDegrees) {
    // A metre of latitude is 1/110,574 of a degree at the equator (WGS 84).
    TestRaster degrees{
        .crs = "EPSG:4326", .left = 117, .top = 0.002, .size = 1e-5, .columns = 300, .rows = 250};
    degrees.elevation = [](double x, double y) { return 40 - 20000 * (x - 117) + 3000 * y; };
    const std::string raster = write_raster("z.tif", degrees);
    const std::string lines = write_lines(
        "s.gpkg", "EPSG:4326",
        {"LINESTRING (117.0005 0.0005, 117.0025 0.0005)", "LINESTRING (117.001 0.0002, 117.001 0.0012)"});
    const Profile east = read_map_section({.raster = raster, .line = {.file = lines, .feature_id = 1}}, {});
    EXPECT_NEAR(east.map_line->chainage_m.back(), 6378137 * radians(0.002), 1e-3);
    for (const Vec2& local : east.ground) {
        const Vec2 at = east.to_section(local);
        const double x = 117.0005 + 0.002 * at.x() / east.map_line->chainage_m.back();
        EXPECT_NEAR(at.y(), degrees.elevation(x, 0.0005), 1e-6);
    }
    const Profile north = read_map_section({.raster = raster, .line = {.file = lines, .feature_id = 2}}, {});
    EXPECT_NEAR(north.map_line->chainage_m.back(), 110574.3 * 0.001, 1e-3);
    // Half a cell of 1e-5 degrees: the root of the area of a cell of 1.1132 x 1.1057 m.
    EXPECT_EQ(north.ground.size(), static_cast<std::size_t>(std::ceil(110.5743 / (1.10945 / 2)) + 1));
}

TEST_F(MapFiles, ASystemInFeetGivesMetres) {
    TestRaster feet = plane_raster();
    feet.crs = "EPSG:2263";  // New York Long Island, US survey feet
    feet.left = 980000;
    feet.top = 200200;
    feet.elevation = [](double x, double) { return 300 - 0.5 * (x - 980000); };
    const std::string raster = write_raster("z.tif", feet);
    const LineQuery line{
        .file = write_lines("s.gpkg", "EPSG:2263", {"LINESTRING (980010 200100, 980310 200100)"})};
    EXPECT_TRUE(has_part(section_error({.raster = raster, .line = line}),
                         "z.tif: counts in units of 0.3048006 m, not in metres; confirm it with "
                         "section.elevation_unit"));
    const Profile profile =
        read_map_section({.raster = raster, .line = line, .options = {.elevation_unit = "us-ft"}}, {});
    constexpr double foot = 1200.0 / 3937.0;
    EXPECT_NEAR(profile.map_line->chainage_m.back(), 300 * foot, 1e-9);
    EXPECT_NEAR(profile.to_section(profile.ground.front()).y(), 295 * foot, 1e-9);
    EXPECT_NEAR(profile.slope_angle, std::atan(0.5), 1e-9);
}

TEST_F(MapFiles, ElevationsInFeetMustBeConfirmed) {
    TestRaster labelled = plane_raster();
    labelled.unit = "ft";
    const std::string raster = write_raster("z.tif", labelled);
    const LineQuery line{.file = write_lines("s.gpkg", "EPSG:2326", {across})};
    EXPECT_TRUE(has_part(section_error({.raster = raster, .line = line}), "counts in units of 0.3048 m"));
    const Profile feet =
        read_map_section({.raster = raster, .line = line, .options = {.elevation_unit = "ft"}}, {});
    const Profile metres =
        read_map_section({.raster = raster, .line = line, .options = {.elevation_unit = "m"}}, {});
    EXPECT_NEAR(feet.to_section(feet.ground.front()).y(), 0.3048 * plane(834021, 815901), 1e-9);
    EXPECT_NEAR(metres.to_section(metres.ground.front()).y(), plane(834021, 815901), 1e-9);
    labelled.unit = "metre";
    EXPECT_EQ(section_error({.raster = write_raster("m.tif", labelled), .line = line}), "no error");
}

TEST_F(MapFiles, ASystemCanBeGivenWhereTheFileNamesNone) {
    TestRaster bare = plane_raster();
    bare.crs = "";
    const std::string raster = write_raster("z.tif", bare);
    const std::string lines = write_lines("s.shp", "", {across}, "ESRI Shapefile");
    EXPECT_TRUE(has_part(section_error({.raster = raster, .line = {.file = lines}}),
                         "s.shp: names no coordinate system; give section.line_crs, such as EPSG:2326"));
    const LineQuery line{.file = lines, .crs = "EPSG:2326"};
    EXPECT_TRUE(has_part(section_error({.raster = raster, .line = line}),
                         "z.tif: names no coordinate system; give section.raster_crs, such as EPSG:2326"));
    EXPECT_EQ(section_error({.raster = raster, .line = line, .options = {.crs = "EPSG:2326"}}), "no error");
    EXPECT_TRUE(has_part(section_error({.raster = raster, .line = line, .options = {.crs = "EPSG:99999999"}}),
                         "section.raster_crs = EPSG:99999999: is not a known coordinate system"));
}

TEST_F(MapFiles, MapGridCoordinatesInGeoJsonAreNoDegrees) {
    const std::string raster = write_raster("z.tif", plane_raster());
    const std::string lines = write(
        "s.geojson",
        R"({"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":[[834021,815901],[834341,815901]]}})");
    EXPECT_TRUE(
        has_part(section_error({.raster = raster, .line = {.file = lines}}),
                 "(834021, 815901): is not in degrees, as its coordinate system (WGS 84) has it; give "
                 "section.line_crs"));
    EXPECT_EQ(section_error({.raster = raster, .line = {.file = lines, .crs = "EPSG:2326"}}), "no error");
}

}  // namespace
}  // namespace runout
