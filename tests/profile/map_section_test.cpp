// Sections from rasters and lines: exact on analytic ground, in any coordinate system, and every refusal a
// sentence.

#include <sys/resource.h>

#include <cmath>

#include "core/units.h"
#include "map_fixture.h"

namespace runout {
namespace {

// ---- elevations

TEST_F(MapFiles, APlaneIsExactAtNodesAndBetween) {
    const std::string raster = write_raster("z.tif", plane_raster());
    for (const Interpolation interpolation : {Interpolation::bilinear, Interpolation::cubic})
        for (const char* wkt : {across, oblique}) {
            const MapSection section{.raster = raster,
                                     .line = {.file = write_lines("s.gpkg", "EPSG:2326", {wkt})},
                                     .sampling_m = 0.7,
                                     .options = {.interpolation = interpolation}};
            const Profile profile = read_map_section(section, {});
            ASSERT_GT(profile.ground.size(), 400u);
            ASSERT_TRUE(profile.map_line.has_value());
            for (const Vec2& local : profile.ground) {
                const Vec2 at = profile.to_section(local);
                const Vec2 map = point_at(*profile.map_line, at.x());
                ASSERT_NEAR(at.y(), plane(map.x(), map.y()), 1e-6) << wkt << " at " << at.x();
            }
            std::filesystem::remove(section.line.file);
        }
}

TEST_F(MapFiles, BilinearBetweenNodesIsTheBilinearFormAndCubicIsExactOnAParabola) {
    TestRaster saddle = plane_raster();
    saddle.elevation = [](double x, double y) { return (x - 834001) * (y - 815801) / 100.0; };
    const LineQuery line{.file = write_lines("s.gpkg", "EPSG:2326", {oblique})};
    const std::string saddle_file = write_raster("saddle.tif", saddle);
    for (const Vec2& local : read_map_section({.raster = saddle_file, .line = line}, {}).ground) {
        static const Profile profile = read_map_section({.raster = saddle_file, .line = line}, {});
        const Vec2 at = profile.to_section(local);
        const Vec2 map = point_at(*profile.map_line, at.x());
        ASSERT_NEAR(at.y(), saddle.elevation(map.x(), map.y()), 1e-6);
    }
    TestRaster bowl = plane_raster();
    bowl.elevation = [](double x, double y) {
        return std::pow(x - 834600, 2) / 500 + std::pow(y - 815850, 2) / 70;
    };
    const std::string bowl_file = write_raster("bowl.tif", bowl);
    for (const Interpolation interpolation : {Interpolation::bilinear, Interpolation::cubic}) {
        const Profile profile = read_map_section(
            {.raster = bowl_file, .line = line, .options = {.interpolation = interpolation}}, {});
        double worst = 0;
        for (const Vec2& local : profile.ground) {
            const Vec2 at = profile.to_section(local);
            const Vec2 map = point_at(*profile.map_line, at.x());
            worst = std::max(worst, std::abs(at.y() - bowl.elevation(map.x(), map.y())));
        }
        if (interpolation == Interpolation::cubic)
            EXPECT_LT(worst, 1e-6);
        else
            EXPECT_NEAR(worst, 1.0 / 500 + 1.0 / 70, 1e-3) << "half a cell of 2 m from the nodes";
    }
}

TEST_F(MapFiles, IsSampledEvenlyWithHalfACellUnlessSaidOtherwise) {
    const std::string raster = write_raster("z.tif", plane_raster());
    const std::string lines = write_lines("s.gpkg", "EPSG:2326", {across});
    EXPECT_EQ(read_map_section({.raster = raster, .line = {.file = lines}}, {}).ground.size(), 321u);
    const Profile profile =
        read_map_section({.raster = raster, .line = {.file = lines}, .sampling_m = 7}, {});
    ASSERT_EQ(profile.ground.size(), 47u);  // 320 m in 46 steps of no more than 7 m
    for (std::size_t i = 1; i < profile.ground.size(); ++i)
        EXPECT_NEAR(profile.ground[i].x() - profile.ground[i - 1].x(), 320.0 / 46, 1e-9);
    EXPECT_TRUE(has_part(profile.origin, "s.gpkg, layer sections, feature 1"));
}

TEST_F(MapFiles, ALineMayRunUphillAndKeepsItsChainage) {
    const Profile profile = read_map_section(
        {.raster = write_raster("z.tif", plane_raster()),
         .line = {.file = write_lines("s.gpkg", "EPSG:2326", {"LINESTRING (834341 815901, 834021 815901)"})}},
        {});
    EXPECT_FALSE(profile.descends_with_chainage);
    const Vec2 head = profile.to_section(profile.ground.front());
    EXPECT_NEAR(head.x(), 320, 1e-9);
    EXPECT_NEAR(point_at(*profile.map_line, head.x()).x(), 834021, 1e-9);
}

// ---- which lines

TEST_F(MapFiles, ManyLinesAreManySections) {
    const std::string raster = write_raster("z.tif", plane_raster());
    const std::string lines = write_lines("s.gpkg", "EPSG:2326", {across, oblique});
    const auto features = section_features({.file = lines});
    ASSERT_EQ(features.size(), 2u);
    EXPECT_EQ(features[0].label, "A");
    EXPECT_EQ(features[1].feature.feature_id, 2);
    EXPECT_TRUE(has_part(section_error({.raster = raster, .line = {.file = lines}}),
                         "has 2 lines; choose one with section.feature_id or section.where"));
    const Profile second =
        read_map_section({.raster = raster, .line = {.file = lines, .where = "slope = 101"}}, {});
    const std::vector<Attribute> expected = {{"name", "B"}, {"slope", 101L}};
    EXPECT_EQ(second.map_line->attributes, expected);
    EXPECT_EQ(second.map_line->points.size(), 3u);
}

TEST_F(MapFiles, AttributesMayNameToeAndCrest) {
    const std::string raster = write_raster("z.tif", plane_raster());
    const std::string lines = write(
        "s.geojson",
        R"({"type":"Feature","properties":{"crest_chainage_m":40,"toe_chainage_m":90.5},"geometry":{"type":"LineString","coordinates":[[834021,815901],[834341,815901]]}})");
    const MapSection section{.raster = raster, .line = {.file = lines, .crs = "EPSG:2326"}};
    const Profile profile = read_map_section(section, {});
    EXPECT_EQ(profile.toe_chainage_m, 90.5);
    EXPECT_NEAR(profile.to_section(profile.ground[profile.crest]).x(), 40, 1e-9);
    ProfileOptions options;
    options.toe_chainage = Chainage(120);
    EXPECT_EQ(read_map_section(section, options).toe_chainage_m, 120) << "what the user says comes first";
}

TEST_F(MapFiles, RefusesWhatIsNoSectionLine) {
    const std::string raster = write_raster("z.tif", plane_raster());
    const auto refusal = [&](const std::string& wkt) {
        static int count = 0;
        return section_error(
            {.raster = raster,
             .line = {.file = write_lines("w" + std::to_string(count++) + ".gpkg", "EPSG:2326", {wkt})}});
    };
    EXPECT_TRUE(has_part(refusal("POINT (834021 815901)"), "feature 1 = POINT: is not a line"));
    EXPECT_TRUE(has_part(refusal("POLYGON ((834021 815901,834031 815901,834031 815911,834021 815901))"),
                         "POLYGON: is not a line"));
    EXPECT_TRUE(
        has_part(refusal("MULTILINESTRING ((834021 815901,834031 815901),(834041 815901,834051 815901))"),
                 "MULTILINESTRING: has 2 parts; draw each section as one line"));
    EXPECT_EQ(refusal("MULTILINESTRING ((834021 815901,834341 815901))"), "no error");
    EXPECT_EQ(refusal("CIRCULARSTRING (834021 815851,834181 815871,834341 815851)"), "no error");
    EXPECT_TRUE(has_part(refusal("LINESTRING (834021 815901,834121 815901,834071 815951,834021 815901)"),
                         "closes or crosses itself"));
    EXPECT_TRUE(has_part(refusal("LINESTRING (834021 815901,834121 815901,834121 815921,834071 815851)"),
                         "closes or crosses itself"));
    EXPECT_TRUE(has_part(refusal("LINESTRING (834021 815901,834021 815901)"), "has no length"));
    EXPECT_TRUE(has_part(refusal("LINESTRING EMPTY"), "has no length"));
}

TEST_F(MapFiles, RefusesFilesLayersFeaturesAndConditionsThatDoNotExist) {
    const std::string raster = write_raster("z.tif", plane_raster());
    const std::string lines = write_lines("s.gpkg", "EPSG:2326", {across});
    const auto refusal = [&](const LineQuery& line) {
        return section_error({.raster = raster, .line = line});
    };
    EXPECT_TRUE(has_part(refusal({.file = path("none.gpkg")}), "none.gpkg: cannot be opened"));
    EXPECT_TRUE(
        has_part(refusal({.file = write("text.gpkg", "no database")}), "text.gpkg: cannot be opened"));
    EXPECT_TRUE(has_part(section_error({.raster = path("none.tif"), .line = {.file = lines}}),
                         "none.tif: cannot be opened"));
    EXPECT_TRUE(
        has_part(section_error({.raster = lines, .line = {.file = lines}}), "s.gpkg: cannot be opened"));
    EXPECT_TRUE(has_part(refusal({.file = lines, .layer = "slopes"}),
                         "section.layer = slopes: is not a layer of this file; name one of sections"));
    EXPECT_TRUE(has_part(refusal({.file = lines, .feature_id = 7}),
                         "section.feature_id = 7: is not a feature of layer sections"));
    EXPECT_TRUE(has_part(refusal({.file = lines, .where = "name = 'Z'"}),
                         "section.where = name = 'Z': holds for no feature"));
    EXPECT_TRUE(
        has_part(refusal({.file = lines, .where = "no such field = 1"}), "is not a condition on the fields"));
    EXPECT_TRUE(
        has_part(refusal({.file = write("e.geojson", R"({"type":"FeatureCollection","features":[]})")}),
                 "has no feature"));
}

TEST_F(MapFiles, NamesWhereTheRasterEndsOrHasAHole) {
    const LineQuery line{.file = write_lines("s.gpkg", "EPSG:2326", {across})};
    const LineQuery beyond{
        .file = write_lines("b.gpkg", "EPSG:2326", {"LINESTRING (834021 815901,834421 815901)"})};
    EXPECT_TRUE(has_part(
        section_error({.raster = write_raster("z.tif", plane_raster()), .line = beyond, .sampling_m = 10}),
        "section line = (834401, 815901) at chainage 380 m: lies outside the raster; shorten the line"));
    TestRaster holed = plane_raster();
    for (const double hole : {-9999.0, std::nan("")}) {
        holed.elevation = [hole](double x, double y) {
            return x > 834100 && x < 834106 ? hole : plane(x, y);
        };
        EXPECT_TRUE(
            has_part(section_error({.raster = write_raster("h.tif", holed), .line = line, .sampling_m = 10}),
                     "(834101, 815901) at chainage 80 m: meets a cell without data; fill the gap"));
    }
    EXPECT_TRUE(has_part(
        section_error({.raster = write_raster("z.tif", plane_raster()), .line = line, .sampling_m = 1e-9}),
        "section.sampling_m = 1e-09: makes 3.2e+11 samples"));
    EXPECT_TRUE(has_part(section_error({.raster = path("z.tif"), .line = line, .sampling_m = -1}),
                         "is not a distance"));
}

// ---- lines with elevations of their own

TEST_F(MapFiles, AThreeDimensionalLineIsASection) {
    const std::string lines = write_lines(
        "s.gpkg", "EPSG:2326",
        {"LINESTRING Z (834000 815900 30,834020 815900 30,834030 815900 10,834130 815900 10)", across});
    const Profile profile = read_map_section({.line = {.file = lines, .feature_id = 1}}, {});
    const Polyline expected{{-30, 20}, {-10, 20}, {0, 0}, {100, 0}};
    ASSERT_EQ(profile.ground.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_LT((profile.ground[i] - expected[i]).norm(), 1e-9);
    const Profile feet =
        read_map_section({.line = {.file = lines, .feature_id = 1}, .options = {.elevation_unit = "ft"}}, {});
    EXPECT_NEAR(feet.ground.front().y(), 20 * 0.3048, 1e-9);
    EXPECT_TRUE(has_part(section_error({.line = {.file = lines, .feature_id = 2}}),
                         "feature 2 = LINESTRING: has no elevations; give section.raster"));
}

// ---- smoothing

TEST(Smoothing, LeavesAPlaneAloneAndTellsWhatItDidToAnEdge) {
    std::vector<Vec2> slope;
    for (int i = 0; i <= 200; ++i) slope.emplace_back(0.5 * i, 30 - 0.2 * i);
    const std::vector<Vec2> before = slope;
    const Smoothing nothing = smooth_elevations(slope, 6);
    EXPECT_LT(nothing.greatest_change_m, 1e-12);
    for (std::size_t i = 0; i < slope.size(); ++i) EXPECT_NEAR(slope[i].y(), before[i].y(), 1e-12);

    std::vector<Vec2> step;
    for (int i = 0; i <= 200; ++i) step.emplace_back(0.5 * i, i <= 100 ? 10.0 : 0.0);
    const Smoothing told = smooth_elevations(step, 6);
    EXPECT_GT(told.greatest_change_m, 3);
    EXPECT_NEAR(told.greatest_change_chainage_m, 50, 0.6);
    EXPECT_NEAR(told.steepest_before, std::atan2(10, 0.5), 1e-12);
    EXPECT_LT(told.steepest_after, told.steepest_before);
    EXPECT_EQ(step.front(), Vec2(0, 10));
    EXPECT_EQ(step.back(), Vec2(100, 0));
}

TEST(Smoothing, AWindowNarrowerThanTheSamplesChangesNothing) {
    std::vector<Vec2> points{{0, 3}, {1, 1}, {2, 2}};
    EXPECT_EQ(smooth_elevations(points, 1.5).greatest_change_m, 0);
}

TEST_F(MapFiles, SmoothingIsToldInTheOrigin) {
    TestRaster rough = plane_raster();
    rough.elevation = [](double x, double y) { return plane(x, y) + 0.2 * std::sin(x) * std::cos(y); };
    const Profile profile = read_map_section({.raster = write_raster("z.tif", rough),
                                              .line = {.file = write_lines("s.gpkg", "EPSG:2326", {across})},
                                              .smoothing_m = 12},
                                             {});
    EXPECT_TRUE(has_part(profile.origin, "smoothed over 12 m (elevations moved by up to 0."));
    EXPECT_TRUE(has_part(profile.origin, "steepest part"));
}

// ---- large rasters

TEST_F(MapFiles, ALargeRasterIsReadByWindow) {
    // 10,000 x 10,000 cells are 400 MB as Float32; only the tiles along the diagonal are written.
    constexpr int cells = 10000;
    constexpr int tile = 256;
    const std::string file = path("large.tif");
    {
        const std::array<const char*, 3> options = {"TILED=YES", "SPARSE_OK=TRUE", nullptr};
        GDALDatasetUniquePtr data(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
            file.c_str(), cells, cells, 1, GDT_Float32, options.data()));
        std::array<double, 6> place = {830000, 1, 0, 825000, 0, -1};
        data->SetGeoTransform(place.data());
        const OGRSpatialReference reference = test_reference("EPSG:2326");
        data->SetSpatialRef(&reference);
        data->GetRasterBand(1)->SetNoDataValue(-9999);
        std::vector<float> block(tile * tile);
        for (int right = 0; right < cells; right += tile)
            for (int down = std::max(0, right - tile); down <= right + tile && down < cells; down += tile) {
                const int width = std::min(tile, cells - right);
                const int height = std::min(tile, cells - down);
                for (int j = 0; j < height; ++j)
                    for (int i = 0; i < width; ++i)
                        block[j * width + i] =
                            static_cast<float>(8000.0 - 0.5 * (right + i) - 0.25 * (down + j));
                ASSERT_EQ(data->GetRasterBand(1)->RasterIO(GF_Write, right, down, width, height, block.data(),
                                                           width, height, GDT_Float32, 0, 0, nullptr),
                          CE_None);
            }
    }
    const std::string lines =
        write_lines("s.gpkg", "EPSG:2326", {"LINESTRING (830100 824900,839900 815100)"});
    // In a process of its own, so that the peak of other tests does not count.
    const auto read_and_weigh = [&] {
        rusage before{};
        getrusage(RUSAGE_SELF, &before);
        const Profile profile = read_map_section({.raster = file, .line = {.file = lines}}, {});
        rusage after{};
        getrusage(RUSAGE_SELF, &after);
        const Vec2 middle = profile.to_section(profile.ground[profile.ground.size() / 2]);
        const Vec2 map = point_at(*profile.map_line, middle.x());
        const bool exact =
            std::abs(middle.y() - (8000 - 0.5 * (map.x() - 830000.5) - 0.25 * (824999.5 - map.y()))) < 1e-2;
        const long grown_mb = (after.ru_maxrss - before.ru_maxrss) / 1024;
        std::fprintf(stderr, "grown by %ld MB, %zu points\n", grown_mb, profile.ground.size());
        _exit(exact && grown_mb < 150 ? 0 : 1);
    };
    GTEST_FLAG_SET(death_test_style, "fast");
    EXPECT_EXIT(read_and_weigh(), testing::ExitedWithCode(0), "grown by");
}

}  // namespace
}  // namespace runout
