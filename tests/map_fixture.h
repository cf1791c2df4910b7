#pragma once

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <array>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "core/input_error.h"
#include "profile/profile.h"
#include "temporary_folder.h"

namespace runout {

/// A raster for the tests: cells of `size` from the upper left corner, elevations by map coordinates.
struct TestRaster {
    std::string crs = "EPSG:2326";
    double left = 834000;
    double top = 816000;
    double size = 2;
    int columns = 200;
    int rows = 100;
    std::function<double(double x, double y)> elevation{};
    std::string unit{};
};

/// z = 50 - 0.4 (x - 834000) + 0.1 (y - 815800): exact for bilinear and cubic interpolation.
inline double plane(double x, double y) {
    return 50 - 0.4 * (x - 834000) + 0.1 * (y - 815800);
}

inline TestRaster plane_raster() {
    return {.elevation = plane};
}

/// Two lines on it.
inline const char* const across = "LINESTRING (834021 815901, 834341 815901)";
inline const char* const oblique = "LINESTRING (834021.3 815830.7, 834200 815900, 834377.7 815911.1)";

inline OGRSpatialReference test_reference(const std::string& crs) {
    OGRSpatialReference reference;
    reference.SetFromUserInput(crs.c_str());
    reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return reference;
}

/// WKT of the Hong Kong 1980 Grid.
inline std::string test_wkt() {
    static const std::string wkt = [] {
        char* text = nullptr;
        test_reference("EPSG:2326").exportToWkt(&text);
        std::string copy = text;
        CPLFree(text);
        return copy;
    }();
    return wkt;
}

/// Files in a directory of their own, removed afterwards, in any format of GDAL.
class MapFiles : public testing::Test {
  protected:
    void SetUp() override { GDALAllRegister(); }

    [[nodiscard]] std::string path(const std::string& name) const { return folder_.file(name); }

    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
        return path(name);
    }

    std::string write_raster(const std::string& name, const TestRaster& raster,
                             const char* driver = "GTiff") const {
        GDALDatasetUniquePtr data(GetGDALDriverManager()->GetDriverByName(driver)->Create(
            path(name).c_str(), raster.columns, raster.rows, 1, GDT_Float64, nullptr));
        std::array<double, 6> place = {raster.left, raster.size, 0, raster.top, 0, -raster.size};
        data->SetGeoTransform(place.data());
        if (!raster.crs.empty()) {
            const OGRSpatialReference reference = test_reference(raster.crs);
            data->SetSpatialRef(&reference);
        }
        GDALRasterBand* band = data->GetRasterBand(1);
        band->SetNoDataValue(-9999);
        if (!raster.unit.empty()) band->SetUnitType(raster.unit.c_str());
        std::vector<double> row(static_cast<std::size_t>(raster.columns));
        for (int j = 0; j < raster.rows; ++j) {
            for (int i = 0; i < raster.columns; ++i)
                row[i] = raster.elevation(raster.left + (i + 0.5) * raster.size,
                                          raster.top - (j + 0.5) * raster.size);
            EXPECT_EQ(band->RasterIO(GF_Write, 0, j, raster.columns, 1, row.data(), raster.columns, 1,
                                     GDT_Float64, 0, 0, nullptr),
                      CE_None);
        }
        return path(name);
    }

    /// One layer "sections" with the fields name and slope; geometries as WKT.
    std::string write_lines(const std::string& name, const std::string& crs,
                            const std::vector<std::string>& geometries, const char* driver = "GPKG") const {
        GDALDatasetUniquePtr data(GetGDALDriverManager()->GetDriverByName(driver)->Create(
            path(name).c_str(), 0, 0, 0, GDT_Unknown, nullptr));
        OGRSpatialReference reference = crs.empty() ? OGRSpatialReference() : test_reference(crs);
        OGRLayer* layer =
            data->CreateLayer("sections", crs.empty() ? nullptr : &reference, wkbUnknown, nullptr);
        OGRFieldDefn label("name", OFTString);
        OGRFieldDefn number("slope", OFTInteger);
        layer->CreateField(&label);
        layer->CreateField(&number);
        int count = 0;
        for (const std::string& wkt : geometries) {
            OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(layer->GetLayerDefn()));
            feature->SetField("name", std::string(1, static_cast<char>('A' + count)).c_str());
            feature->SetField("slope", 100 + count++);
            OGRGeometry* geometry = nullptr;
            OGRGeometryFactory::createFromWkt(wkt.c_str(), crs.empty() ? nullptr : &reference, &geometry);
            feature->SetGeometryDirectly(geometry);
            EXPECT_EQ(layer->CreateFeature(feature.get()), OGRERR_NONE);
        }
        return path(name);
    }

    [[nodiscard]] static std::string error_of(const std::function<void()>& action) {
        try {
            action();
        } catch (const InputError& error) {
            return error.what();
        }
        return "no error";
    }
    [[nodiscard]] static std::string section_error(const MapSection& section) {
        return error_of([&] { read_map_section(section, {}); });
    }

  private:
    TemporaryFolder folder_;
};

inline testing::AssertionResult has_part(const std::string& text, const std::string& part) {
    if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << '"' << text << "\" does not contain \"" << part << '"';
}

}  // namespace runout
