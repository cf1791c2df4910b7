#include "gis/gdal_access.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <mutex>
#include <vector>

#include "gis/drivers.h"
#include "gis/network.h"
#include "gis/virtual_sources.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

// GDAL would take a twentieth of the machine for blocks it has read. A section touches few of them.
constexpr GIntBig block_cache_bytes = 48 * 1024 * 1024;

/// A scale factor further than this from 1 is no detail of a survey.
constexpr double true_scale = 1e-3;

/// No place on a map lies further from the origin of its system, in whatever unit.
constexpr double farthest_coordinate = 1e9;

void set_up_gdal() {
    CPLSetConfigOption("GDAL_VRT_ENABLE_PYTHON", "NO");
    CPLSetConfigOption("GPX_ELE_AS_25D", "YES");  // else a track has no elevations
    CPLSetConfigOption("GML_PARSER", "EXPAT");    // which fetches no document type from elsewhere
    register_drivers();
    if (!network_is_allowed()) close_network();
}

/// What GDAL is to open: never a text that one of its drivers takes for an address.
std::string local_path(const std::string& path, const std::string& valid) {
    const InputPlace place{path, 0, "", ""};
    if (is_remote(path) && network_is_allowed()) return path.starts_with("/vsi") ? path : "/vsicurl/" + path;
    if (is_remote(path))
        throw InputError(place, "is not a file on this machine",
                         "copy it here first, or give --allow-network");
    if (path.starts_with("/vsi")) return path;  // in an archive
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (!fs::exists(status)) throw InputError(place, "cannot be opened (there is no such file)", valid);
    if (!fs::is_regular_file(status) && !fs::is_directory(status))
        throw InputError(place, "is neither a file nor a folder", valid);
    return fs::absolute(path).string();
}

bool is_virtual(const char* driver) {
    return EQUAL(driver, "VRT") || EQUAL(driver, "OGR_VRT");
}

/// Names of the drivers that may open a file, and that are what it looks like.
std::vector<const char*> drivers_for(const std::string& path, unsigned kind) {
    const char* const* allowed = (kind & GDAL_OF_RASTER) != 0 ? raster_drivers() : line_drivers();
    GDALDriverH found = GDALIdentifyDriverEx(path.c_str(), kind, allowed, nullptr);
    const bool virtual_file = found != nullptr && is_virtual(GDALGetDescription(found));
    std::vector<const char*> names;
    for (const char* const* name = allowed; *name != nullptr; ++name)
        if (is_virtual(*name) == virtual_file) names.push_back(*name);
    names.push_back(nullptr);
    return names;
}

/// Options that keep drivers from guessing, writing beside the file, and trusting what it computes.
std::vector<const char*> open_options(const std::string& path, unsigned kind,
                                      const std::vector<const char*>& drivers) {
    if ((kind & GDAL_OF_VECTOR) == 0) return {nullptr};
    GDALDriverH found = GDALIdentifyDriverEx(path.c_str(), kind, drivers.data(), nullptr);
    const std::string name = found != nullptr ? GDALGetDescription(found) : "";
    if (name == "GeoJSON") return {"NATIVE_DATA=YES", nullptr};
    if (name == "GML") return {"WRITE_GFS=NO", "DOWNLOAD_SCHEMA=NO", nullptr};
    if (name == "GPKG") return {"PRELUDE_STATEMENTS=PRAGMA trusted_schema=OFF", nullptr};
    return {nullptr};
}

/// Without its list PROJ takes every system for none, and GDAL lines without one for degrees.
void need_coordinate_systems() {
    static const bool found = [] {
        OGRSpatialReference probe;
        return probe.importFromEPSG(4326) == OGRERR_NONE;
    }();
    if (!found)
        throw InputError({"", 0, "PROJ_DATA", ""}, "leads to no list of coordinate systems (proj.db)",
                         "leave PROJ_DATA and PROJ_LIB unset, or let them name the folder that has it");
}

}  // namespace

