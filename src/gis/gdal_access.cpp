#include "gis/gdal_access.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

namespace runout {
namespace {

// GDAL would take a twentieth of the machine for blocks it has read. A section touches few of them.
constexpr GIntBig block_cache_bytes = 48 * 1024 * 1024;

}  // namespace

QuietGdal::QuietGdal() {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    GDALAllRegister();  // does nothing the second time
    GDALSetCacheMax64(block_cache_bytes);
}

QuietGdal::~QuietGdal() {
    CPLPopErrorHandler();
}

std::string gdal_reason() {
    const std::string reason = CPLGetLastErrorMsg();
    return reason.empty() ? "" : " (" + reason + ")";
}

GDALDatasetUniquePtr open_dataset(const std::string& path, unsigned kind, const std::string& valid) {
    CPLErrorReset();
    GDALDatasetUniquePtr data(GDALDataset::Open(path.c_str(), kind | GDAL_OF_READONLY));
    if (data) return data;
    throw InputError({path, 0, "", ""}, "cannot be opened" + gdal_reason(), valid);
}

OGRSpatialReference map_reference(const OGRSpatialReference& reference) {
    OGRSpatialReference flat(reference);
    if (flat.IsCompound() != 0) flat.StripVertical();
    flat.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return flat;
}

OGRSpatialReference reference_from(const std::string& text, const std::string& key) {
    OGRSpatialReference reference;
    CPLErrorReset();
    if (text.empty() || reference.SetFromUserInput(text.c_str()) != OGRERR_NONE)
        throw InputError({"", 0, key, text}, "is not a known coordinate system",
                         "name one such as EPSG:2326, or give its WKT");
    reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return reference;
}

std::string wkt_of(const OGRSpatialReference& reference) {
    const std::array<const char*, 2> options = {"FORMAT=WKT2_2019", nullptr};
    char* text = nullptr;
    reference.exportToWkt(&text, options.data());
    std::string wkt = text != nullptr ? text : "";
    CPLFree(text);
    return wkt;
}

double vertical_unit_m(const OGRSpatialReference& reference) {
    if (reference.IsCompound() == 0 && reference.IsVertical() == 0) return 0;
    return reference.GetTargetLinearUnits("VERT_CS");
}

Transformation::Transformation(const OGRSpatialReference& from, const OGRSpatialReference& to)
    : same_(from.IsSame(&to) != 0) {
    if (!same_) steps_.reset(OGRCreateCoordinateTransformation(&from, &to));
}

Vec2 Transformation::operator()(const Vec2& point) const {
    if (same_) return point;
    double x = point.x();
    double y = point.y();
    if (steps_ && steps_->Transform(1, &x, &y) != 0) return {x, y};
    return Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
}

OGRSpatialReference metric_reference(const OGRSpatialReference& reference, const Vec2& centre) {
    if (reference.IsGeographic() == 0) return reference;
    OGRSpatialReference local;
    local.CopyGeogCSFrom(&reference);
    local.SetTM(centre.y(), centre.x(), 1.0, 0.0, 0.0);
    return map_reference(local);
}

MetricFrame::MetricFrame(const OGRSpatialReference& reference, const Vec2& centre)
    : unit_m(reference.IsGeographic() != 0 ? 1.0 : reference.GetLinearUnits()),
      transformation(reference, metric_reference(reference, centre)) {}

}  // namespace runout
