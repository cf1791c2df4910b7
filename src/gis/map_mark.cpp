#include "gis/map_mark.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <array>
#include <fstream>
#include <iterator>

#include "core/output_mark.h"
#include "core/sha256.h"
#include "core/version.h"
#include "gis/gdal_access.h"
#include "gis/memory_file.h"

namespace runout {
namespace {

constexpr const char* hash_item = "RUNOUT_SHA256_OF_CONTENT";
constexpr const char* version_item = "RUNOUT_VERSION";

GDALDatasetUniquePtr open_geopackage(const std::string& path, unsigned access) {
    const std::array<const char*, 2> drivers = {"GPKG", nullptr};
    return GDALDatasetUniquePtr(
        GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | access, drivers.data(), nullptr, nullptr));
}

std::string text_of(const OGRFeature& feature) {
    std::string text = fmt::format("feature {}\n", feature.GetFID());
    for (int i = 0; i < feature.GetFieldCount(); ++i)
        text += feature.IsFieldSetAndNotNull(i) ? fmt::format("={}\n", feature.GetFieldAsString(i)) : "-\n";
    const OGRGeometry* const geometry = feature.GetGeometryRef();
    if (geometry == nullptr) return text;
    std::string wkb(geometry->WkbSize(), '\0');
    geometry->exportToWkb(wkbNDR, reinterpret_cast<unsigned char*>(wkb.data()));
    return text + wkb;
}

std::string content_hash(GDALDataset& data) {
    std::string text;
    for (OGRLayer* layer : data.GetLayers()) {
        text += fmt::format("layer {}\n", layer->GetName());
        for (int i = 0; i < layer->GetLayerDefn()->GetFieldCount(); ++i)
            text += fmt::format("field {}\n", layer->GetLayerDefn()->GetFieldDefn(i)->GetNameRef());
        for (const auto& feature : *layer) text += text_of(*feature);
    }
    return sha256_hex(text);
}

bool is_unedited_geopackage(const std::string& bytes) {
    const QuietGdal quiet;
    const MemoryFile copy(".gpkg", bytes);
    const GDALDatasetUniquePtr data = open_geopackage(copy.path(), GDAL_OF_READONLY);
    if (!data) return false;
    const char* const hash = data->GetMetadataItem(hash_item);
    return hash != nullptr && content_hash(*data) == hash;
}

}  // namespace

std::string with_map_mark(const std::string& geopackage, const std::string& path) {
    const MemoryFile file(".gpkg", geopackage);
    GDALDatasetUniquePtr data = open_geopackage(file.path(), GDAL_OF_UPDATE);
    const bool marked = data && data->SetMetadataItem(hash_item, content_hash(*data).c_str()) == CE_None &&
                        data->SetMetadataItem(version_item, program_version().c_str()) == CE_None;
    data.reset();
    if (!marked)
        throw InputError({path, 0, "", ""}, "cannot be written" + gdal_reason(), "install GDAL with GPKG");
    return file.bytes();
}

bool is_unedited_map(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    return bytes.starts_with("SQLite format 3") ? is_unedited_geopackage(bytes) : is_unedited_output(path);
}

}  // namespace runout
