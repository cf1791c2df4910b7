// What a map may be and refer to: local files of known kinds, and nothing on another machine.

#include <cpl_http.h>
#include <sys/stat.h>

#include <filesystem>

#include "gis/network.h"
#include "map_fixture.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

class MapAccess : public MapFiles {
  protected:
    void SetUp() override {
        MapFiles::SetUp();
        raster_ = write_raster("z.tif", plane_raster());
        line_ = write_lines("l.gpkg", "EPSG:2326", {across});
    }
    [[nodiscard]] std::string raster_error(const std::string& raster) const {
        return section_error({.raster = raster, .line = {.file = line_}, .sampling_m = 10});
    }
    [[nodiscard]] std::string line_error(const std::string& file) const {
        return section_error({.raster = raster_, .line = {.file = file}, .sampling_m = 10});
    }
    std::string vrt(const std::string& name, const std::string& source,
                    const std::string& band = "VRTSourcedRasterBand") const {
        return write(
            name, R"(<VRTDataset rasterXSize="200" rasterYSize="100"><SRS>EPSG:2326</SRS>)"
                  R"(<GeoTransform>834000,2,0,816000,0,-2</GeoTransform><VRTRasterBand dataType="Float64" )"
                  R"(band="1" subClass=")" +
                      band + "\"><SimpleSource>" + source +
                      "<SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>");
    }
    static std::string relative(const std::string& file) {
        return R"(<SourceFilename relativeToVRT="1">)" + file + "</SourceFilename>";
    }
    static std::string absolute(const std::string& file) {
        return R"(<SourceFilename relativeToVRT="0">)" + file + "</SourceFilename>";
    }

    std::string raster_, line_;
};

TEST_F(MapAccess, NamesOnOtherMachinesAreRefused) {
    for (const char* name :
         {"/vsicurl/http://127.0.0.1:9/z.tif", "/vsis3/bucket/z.tif", "/vsigs/b/z.tif", "/vsiaz/b/z.tif",
          "/vsizip//vsicurl/http://127.0.0.1:9/z.zip/z.tif", "/vsitar//vsis3/b/z.tar/z.tif", "/vsistdin/",
          "http://127.0.0.1:9/z.tif", "https://127.0.0.1:9/l.geojson", "ftp://127.0.0.1/z.tif"}) {
        EXPECT_TRUE(has_part(raster_error(name),
                             "is not a file on this machine; copy it here first, or give "
                             "--allow-network"))
            << name;
        EXPECT_TRUE(has_part(line_error(name), "is not a file on this machine")) << name;
    }
}

TEST_F(MapAccess, NothingButAFileIsOpened) {
    for (const char* name : {"PG:host=127.0.0.1", "WFS:http", "MEM:::DATAPOINTER=1",
                             R"({"type":"FeatureCollection","features":[]})", "<GDAL_WMS></GDAL_WMS>"})
        EXPECT_NE(line_error(name), "no error") << name;
    ASSERT_EQ(mkfifo(path("pipe.geojson").c_str(), 0600), 0);
    EXPECT_TRUE(has_part(line_error(path("pipe.geojson")), "is neither a file nor a folder"));
    EXPECT_TRUE(has_part(raster_error("/dev/zero"), "is neither a file nor a folder"));
}

TEST_F(MapAccess, DriversThatSpeakToServersReadNothing) {
    const std::string wms =
        R"(<GDAL_WMS><Service name="TMS"><ServerUrl>http://127.0.0.1:9/${z}/${x}/${y}.tif</ServerUrl></Service>)"
        R"(<DataWindow><UpperLeftX>834000</UpperLeftX><UpperLeftY>816000</UpperLeftY><LowerRightX>834400</LowerRightX>)"
        R"(<LowerRightY>815800</LowerRightY><SizeX>200</SizeX><SizeY>100</SizeY></DataWindow>)"
        R"(<Projection>EPSG:2326</Projection><BandsCount>1</BandsCount></GDAL_WMS>)";
    for (const char* name : {"wms.xml", "wms.tif", "wms.vrt"})
        EXPECT_TRUE(has_part(raster_error(write(name, wms)), "cannot be opened")) << name;
    EXPECT_TRUE(has_part(
        line_error(write("wfs.xml", "<OGRWFSDataSource><URL>http://127.0.0.1:9</URL></OGRWFSDataSource>")),
        "cannot be opened"));
    EXPECT_TRUE(
        has_part(line_error(write("lines.csv", "WKT,name\n\"LINESTRING (834021 815901,834341 815901)\",A\n")),
                 "cannot be opened"))
        << "a table is no map";
    EXPECT_TRUE(has_part(raster_error(vrt("w.vrt", relative("wms.xml"))), "cannot be"));
}

