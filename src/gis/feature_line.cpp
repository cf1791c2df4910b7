#include "gis/feature_line.h"

#include <cpl_json.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "gis/gdal_access.h"

namespace runout {
namespace {

/// Degrees have no more than three digits.
constexpr double largest_degree = 360;

std::string geometry_name(const OGRGeometry* geometry) {
    return geometry != nullptr ? geometry->getGeometryName() : "no geometry";
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

bool is_number(const CPLJSONObject& value) {
    const auto type = value.GetType();
    return type == CPLJSONObject::Type::Integer || type == CPLJSONObject::Type::Long ||
           type == CPLJSONObject::Type::Double;
}

/// Which positions of a line in GeoJSON have a third number, for a feature as its file has it. GDAL reads a
/// missing one as 0. Empty where the text holds no line of one part.
std::vector<bool> has_third_number(const std::string& feature) {
    CPLJSONDocument document;
    if (feature.empty() || !document.LoadMemory(feature)) return {};
    const CPLJSONObject geometry = document.GetRoot().GetObj("geometry");
    CPLJSONArray positions = geometry.GetArray("coordinates");
    if (geometry.GetString("type") == "MultiLineString" && positions.Size() == 1)
        positions = positions[0].ToArray();
    else if (geometry.GetString("type") != "LineString")
        return {};
    std::vector<bool> found;
    for (int i = 0; i < positions.Size(); ++i) {
        const CPLJSONArray position = positions[i].ToArray();
        found.push_back(position.Size() > 2 && is_number(position[2]));
    }
    return found;
}

}  // namespace

InputPlace place_of(const LineQuery& query, const OGRFeature& feature, const std::string& value) {
    return {query.file, 0, fmt::format("feature {}", feature.GetFID()), value};
}

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

OGRSpatialReference reference_of(OGRLayer& layer, const LineQuery& query) {
    if (!query.crs.empty()) return reference_from(query.crs, "section.line_crs");
    const OGRSpatialReference* own = layer.GetSpatialRef();
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

std::vector<Attribute> attributes_of(const OGRFeature& feature) {
    std::vector<Attribute> attributes;
    for (int i = 0; i < feature.GetFieldCount(); ++i)
        attributes.push_back({feature.GetFieldDefnRef(i)->GetNameRef(), field_value(feature, i)});
    return attributes;
}

std::string height_datum(const OGRFeature& feature, const std::string& driver) {
    if (driver != "LIBKML") return {};
    const int field = feature.GetFieldIndex("altitudeMode");
    const std::string mode =
        field >= 0 && feature.IsFieldSetAndNotNull(field) != 0 ? feature.GetFieldAsString(field) : "";
    if (mode == "absolute") return {};
    return mode.empty() ? "clampToGround" : mode;
}

std::vector<double> elevations_of(const OGRLineString& line, const OGRFeature& feature) {
    const char* text = feature.GetNativeData();
    const std::vector<bool> given = has_third_number(text != nullptr ? text : "");
    const bool known = given.size() == static_cast<std::size_t>(line.getNumPoints());
    if (known ? std::ranges::find(given, true) == given.end() : line.Is3D() == 0) return {};
    std::vector<double> elevations;
    for (int i = 0; i < line.getNumPoints(); ++i) {
        const bool missing = known && !given[static_cast<std::size_t>(i)];
        elevations.push_back(missing ? std::numeric_limits<double>::quiet_NaN() : line.getZ(i));
    }
    return elevations;
}

}  // namespace runout
