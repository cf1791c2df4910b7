#include "gis/placed_line.h"

#include <fmt/format.h>

#include <cmath>

#include "gis/gdal_access.h"

namespace runout {
namespace {

constexpr double largest_degree = 360;

InputPlace place_of(const char* key, const Vec2& place) {
    return {"", 0, key, fmt::format("[{:.12g}, {:.12g}]", place.x(), place.y())};
}

void check_place(const char* key, const Vec2& place, const OGRSpatialReference& reference) {
    if (reference.IsGeographic() != 0 && place.cwiseAbs().maxCoeff() > largest_degree)
        throw InputError(place_of(key, place),
                         fmt::format("is not in degrees, as section.crs ({}) has it", reference.GetName()),
                         "give the place as [longitude, latitude], or another section.crs");
}

/// One metre along the line, in metres of the frame.
Vec2 direction(const LinePlacing& placing, const OGRSpatialReference& reference, const MetricFrame& metric) {
    const Vec2 origin = metric(placing.origin);
    if (placing.towards) {
        const Vec2 along = metric(*placing.towards) - origin;
        if (along.norm() == 0)
            throw InputError(place_of("section.towards", *placing.towards), "is the place of section.origin",
                             "give another place on the section line");
        return along.normalized();
    }
    const Vec2 bearing(std::sin(placing.bearing), std::cos(placing.bearing));
    // Grid north of a system in degrees is that of the frame through the origin.
    if (reference.IsGeographic() != 0) return bearing;
    return (metric(placing.origin + bearing) - origin).normalized();
}

}  // namespace

MapLine placed_line(const LinePlacing& placing, Chainage from, Chainage to) {
    const QuietGdal quiet;
    const OGRSpatialReference reference = map_reference(reference_from(placing.crs, "section.crs"));
    check_place("section.origin", placing.origin, reference);
    if (placing.towards) check_place("section.towards", *placing.towards, reference);
    const OGRSpatialReference metres = metric_reference(reference, placing.origin, {placing.origin});
    const MetricFrame metric(reference, placing.origin, {placing.origin});
    const Transformation back(metres, reference);
    const Vec2 along = direction(placing, reference, metric);
    MapLine line{wkt_of(reference), {}, {from.m, to.m}, {}};
    for (const double chainage : line.chainage_m) {
        const Vec2 at = metric(placing.origin) + (Chainage(chainage) - placing.origin_chainage) * along;
        line.points.push_back(back(at / metric.unit_m));
        if (!line.points.back().allFinite())
            throw InputError(place_of("section.origin", placing.origin),
                             fmt::format("lies where section.crs ({}) does not hold", reference.GetName()),
                             "check the coordinates: easting first, or longitude");
    }
    return line;
}

}  // namespace runout
