#include "gis/section_line.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "gis/gdal_access.h"

namespace runout {
namespace {

/// Of a line in degrees. A straight piece of this length is within a micrometre of the geodesic.
constexpr double longest_piece_m = 10;

/// Degrees have no more than three digits.
constexpr double largest_degree = 360;

std::string layer_names(GDALDataset& data) {
    std::string names;
    for (OGRLayer* layer : data.GetLayers())
        names += (names.empty() ? "" : ", ") + std::string(layer->GetName());
    return names;
}

OGRLayer& layer_of(GDALDataset& data, const LineQuery& query) {
    const int count = data.GetLayerCount();
    if (count == 0) throw InputError({query.file, 0, "", ""}, "has no layer", "draw the sections as lines");
    if (query.layer.empty()) {
        if (count == 1) return *data.GetLayer(0);
        throw InputError({query.file, 0, "section.layer", ""},
                         fmt::format("is missing: there are {} layers", count),
                         "name one of " + layer_names(data));
    }
    OGRLayer* layer = data.GetLayerByName(query.layer.c_str());
    if (layer == nullptr)
        throw InputError({query.file, 0, "section.layer", query.layer}, "is not a layer of this file",
                         "name one of " + layer_names(data));
    return *layer;
}

/// Where a feature is at fault.
InputPlace place_of(const LineQuery& query, const OGRFeature& feature, const std::string& value) {
    return {query.file, 0, fmt::format("feature {}", feature.GetFID()), value};
}

std::string geometry_name(const OGRGeometry* geometry) {
    return geometry != nullptr ? geometry->getGeometryName() : "no geometry";
}

/// The one line in a geometry.
OGRLineString line_of(const OGRFeature& feature, const LineQuery& query) {
    const OGRGeometry* geometry = feature.GetGeometryRef();
    std::unique_ptr<OGRGeometry> straight;
    if (geometry != nullptr && geometry->hasCurveGeometry() != 0) {
        straight.reset(geometry->getLinearGeometry());
        geometry = straight.get();
    }
    if (geometry != nullptr && wkbFlatten(geometry->getGeometryType()) == wkbMultiLineString) {
        const OGRMultiLineString* lines = geometry->toMultiLineString();
        if (lines->getNumGeometries() > 1)
            throw InputError(place_of(query, feature, geometry_name(geometry)),
                             fmt::format("has {} parts", lines->getNumGeometries()),
                             "draw each section as one line, or split the parts into features");
        geometry = lines->getNumGeometries() == 1 ? lines->getGeometryRef(0) : nullptr;
    }
    if (geometry == nullptr || wkbFlatten(geometry->getGeometryType()) != wkbLineString)
        throw InputError(place_of(query, feature, geometry_name(geometry)), "is not a line",
                         "draw the section as one LineString");
    return *geometry->toLineString();
}

void check_shape(const OGRLineString& line, const LineQuery& query, const OGRFeature& feature) {
    const InputPlace place = place_of(query, feature, "LINESTRING");
    for (const OGRPoint& point : line)
        if (!std::isfinite(point.getX()) || !std::isfinite(point.getY()))
            throw InputError(place, "has a coordinate that is not finite", "draw it anew");
    if (line.getNumPoints() < 2 || !(line.get_Length() > 0))
        throw InputError(place, "has no length", "give it two points or more");
    if (line.get_IsClosed() != 0 || line.IsSimple() == 0)
        throw InputError(place, "closes or crosses itself",
                         "a section runs from one end to the other without meeting itself");
}

OGRSpatialReference reference_of(const OGRLayer& layer, const LineQuery& query) {
    if (!query.crs.empty()) return reference_from(query.crs, "section.line_crs");
    const OGRSpatialReference* own = const_cast<OGRLayer&>(layer).GetSpatialRef();
    if (own != nullptr) return *own;
    throw InputError({query.file, 0, "", ""}, "names no coordinate system",
                     "give section.line_crs, such as EPSG:2326");
}

/// GeoJSON counts as degrees unless it says otherwise, and map-grid coordinates are often put into it.
void check_degrees(const OGRSpatialReference& reference, const OGRLineString& line, const LineQuery& query,
                   const OGRFeature& feature) {
    if (reference.IsGeographic() == 0) return;
    OGREnvelope box;
    line.getEnvelope(&box);
    if (std::max({std::abs(box.MinX), std::abs(box.MaxX), std::abs(box.MinY), std::abs(box.MaxY)}) <=
        largest_degree)
        return;
    throw InputError(
        place_of(query, feature, fmt::format("({:.10g}, {:.10g})", line.getX(0), line.getY(0))),
        fmt::format("is not in degrees, as its coordinate system ({}) has it", reference.GetName()),
        "give section.line_crs, such as EPSG:2326");
}

FieldValue field_value(const OGRFeature& feature, int i) {
    if (feature.IsFieldSetAndNotNull(i) == 0) return {};
    switch (feature.GetFieldDefnRef(i)->GetType()) {
        case OFTInteger:
        case OFTInteger64:
            return static_cast<long>(feature.GetFieldAsInteger64(i));
        case OFTReal:
            return feature.GetFieldAsDouble(i);
        default:
            return std::string(feature.GetFieldAsString(i));
    }
}

std::vector<Attribute> attributes_of(const OGRFeature& feature) {
    std::vector<Attribute> attributes;
    for (int i = 0; i < feature.GetFieldCount(); ++i)
        attributes.push_back({feature.GetFieldDefnRef(i)->GetNameRef(), field_value(feature, i)});
    return attributes;
}

/// Points and chainages; a point that repeats the one before it is dropped.
void lay_out(const OGRLineString& line, const MetricFrame& metric, double longest_piece,
             SectionLine& section) {
    MapLine& map = section.map;
    for (int i = 0; i < line.getNumPoints(); ++i) {
        const Vec2 to(line.getX(i), line.getY(i));
        if (map.points.empty()) {
            map.points.push_back(to);
            map.chainage_m.push_back(0);
            section.elevations.push_back(line.getZ(i));
            continue;
        }
        const Vec2 from = map.points.back();
        if (to == from) continue;
        const double z = section.elevations.back();
        const int pieces =
            std::max(1, static_cast<int>(std::ceil((metric(to) - metric(from)).norm() / longest_piece)));
        for (int k = 1; k <= pieces; ++k) {
            const double share = static_cast<double>(k) / pieces;
            const Vec2 at = k == pieces ? to : Vec2(from + share * (to - from));
            map.chainage_m.push_back(map.chainage_m.back() + (metric(at) - metric(map.points.back())).norm());
            map.points.push_back(at);
            section.elevations.push_back(z + share * (line.getZ(i) - z));
        }
    }
    if (line.Is3D() == 0) section.elevations.clear();
}

SectionLine section_line(const OGRFeature& feature, OGRLayer& layer, const LineQuery& query) {
    const OGRLineString line = line_of(feature, query);
    check_shape(line, query, feature);
    const OGRSpatialReference whole = reference_of(layer, query);
    const OGRSpatialReference reference = map_reference(whole);
    check_degrees(reference, line, query, feature);
    SectionLine section;
    section.layer = layer.GetName();
    section.feature_id = static_cast<long>(feature.GetFID());
    section.elevation_unit_m = vertical_unit_m(whole);
    section.map.crs = wkt_of(reference);
    section.map.attributes = attributes_of(feature);
    OGRPoint middle;
    line.Value(line.get_Length() / 2, &middle);
    const MetricFrame metric(reference, {middle.getX(), middle.getY()});
    const bool degrees = reference.IsGeographic() != 0;
    lay_out(line, metric, degrees ? longest_piece_m : std::numeric_limits<double>::infinity(), section);
    if (!std::isfinite(section.map.chainage_m.back()))
        throw InputError(place_of(query, feature, "LINESTRING"),
                         "lies where its coordinate system does not hold", "check the coordinates");
    return section;
}

[[noreturn]] void refuse_condition(const LineQuery& query) {
    throw InputError({query.file, 0, "section.where", query.where},
                     "is not a condition on the fields of this layer" + gdal_reason(),
                     "write it as in SQL: name = 'A-A'");
}

[[noreturn]] void refuse_empty(OGRLayer& layer, const LineQuery& query, bool condition_holds) {
    // Some drivers find out about the condition only when they look for features.
    if (!query.where.empty() && CPLGetLastErrorType() >= CE_Failure) refuse_condition(query);
    if (query.feature_id)
        throw InputError({query.file, 0, "section.feature_id", fmt::format("{}", *query.feature_id)},
                         fmt::format("is not a feature of layer {}", layer.GetName()),
                         "ogrinfo -al lists the features with their ids");
    if (!query.where.empty() && !condition_holds)
        throw InputError({query.file, 0, "section.where", query.where}, "holds for no feature",
                         "ogrinfo -al lists the features with their fields");
    throw InputError({query.file, 0, "", ""}, fmt::format("has no feature in layer {}", layer.GetName()),
                     "draw the section as one line");
}

}  // namespace

std::vector<SectionLine> read_section_lines(const LineQuery& query) {
    const QuietGdal quiet;
    const auto data =
        open_dataset(query.file, GDAL_OF_VECTOR, "give a vector file that GDAL can read, with section lines");
    OGRLayer& layer = layer_of(*data, query);
    CPLErrorReset();
    if (!query.where.empty() && layer.SetAttributeFilter(query.where.c_str()) != OGRERR_NONE)
        refuse_condition(query);
    std::vector<SectionLine> lines;
    bool any = false;
    for (const auto& feature : layer) {
        any = true;
        if (query.feature_id && feature->GetFID() != *query.feature_id) continue;
        lines.push_back(section_line(*feature, layer, query));
    }
    if (lines.empty()) refuse_empty(layer, query, any);
    return lines;
}

}  // namespace runout
