#include "gis/near_features.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gis/feature_line.h"
#include "gis/gdal_access.h"
#include "gis/line_corridor.h"
#include "gis/line_layer.h"

namespace runout {
namespace {

constexpr double largest_degree = 360;
constexpr std::size_t longest_text = 1000;
constexpr double rim_margin = 0.01;  // of the box of a corridor, which has straight sides in one system only

InputError refusal(const FeatureQuery& query, const char* key, const std::string& value, std::string problem,
                   std::string valid) {
    return {{query.file, 0, key, value}, std::move(problem), std::move(valid)};
}

std::string layer_names(GDALDataset& data) {
    std::string names;
    for (OGRLayer* layer : data.GetLayers())
        names += (names.empty() ? "" : ", ") + std::string(layer->GetName());
    return names;
}

OGRLayer& asked_layer(GDALDataset& data, const FeatureQuery& query) {
    const int count = data.GetLayerCount();
    if (count == 0) throw refusal(query, "places.file", "", "has no layer", "give a layer of places");
    if (query.layer.empty() && count > 1)
        throw refusal(query, "places.layer", "", fmt::format("is missing: there are {} layers", count),
                      "name one of " + layer_names(data));
    OGRLayer* layer = query.layer.empty() ? data.GetLayer(0) : data.GetLayerByName(query.layer.c_str());
    if (layer == nullptr)
        throw refusal(query, "places.layer", query.layer, "is not a layer of this file",
                      "name one of " + layer_names(data));
    refuse_virtual_table(data, *layer, {query.file, 0, "places.layer", layer->GetName()});
    return *layer;
}

/// Its number; -1 where it is not asked for and not there.
int field_of(OGRLayer& layer, const FeatureQuery& query, const char* key, const std::string& asked,
             const char* usual) {
    OGRFeatureDefn& fields = *layer.GetLayerDefn();
    const int field = fields.GetFieldIndex(asked.empty() ? usual : asked.c_str());
    if (field >= 0 || asked.empty()) return field;
    std::string known;
    for (int i = 0; i < fields.GetFieldCount(); ++i)
        known += (known.empty() ? "" : ", ") + std::string(fields.GetFieldDefn(i)->GetNameRef());
    throw refusal(query, key, asked, fmt::format("is not a field of layer {}", layer.GetName()),
                  known.empty() ? "it has no fields" : "name one of " + known);
}

OGRSpatialReference system_of(OGRLayer& layer, const FeatureQuery& query) {
    if (!query.crs.empty()) return map_reference(reference_from(query.crs, "places.crs"));
    const OGRSpatialReference* own = layer.GetSpatialRef();
    if (own == nullptr)
        throw refusal(query, "places.crs", "", "is missing, as the layer names no coordinate system",
                      "give it, such as EPSG:2326");
    return map_reference(*own);
}

/// GeoJSON counts as degrees unless it says otherwise, and map-grid coordinates are often put into it.
void check_degrees(OGRLayer& layer, const OGRSpatialReference& system, const FeatureQuery& query) {
    OGREnvelope box;
    if (system.IsGeographic() == 0 || layer.GetExtent(&box) != OGRERR_NONE) return;
    const double largest =
        std::max({std::abs(box.MinX), std::abs(box.MaxX), std::abs(box.MinY), std::abs(box.MaxY)});
    if (!(largest <= largest_degree))
        throw refusal(query, "places.crs", "",
                      fmt::format("is missing: coordinates up to {:.10g} are not in degrees, as the layer's "
                                  "system ({}) has it",
                                  largest, system.GetName()),
                      "give it, such as EPSG:2326");
}

/// Leaves out what is far away, so that a layer of a whole town costs little. Where the corridor cannot be
/// brought to the layer's system, nothing is left out.
void look_near(OGRLayer& layer, const LineCorridor& corridor, const OGRSpatialReference& system) {
    const Transformation there(corridor.frame(), system);
    OGREnvelope box;
    for (const Vec2& point : corridor.rim()) {
        const Vec2 at = there(point);
        if (!at.allFinite()) return;
        box.Merge(at.x(), at.y());
    }
    const double x = rim_margin * (box.MaxX - box.MinX), y = rim_margin * (box.MaxY - box.MinY);
    layer.SetSpatialFilterRect(box.MinX - x, box.MinY - y, box.MaxX + x, box.MaxY + y);
}

std::vector<OGRFeatureUniquePtr> features_of(OGRLayer& layer, const FeatureQuery& query) {
    CPLErrorReset();
    const auto refuse_condition = [&] {
        throw refusal(query, "places.where", query.where,
                      "is not a condition on the fields of this layer" + gdal_reason(),
                      "write it as in SQL: kind = 'building'");
    };
    if (!query.where.empty() && layer.SetAttributeFilter(query.where.c_str()) != OGRERR_NONE)
        refuse_condition();
    std::vector<OGRFeatureUniquePtr> features;
    for (auto& feature : layer) features.push_back(std::move(feature));
    if (CPLGetLastErrorType() < CE_Failure) return features;
    if (!query.where.empty()) refuse_condition();
    throw refusal(query, "places.file", "", "cannot be read to its end" + gdal_reason(),
                  "save it again, whole");
}

/// Brings every point of a geometry to another system.
class Bringing : public OGRDefaultGeometryVisitor {
  public:
    explicit Bringing(const Transformation& there) : there_(there) {}