TEST_F(MapAccess, AVirtualRasterTakesWhatLiesBesideIt) {
    EXPECT_EQ(raster_error(vrt("good.vrt", relative("z.tif"))), "no error");
    fs::create_directory(path("tiles"));
    fs::copy_file(raster_, path("tiles/z.tif"));
    EXPECT_EQ(raster_error(vrt("below.vrt", relative("tiles/z.tif"))), "no error");
    EXPECT_EQ(raster_error(vrt("whole.vrt", absolute(raster_))), "no error");
    EXPECT_EQ(raster_error(vrt("nested.vrt", relative("good.vrt"))), "no error");
}

TEST_F(MapAccess, AVirtualRasterTakesNothingElse) {
    fs::create_directory(path("inner"));
    const std::string outside = "lies outside the folder of the file";
    EXPECT_TRUE(has_part(raster_error(vrt("inner/a.vrt", relative("../z.tif"))), outside));
    EXPECT_TRUE(has_part(raster_error(vrt("inner/b.vrt", absolute(raster_))), outside));
    EXPECT_TRUE(has_part(raster_error(vrt("c.vrt", absolute("/etc/hostname"))), outside));
    fs::create_symlink(raster_, path("inner/link.tif"));
    EXPECT_TRUE(has_part(raster_error(vrt("inner/d.vrt", relative("link.tif"))), outside));
    const std::string remote = "is not a file on this machine";
    EXPECT_TRUE(has_part(raster_error(vrt("e.vrt", absolute("/vsicurl/http://127.0.0.1:9/z.tif"))), remote));
    EXPECT_TRUE(has_part(raster_error(vrt("f.vrt", absolute("/vsizip//vsis3/b/z.zip/z.tif"))), remote));
    EXPECT_TRUE(has_part(raster_error(vrt("g.vrt", absolute("http://127.0.0.1:9/z.tif"))), remote));
    EXPECT_TRUE(has_part(raster_error(vrt("h.vrt", relative("none.tif"))), "is not a file"));
    EXPECT_TRUE(has_part(raster_error(vrt("i.vrt", relative("GTIFF_DIR:1:z.tif"))), "is not a file"));
    vrt("j1.vrt", absolute("/vsicurl/http://127.0.0.1:9/z.tif"));
    EXPECT_TRUE(has_part(raster_error(vrt("j.vrt", relative("j1.vrt"))), remote)) << "nor do its sources";
    vrt("loop.vrt", relative("loop.vrt"));
    EXPECT_TRUE(has_part(raster_error(path("loop.vrt")), "within too many others"));
    vrt("python.vrt",
        relative("z.tif") + "</SimpleSource><PixelFunctionCode>import os</PixelFunctionCode><SimpleSource>");
    EXPECT_TRUE(has_part(raster_error(path("python.vrt")), "lets the file compute what it holds"));
}

TEST_F(MapAccess, SoDoVirtualLines) {
    const auto ogr = [this](const std::string& name, const std::string& inner) {
        return write(name, "<OGRVRTDataSource><OGRVRTLayer name=\"sections\">" + inner +
                               "</OGRVRTLayer></OGRVRTDataSource>");
    };
    EXPECT_EQ(line_error(ogr("a.vrt", R"(<SrcDataSource relativeToVRT="1">l.gpkg</SrcDataSource>)")),
              "no error");
    EXPECT_TRUE(
        has_part(line_error(ogr("b.vrt", "<SrcDataSource>/etc/hostname</SrcDataSource>")), "lies outside"));
    EXPECT_TRUE(
        has_part(line_error(ogr("c.vrt", "<SrcDataSource>http://127.0.0.1:9/l.geojson</SrcDataSource>")),
                 "is not a file on this machine"));
    EXPECT_TRUE(has_part(line_error(ogr("d.vrt", R"(<SrcDataSource relativeToVRT="1">l.gpkg</SrcDataSource>)"
                                                 "<SrcSQL>SELECT * FROM '/etc/passwd'.x</SrcSQL>")),
                         "lets the file compute"));
}

