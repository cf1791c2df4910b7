#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <string_view>

#include "core/length_unit.h"
#include "gis/drawing.h"
#include "gis/drawn_geometry.h"
#include "gis/gdal_access.h"

namespace runout {
namespace {

/// A reference that says where on earth it is. A GeoPackage has systems that are called undefined.
bool is_on_the_map(const OGRSpatialReference* reference) {
    if (reference == nullptr || reference->IsEmpty() || reference->IsLocal() != 0) return false;
    return !std::string_view(reference->GetName() != nullptr ? reference->GetName() : "")
                .starts_with("Undefined");
}

/// GeoJSON is in degrees by its standard, which not everyone keeps to. A file that is named as a section and
/// is larger than a place in degrees is taken as it stands.
bool is_local_geojson(GDALDataset& data, OGRLayer& layer) {
    constexpr double least_extent = 1;
    OGREnvelope box;
    return EQUAL(data.GetDriverName(), "GeoJSON") && layer.GetSpatialRef()->IsGeographic() != 0 &&
           layer.GetExtent(&box) == OGRERR_NONE && box.MaxX - box.MinX >= least_extent &&
           box.MaxY - box.MinY >= least_extent;
}

std::vector<OGRLayer*> asked_layers(GDALDataset& data, const LineQuery& query) {
    std::vector<OGRLayer*> layers;
    for (OGRLayer* layer : data.GetLayers())
        if (query.layer.empty() || query.layer == layer->GetName()) layers.push_back(layer);
    return layers;
}

/// Nothing where it cannot be opened: what reads it next says why.
GDALDatasetUniquePtr opened(const std::string& file) {
    try {
        return open_dataset(file, GDAL_OF_VECTOR, "");
    } catch (const InputError&) {
        return nullptr;
    }
}

/// Plans are drawn in these as well, and none of them names a coordinate system.
bool is_cad(GDALDataset& data) {
    return EQUAL(data.GetDriverName(), "DXF") || EQUAL(data.GetDriverName(), "DGN");
}

bool is_flat(OGRLayer& layer) {
    DrawnPointCount count("");
    for (const auto& feature : layer)
        for (const DrawnLine& line : drawn_lines(feature->GetGeometryRef(), count, Parts::many))
            return line.level;
    return true;
}

/// Of a local system that says so; empty for metres that nobody speaks of.
std::string unit_of(const OGRSpatialReference* reference) {
    if (reference == nullptr || reference->IsLocal() == 0) return {};
    const double metres = reference->GetLinearUnits();
    for (const char* word : {"m", "cm", "mm", "ft", "us-ft", "in"})
        if (std::abs(length_unit(word)->metres / metres - 1) < 1e-9) return word;
    return {};
}

void add_lines(OGRLayer& layer, const LineQuery& query, DrawnPointCount& count, Drawing& drawing) {
    CPLErrorReset();
    if (!query.where.empty() && layer.SetAttributeFilter(query.where.c_str()) != OGRERR_NONE)
        throw InputError({query.file, 0, "section.where", query.where},
                         "is not a condition on the fields of this layer" + gdal_reason(),
                         "write it as in SQL: name = 'A-A'");
    for (const auto& feature : layer) {
        if (query.feature_id && feature->GetFID() != *query.feature_id) continue;
        for (DrawnLine& line : drawn_lines(feature->GetGeometryRef(), count, Parts::many)) {
            line.layer = layer.GetName();
            drawing.lines.push_back(std::move(line));
        }
    }
    if (CPLGetLastErrorType() >= CE_Failure)
        throw InputError({query.file, 0, "layer", layer.GetName()},
                         "cannot be read to its end" + gdal_reason(), "save it again, whole");
}

}  // namespace

bool are_local_lines(const LineQuery& query) {
    const QuietGdal quiet;
    const GDALDatasetUniquePtr data = opened(query.file);
    if (!data || is_cad(*data)) return false;
    const std::vector<OGRLayer*> layers = asked_layers(*data, query);
    for (OGRLayer* layer : layers)
        if (is_on_the_map(layer->GetSpatialRef()) || !is_flat(*layer)) return false;
    return !layers.empty();
}

Drawing read_local_lines(const LineQuery& query) {
    const QuietGdal quiet;
    const auto data = open_dataset(query.file, GDAL_OF_VECTOR,
                                   "give a section as lines in a local system, x along it and y upwards");
    Drawing drawing{query.file, {}, {}, "its coordinate system", false};
    DrawnPointCount count(query.file);
    for (OGRLayer* layer : asked_layers(*data, query)) {
        const OGRSpatialReference* reference = layer->GetSpatialRef();
        if (is_on_the_map(reference) && !is_local_geojson(*data, *layer))
            throw InputError(
                {query.file, 0, "layer", layer->GetName()},
                fmt::format("lies on the map, in {}, and a section in a file of its own does not",
                            reference->GetName() != nullptr ? reference->GetName() : "a coordinate system"),
                "give section.line and section.raster for a line on the map; a section drawn as x = chainage "
                "and y = elevation names no coordinate system");
        if (drawing.unit.empty()) drawing.unit = unit_of(reference);
        add_lines(*layer, query, count, drawing);
    }
    return drawing;
}

}  // namespace runout