    using OGRDefaultGeometryVisitor::visit;
    void visit(OGRPoint* point) override {
        if (point->IsEmpty() != 0) return;
        const Vec2 at = there_({point->getX(), point->getY()});
        all_finite = all_finite && at.allFinite();
        point->setX(at.x());
        point->setY(at.y());
    }

    bool all_finite = true;

  private:
    const Transformation& there_;
};

/// Null where the feature has no geometry.
std::unique_ptr<OGRGeometry> brought(const OGRFeature& feature, const Transformation& there,
                                     const FeatureQuery& query) {
    const OGRGeometry* drawn = feature.GetGeometryRef();
    if (drawn == nullptr || drawn->IsEmpty() != 0) return nullptr;
    std::unique_ptr<OGRGeometry> geometry(drawn->hasCurveGeometry() != 0 ? drawn->getLinearGeometry()
                                                                         : drawn->clone());
    geometry->flattenTo2D();
    geometry->assignSpatialReference(nullptr);
    Bringing bringing(there);
    geometry->accept(&bringing);
    if (!bringing.all_finite)
        throw InputError(
            {query.file, 0, fmt::format("feature {}", feature.GetFID()), drawn->getGeometryName()},
            "has coordinates that cannot be brought to the section's system",
            "check its coordinates, or leave it out with places.where");
    if (geometry->IsValid() == 0) geometry.reset(geometry->MakeValid());
    return geometry;
}

std::string text_in(const OGRFeature& feature, int field, const FeatureQuery& query) {
    if (field < 0 || feature.IsFieldSetAndNotNull(field) == 0) return {};
    std::string text = feature.GetFieldAsString(field);
    if (text.size() > longest_text)
        throw InputError(
            {query.file, 0, fmt::format("feature {}", feature.GetFID()), ""},
            fmt::format("has a {} of {} bytes", feature.GetFieldDefnRef(field)->GetNameRef(), text.size()),
            fmt::format("valid: up to {}", longest_text));
    return text;
}

std::optional<std::pair<double, double>> stretch_of(const LineCorridor& corridor, const OGRFeature& feature,
                                                    const Transformation& there, const FeatureQuery& query) {
    const std::unique_ptr<OGRGeometry> geometry = brought(feature, there, query);
    if (!geometry) return std::nullopt;
    try {
        return corridor.stretch_of(*geometry);
    } catch (const std::invalid_argument&) {
        throw InputError(
            {query.file, 0, fmt::format("feature {}", feature.GetFID()), geometry->getGeometryName()},
            "has a geometry that cannot be cut" + gdal_reason(),
            "draw it anew, or leave it out with places.where");
    }
}

}  // namespace

std::vector<NearFeature> features_near(const MapLine& line, const FeatureQuery& query) {
    const QuietGdal quiet;
    const auto data = open_dataset(query.file, GDAL_OF_VECTOR,
                                   "give a layer of places, such as a GeoPackage or a shapefile");
    OGRLayer& layer = asked_layer(*data, query);
    const int name = field_of(layer, query, "places.name_field", query.name_field, "name");
    const int kind = field_of(layer, query, "places.kind_field", query.kind_field, "kind");
    const OGRSpatialReference system = system_of(layer, query);
    check_degrees(layer, system, query);
    const LineCorridor corridor(line, query.max_offset_m);
    const Transformation there(system, corridor.frame());
    if (!there.exists())
        throw refusal(query, "places.crs", system.GetName(), "cannot be brought to that of the section",
                      "give a system of the same place");
    look_near(layer, corridor, system);
    std::vector<NearFeature> near;
    for (const OGRFeatureUniquePtr& feature : features_of(layer, query))
        if (const auto stretch = stretch_of(corridor, *feature, there, query))
            near.push_back({static_cast<long>(feature->GetFID()), text_in(*feature, name, query),
                            text_in(*feature, kind, query), stretch->first, stretch->second});
    return near;
}

}  // namespace runout