TEST_F(MapAccess, AVirtualTableOfAGeoPackageIsRefused) {
    {
        const GDALDatasetUniquePtr data(
            GDALDataset::Open(line_.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE, nullptr, nullptr, nullptr));
        data->ExecuteSQL("CREATE VIRTUAL TABLE trap USING rtree(id, a, b)", nullptr, nullptr);
        data->ExecuteSQL(
            "INSERT INTO gpkg_contents (table_name, data_type, identifier) VALUES "
            "('trap', 'attributes', 'trap')",
            nullptr, nullptr);
    }
    EXPECT_TRUE(has_part(section_error({.raster = raster_, .line = {.file = line_, .layer = "trap"}}),
                         "is a virtual table"));
    EXPECT_EQ(section_error({.raster = raster_, .line = {.file = line_, .layer = "sections"}}), "no error");
}

TEST_F(MapAccess, TheHttpClientOfGdalIsOff) {
    EXPECT_EQ(raster_error(raster_), "no error");  // GDAL is set up now
    CPLHTTPResult* answer = CPLHTTPFetch("http://127.0.0.1:9/", nullptr);
    ASSERT_NE(answer, nullptr);
    EXPECT_NE(answer->nStatus, 0);
    EXPECT_TRUE(has_part(answer->pszErrBuf, "network access is off"));
    CPLHTTPDestroyResult(answer);
    VSIStatBufL found;
    EXPECT_NE(VSIStatL("/vsicurl/http://127.0.0.1:9/", &found), 0);
    EXPECT_EQ(VSIFOpenL("/vsizip//vsicurl/http://127.0.0.1:9/z.zip/z.tif", "rb"), nullptr);
}

TEST_F(MapAccess, AFolderMayBeCalledAsItLikes) {
    for (const char* name :
         {"/home/u/vsites/z.tif", "vsi/z.tif", "maps/http:/z.tif", "/vsizip//tmp/z.zip/z.tif"})
        EXPECT_FALSE(is_remote(name)) << name;
    for (const char* name :
         {"/vsizip/{/vsicurl/http://h/z.zip}/z.tif", "/vsigzip//vsioss/b/z.gz", "/vsiwebhdfs/h/z"})
        EXPECT_TRUE(is_remote(name)) << name;
}

TEST_F(MapAccess, LocalArchivesAreFiles) {
    const std::string zip = path("z.zip");
    {
        VSILFILE* out = VSIFOpenL(("/vsizip/" + zip + "/l.geojson").c_str(), "wb");
        ASSERT_NE(out, nullptr);
        const std::string text =
            R"({"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":[[114.18,22.283],[114.183,22.283]]}})";
        VSIFWriteL(text.data(), 1, text.size(), out);
        VSIFCloseL(out);
    }
    EXPECT_TRUE(has_part(line_error("/vsizip/" + zip + "/l.geojson"), "lies outside the raster"));
}

TEST_F(MapAccess, ADriverIsKnownByTheContentOfAFile) {
    fs::copy_file(line_, path("sections.bin"));
    EXPECT_EQ(line_driver(path("sections.bin")), "GPKG");
    EXPECT_EQ(line_driver(write("a.json", R"({"type":"FeatureCollection","features":[]})")), "GeoJSON");
    EXPECT_EQ(line_driver(write("b.dat", "chainage_m,elevation_m\n0,32\n30,12\n")), "");
    EXPECT_EQ(line_driver(write("c.json", R"({"run_out_m": 3})")), "");
    EXPECT_EQ(line_driver(path("none.gpkg")), "");
    EXPECT_EQ(line_driver(raster_), "");
    EXPECT_EQ(line_driver(write_lines("t.tab", "EPSG:2326", {across}, "MapInfo File")), "MapInfo File");
    EXPECT_EQ(line_driver(write_lines("s.shp", "EPSG:2326", {across}, "ESRI Shapefile")), "ESRI Shapefile");
    EXPECT_EQ(line_driver(write_lines("k.kmz", "EPSG:4326", {"LINESTRING (8 47,8 46.99)"}, "LIBKML")),
              "LIBKML");
}

}  // namespace
}  // namespace runout
