#include "gis/map_metric.h"

#include <fmt/format.h>
#include <ogr_geometry.h>

#include "gis/gdal_access.h"

namespace runout {
namespace {

constexpr const char* crs_option = "coordinate system";

OGRSpatialReference horizontal(const std::string& crs) {
    return map_reference(reference_from(crs, crs_option));
}

}  // namespace

struct MapMetric::Impl {
    OGRSpatialReference reference;
    OGRSpatialReference local;
    double unit_m;
    Transformation there;
    Transformation back;

    Impl(const std::string& crs, const Vec2& centre)
        : reference(horizontal(crs)),
          local(metric_reference(reference, centre, {centre})),
          unit_m(local.GetLinearUnits()),
          there(reference, local),
          back(local, reference) {}
};

MapMetric::MapMetric(const std::string& crs, const Vec2& centre) {
    const QuietGdal quiet;
    impl_ = std::make_unique<Impl>(crs, centre);
}

MapMetric::~MapMetric() = default;

Vec2 MapMetric::metres(const Vec2& map) const {
    return impl_->unit_m * impl_->there(map);
}

Vec2 MapMetric::map(const Vec2& metres) const {
    return impl_->back(metres / impl_->unit_m);
}

MapLine in_system(const MapLine& line, const std::string& crs) {
    const QuietGdal quiet;
    if (line.crs == crs) return line;
    const OGRSpatialReference target = horizontal(crs);
    const Transformation transformation(horizontal(line.crs), target);
    MapLine brought = line;
    brought.crs = crs;
    for (Vec2& point : brought.points) point = transformation(point);
    for (const Vec2& point : brought.points)
        if (!point.allFinite())
            throw InputError({"", 0, crs_option, target.GetName()},
                             fmt::format("cannot be reached from that of a section{}", gdal_reason()),
                             "give a system of the same place");
    return brought;
}

bool is_valid_ring(const Polyline& ring) {
    const QuietGdal quiet;
    OGRLinearRing closed;
    for (const Vec2& point : ring) closed.addPoint(point.x(), point.y());
    closed.closeRings();
    OGRPolygon polygon;
    polygon.addRing(&closed);
    return polygon.IsValid() != 0;
}

}  // namespace runout
