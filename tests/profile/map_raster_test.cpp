// What a raster has where it has no elevations, and how it is stored: nothing is read twice.

#include <fmt/format.h>

#include "map_fixture.h"

namespace runout {
namespace {

class MapRaster : public MapFiles {
  protected:
    [[nodiscard]] std::string line(const std::string& wkt = across) const {
        static int count = 0;
        return write_lines(fmt::format("l{}.gpkg", count++), "EPSG:2326", {wkt});
    }
    [[nodiscard]] std::string raster_error(const std::string& raster) const {
        return section_error({.raster = raster, .line = {.file = line()}, .sampling_m = 10});
    }

    /// The plane in one file with creation options, and no word of "no data" in it.
    [[nodiscard]] std::string plane_in(const std::string& name, std::vector<const char*> options,
                                       int columns = 200, int rows = 100) const {
        options.push_back(nullptr);
        GDALDatasetUniquePtr data(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
            path(name).c_str(), columns, rows, 1, GDT_Float32, const_cast<char**>(options.data())));
        std::array<double, 6> place = {834000, 2, 0, 816000, 0, -2};
        data->SetGeoTransform(place.data());
        const OGRSpatialReference reference = test_reference("EPSG:2326");
        data->SetSpatialRef(&reference);
        return path(name);
    }
};

TEST_F(MapRaster, ValuesThatStandForNoDataAreRefusedWithPlaceAndValue) {
    for (const double bad : {-9998.0, -32768.0, 1e20, -3.4e38, -32767.0, 9999.0, 65535.0, -999.0}) {
        TestRaster holed = plane_raster();
        holed.elevation = [bad](double x, double y) { return x > 834100 && x < 834106 ? bad : plane(x, y); };
        const std::string said = raster_error(write_raster("h.tif", holed));
        EXPECT_TRUE(has_part(said, "(834101, 815901) at chainage 80 m: meets a cell of ")) << bad;
        EXPECT_TRUE(has_part(
            said, "which is no elevation between -500 and 9000 m; if it stands for no data, say so"));
    }
}

TEST_F(MapRaster, AnOffsetAndAScaleComeFirst) {
    TestRaster decimetres = plane_raster();
    decimetres.elevation = [](double x, double y) { return 10 * (plane(x, y) + 1000); };  // up to 10,500
    const std::string raster = write_raster("d.tif", decimetres);
    EXPECT_TRUE(has_part(raster_error(raster), "which is no elevation"));
    {
        const GDALDatasetUniquePtr data(GDALDataset::Open(raster.c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE));
        data->GetRasterBand(1)->SetScale(0.1);
        data->GetRasterBand(1)->SetOffset(-1000);
    }
    EXPECT_EQ(raster_error(raster), "no error");
}

TEST_F(MapRaster, SeaAtZeroAndADeadSeaAreGround) {
    TestRaster coast = plane_raster();
    coast.elevation = [](double x, double) { return x < 834150 ? 120.0 - (x - 834000) / 2 : 0.0; };
    EXPECT_EQ(raster_error(write_raster("c.tif", coast)), "no error");
    coast.elevation = [](double x, double) { return -300 - (x - 834000) / 4; };
    EXPECT_EQ(raster_error(write_raster("s.tif", coast)), "no error");
}

TEST_F(MapRaster, CellsAreTheSameHoweverTheFileIsStored) {
    const std::vector<std::vector<const char*>> layouts = {
        {},
        {"TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16"},
        {"BLOCKYSIZE=100", "COMPRESS=DEFLATE"},
        {"TILED=YES", "BLOCKXSIZE=64", "BLOCKYSIZE=32", "COMPRESS=LZW"}};
    std::vector<double> first;
    for (std::size_t k = 0; k < layouts.size(); ++k) {
        const std::string file = plane_in(fmt::format("p{}.tif", k), layouts[k]);
        {
            const GDALDatasetUniquePtr data(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE));
            std::vector<float> row(200);
            for (int j = 0; j < 100; ++j) {
                for (int i = 0; i < 200; ++i)
                    row[static_cast<std::size_t>(i)] =
                        static_cast<float>(50 - 0.2 * i + 0.3 * ((i * 7 + j * 13) % 11));
                ASSERT_EQ(data->GetRasterBand(1)->RasterIO(GF_Write, 0, j, 200, 1, row.data(), 200, 1,
                                                           GDT_Float32, 0, 0, nullptr),
                          CE_None);
            }
        }
        for (const Interpolation interpolation : {Interpolation::bilinear, Interpolation::cubic}) {
            const Profile profile = read_map_section({.raster = file,
                                                      .line = {.file = line(oblique)},
                                                      .options = {.interpolation = interpolation}},
                                                     {});
            std::vector<double> elevations;
            for (const Vec2& point : profile.ground) elevations.push_back(profile.to_section(point).y());
            if (k == 0) first.insert(first.end(), elevations.begin(), elevations.end());
            const std::size_t begin = interpolation == Interpolation::bilinear ? 0 : first.size() / 2;
            ASSERT_EQ(elevations.size(), first.size() / (k == 0 && begin == 0 ? 1 : 2));
            for (std::size_t i = 0; i < elevations.size(); ++i) EXPECT_EQ(elevations[i], first[begin + i]);
        }
    }
}

TEST_F(MapRaster, AHugeStripIsRefusedWithTheWayOut) {
    // 20,000 x 20,000 cells of 4 bytes in one strip that says nothing: a file of some kilobytes.
    const std::string file =
        plane_in("huge.tif", {"COMPRESS=DEFLATE", "BLOCKYSIZE=20000", "SPARSE_OK=TRUE"}, 20000, 20000);
    EXPECT_TRUE(
        has_part(raster_error(file),
                 "huge.tif: is stored in pieces of 1526 MB, of which each is read whole for one cell; the "
                 "limit is 256 MB: gdal_translate -co TILED=YES"));
    const std::string around = write(
        "around.vrt",
        R"(<VRTDataset rasterXSize="20000" rasterYSize="20000"><SRS>EPSG:2326</SRS>)"
        R"(<GeoTransform>834000,2,0,816000,0,-2</GeoTransform><VRTRasterBand dataType="Float32" band="1">)"
        R"(<SimpleSource><SourceFilename relativeToVRT="1">huge.tif</SourceFilename><SourceBand>1</SourceBand>)"
        R"(</SimpleSource></VRTRasterBand></VRTDataset>)");
    EXPECT_TRUE(has_part(raster_error(around), "huge.tif: is stored in pieces of 1526 MB"));
}

}  // namespace
}  // namespace runout