QuietGdal::QuietGdal() {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    static std::once_flag once;
    std::call_once(once, set_up_gdal);
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
    need_coordinate_systems();
    CPLErrorReset();
    const std::string local = local_path(path, valid);
    const std::vector<const char*> drivers = drivers_for(local, kind);
    if (is_virtual(drivers.front()) && !network_is_allowed()) check_virtual_sources(local);
    const std::vector<const char*> options = open_options(local, kind, drivers);
    GDALDatasetUniquePtr data(GDALDataset::Open(local.c_str(),
                                                kind | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                                drivers.data(), options.data(), nullptr));
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
    need_coordinate_systems();
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
    // GDAL takes whole turns off a longitude one by one.
    const bool on_earth = point.allFinite() && point.cwiseAbs().maxCoeff() <= farthest_coordinate;
    double x = point.x();
    double y = point.y();
    if (on_earth && steps_ && steps_->Transform(1, &x, &y) != 0) return {x, y};
    return Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
}

namespace {

OGRSpatialReference transverse_mercator(const OGRSpatialReference& reference, const Vec2& centre) {
    OGRSpatialReference geographic;
    geographic.CopyGeogCSFrom(&reference);
    const Vec2 degrees = Transformation(reference, map_reference(geographic))(centre);
    OGRSpatialReference local;
    local.CopyGeogCSFrom(&reference);
    local.SetTM(degrees.y(), degrees.x(), 1.0, 0.0, 0.0);
    return map_reference(local);
}

/// Greatest and least metres on the ground in a metre of the system, over all directions at a place.
std::array<double, 2> scales_at(const Vec2& place, double step, const Transformation& to_ground,
                                double metres) {
    const Vec2 middle = to_ground(place);
    const Vec2 east = (to_ground(place + Vec2(step, 0)) - middle) / metres;
    const Vec2 north = (to_ground(place + Vec2(0, step)) - middle) / metres;
    const double area = std::abs(east.x() * north.y() - north.x() * east.y());
    const double sum = east.squaredNorm() + north.squaredNorm();  // of the squares of both
    const double apart = std::sqrt(std::max(0.0, sum * sum / 4 - area * area));
    return {std::sqrt(sum / 2 + apart), std::sqrt(std::max(0.0, sum / 2 - apart))};
}

bool has_true_scale(const OGRSpatialReference& reference, const Transformation& to_ground,
                    const Polyline& places) {
    constexpr double step_m = 10;
    const double step = step_m / reference.GetLinearUnits();
    return std::ranges::all_of(places, [&](const Vec2& place) {
        const auto [greatest, least] = scales_at(place, step, to_ground, step_m);
        // NaN: the system does not hold there, and its metres mean nothing.
        return std::abs(greatest - 1) <= true_scale && std::abs(least - 1) <= true_scale;
    });
}

}  // namespace

OGRSpatialReference metric_reference(const OGRSpatialReference& reference, const Vec2& centre,
                                     const Polyline& places) {
    if (reference.IsGeographic() != 0) return transverse_mercator(reference, centre);
    if (reference.IsProjected() == 0) return reference;  // a local system knows no ellipsoid
    const OGRSpatialReference local = transverse_mercator(reference, centre);
    const Transformation to_ground(reference, local);
    if (!to_ground.exists() || has_true_scale(reference, to_ground, places)) return reference;
    return local;
}

MetricFrame::MetricFrame(const OGRSpatialReference& reference, const Vec2& centre, const Polyline& places)
    : MetricFrame(reference, metric_reference(reference, centre, places)) {}

MetricFrame::MetricFrame(const OGRSpatialReference& reference, const OGRSpatialReference& metric)
    : unit_m(metric.GetLinearUnits()),
      is_the_system(reference.IsSame(&metric) != 0),
      transformation(reference, metric) {}

}  // namespace runout
