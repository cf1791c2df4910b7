#include "gis/drivers.h"

#include <gdal_frmts.h>
#include <ogrsf_frmts.h>

#include <array>

namespace runout {
namespace {

struct KnownDriver {
    const char* name;
    void (*register_it)();
};

// Left out: whatever speaks to a server, runs a query language of its own, holds no elevations, or reads any
// text as data.
constexpr std::array raster_list = {
    KnownDriver{"VRT", GDALRegister_VRT},         KnownDriver{"GTiff", GDALRegister_GTiff},
    KnownDriver{"AAIGrid", GDALRegister_AAIGrid}, KnownDriver{"AIG", GDALRegister_AIGrid},
    KnownDriver{"BT", GDALRegister_BT},           KnownDriver{"DTED", GDALRegister_DTED},
    KnownDriver{"EHdr", GDALRegister_EHdr},       KnownDriver{"ENVI", GDALRegister_ENVI},
    KnownDriver{"GPKG", RegisterOGRGeoPackage},   KnownDriver{"GRASSASCIIGrid", GDALRegister_GRASSASCIIGrid},
    KnownDriver{"GS7BG", GDALRegister_GS7BG},     KnownDriver{"GSAG", GDALRegister_GSAG},
    KnownDriver{"GSBG", GDALRegister_GSBG},       KnownDriver{"HFA", GDALRegister_HFA},
    KnownDriver{"netCDF", GDALRegister_netCDF},   KnownDriver{"NWT_GRD", GDALRegister_NWT_GRD},
    KnownDriver{"RST", GDALRegister_IDRISI},      KnownDriver{"SAGA", GDALRegister_SAGA},
    KnownDriver{"SRTMHGT", GDALRegister_SRTMHGT}, KnownDriver{"USGSDEM", GDALRegister_USGSDEM},
    KnownDriver{"XYZ", GDALRegister_XYZ},
};

constexpr std::array line_list = {
    KnownDriver{"ESRI Shapefile", RegisterOGRShape},
    KnownDriver{"GPKG", RegisterOGRGeoPackage},
    KnownDriver{"GeoJSON", RegisterOGRGeoJSON},
    KnownDriver{"GeoJSONSeq", RegisterOGRGeoJSONSeq},
    KnownDriver{"ESRIJSON", RegisterOGRESRIJSON},
    KnownDriver{"FlatGeobuf", RegisterOGRFlatGeobuf},
    KnownDriver{"OpenFileGDB", RegisterOGROpenFileGDB},
    KnownDriver{"MapInfo File", RegisterOGRTAB},
    KnownDriver{"LIBKML", RegisterOGRLIBKML},
    KnownDriver{"GML", RegisterOGRGML},
    KnownDriver{"GPX", RegisterOGRGPX},
    KnownDriver{"DXF", RegisterOGRDXF},
    KnownDriver{"DGN", RegisterOGRDGN},
    KnownDriver{"OGR_VRT", RegisterOGRVRT},
};

/// Of a GeoPackage with a raster: it keeps tiles as pictures and puts them together in memory.
constexpr std::array helpers = {GDALRegister_MEM, GDALRegister_PNG, GDALRegister_JPEG};

template <std::size_t count>
std::array<const char*, count + 1> names_of(const std::array<KnownDriver, count>& list) {
    std::array<const char*, count + 1> names{};
    for (std::size_t i = 0; i < count; ++i) names[i] = list[i].name;
    return names;
}

}  // namespace

const char* const* raster_drivers() {
    static const auto names = names_of(raster_list);
    return names.data();
}

const char* const* line_drivers() {
    static const auto names = names_of(line_list);
    return names.data();
}

void register_drivers() {
    for (const KnownDriver& driver : raster_list) driver.register_it();
    for (const KnownDriver& driver : line_list) driver.register_it();
    for (const auto& register_it : helpers) register_it();
}

}  // namespace runout
