#include "gis/line_layer.h"

#include <fmt/format.h>

#include <filesystem>

#include "gis/drivers.h"
#include "gis/gdal_access.h"

namespace runout {
namespace {

/// Of a layer whose kind of geometry is not fixed, so many features are looked at.
constexpr int features_looked_at = 100;

bool is_line(const OGRGeometry* geometry) {
    return geometry != nullptr && geometry->getDimension() == 1;
}

bool has_lines(OGRLayer& layer) {
    const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
    if (type == wkbNone || OGR_GT_IsSubClassOf(type, wkbPoint) || OGR_GT_IsSubClassOf(type, wkbMultiPoint) ||
        OGR_GT_IsSurface(type) || OGR_GT_IsSubClassOf(type, wkbMultiSurface))
        return false;
    int looked_at = 0;
    bool found = false;
    for (const auto& feature : layer) {
        found = is_line(feature->GetGeometryRef());
        if (found || ++looked_at == features_looked_at) break;
    }
    layer.ResetReading();
    return found;
}

std::string names_of(const std::vector<OGRLayer*>& layers) {
    std::string names;
    for (OGRLayer* layer : layers) names += (names.empty() ? "" : ", ") + std::string(layer->GetName());
    return names;
}

std::vector<OGRLayer*> all_layers(GDALDataset& data) {
    std::vector<OGRLayer*> layers;
    for (OGRLayer* layer : data.GetLayers()) layers.push_back(layer);
    return layers;
}

OGRLayer& only_layer_with_lines(GDALDataset& data, const LineQuery& query) {
    const std::vector<OGRLayer*> layers = all_layers(data);
    if (layers.size() == 1) return *layers.front();
    std::vector<OGRLayer*> candidates;
    for (OGRLayer* layer : layers)
        if (has_lines(*layer)) candidates.push_back(layer);
    if (candidates.size() == 1) return *candidates.front();
    if (candidates.empty())
        throw InputError({query.file, 0, "section.layer", ""},
                         fmt::format("is missing: none of {} layers holds lines", layers.size()),
                         "draw the sections as lines");
    throw InputError({query.file, 0, "section.layer", ""},
                     fmt::format("is missing: there are {} layers", candidates.size()),
                     "name one of " + names_of(candidates));
}

}  // namespace

void refuse_virtual_table(GDALDataset& data, OGRLayer& layer, const InputPlace& place) {
    if (data.GetDriver() == nullptr || !EQUAL(data.GetDriver()->GetDescription(), "GPKG")) return;
    std::string name;
    for (const char letter : std::string(layer.GetName()))
        name += letter == '\'' ? "''" : std::string(1, letter);
    const std::string question =
        "SELECT 1 FROM sqlite_master WHERE type = 'table' AND rootpage = 0 AND lower(name) = lower('" + name +
        "')";
    OGRLayer* answer = data.ExecuteSQL(question.c_str(), nullptr, nullptr);
    if (answer == nullptr) return;
    const bool is_virtual = OGRFeatureUniquePtr(answer->GetNextFeature()) != nullptr;
    data.ReleaseResultSet(answer);
    if (is_virtual)
        throw InputError(place, "is a virtual table, which computes its rows",
                         "save it as a layer of its own");
}

OGRLayer& layer_of(GDALDataset& data, const LineQuery& query) {
    if (data.GetLayerCount() == 0)
        throw InputError({query.file, 0, "", ""}, "has no layer", "draw the sections as lines");
    OGRLayer* layer =
        query.layer.empty() ? &only_layer_with_lines(data, query) : data.GetLayerByName(query.layer.c_str());
    if (layer == nullptr)
        throw InputError({query.file, 0, "section.layer", query.layer}, "is not a layer of this file",
                         "name one of " + names_of(all_layers(data)));
    refuse_virtual_table(data, *layer, {query.file, 0, "section.layer", layer->GetName()});
    return *layer;
}

std::string line_driver(const std::string& path) {
    const QuietGdal quiet;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored) && !std::filesystem::is_directory(path, ignored))
        return {};
    GDALDriverH found = GDALIdentifyDriverEx(std::filesystem::absolute(path).c_str(), GDAL_OF_VECTOR,
                                             line_drivers(), nullptr);
    return found != nullptr ? GDALGetDescription(found) : "";
}

}  // namespace runout
