#include "gis/section_line.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "gis/feature_line.h"
#include "gis/gdal_access.h"
#include "gis/line_layer.h"

namespace runout {
namespace {

/// Of a line that is measured on the ellipsoid. A straight piece of this length is within a micrometre of the
/// geodesic.
constexpr double longest_piece_m = 10;
constexpr double most_pieces = 1e6;

/// Vertices nearer than this are one place.
constexpr double nearest_m = 1e-7;

/// At so many vertices of a line the scale of its system is looked at.
constexpr std::size_t places_looked_at = 100;

/// Vertices of a line of two or more, about `most` of them, the first and the last among them.
Polyline places_of(const OGRLineString& line, std::size_t most) {
    Polyline places;
    const auto count = static_cast<std::size_t>(line.getNumPoints());
    const std::size_t step = std::max<std::size_t>(1, count / most);
    for (std::size_t i = 0; i < count; i += step) {
        const int k = static_cast<int>(i);
        places.emplace_back(line.getX(k), line.getY(k));
    }
    places.emplace_back(line.getX(line.getNumPoints() - 1), line.getY(line.getNumPoints() - 1));
    return places;
}

MetricFrame metric_frame(const OGRLineString& line, const OGRSpatialReference& reference) {
    OGRPoint middle;
    line.Value(line.get_Length() / 2, &middle);
    return {reference, {middle.getX(), middle.getY()}, places_of(line, places_looked_at)};
}

/// Draws the line to its next vertex. A chainage that is not finite says that it cannot be.
void draw_to(const Vec2& to, const MetricFrame& metric, MapLine& map) {
    if (map.points.empty()) {
        map.points.push_back(to);
        map.chainage_m.push_back(0);
        return;
    }
    const Vec2 from = map.points.back();
    const double length = (metric(to) - metric(from)).norm();
    if (length < nearest_m) return;
    const double pieces = metric.is_the_system ? 1 : std::max(1.0, std::ceil(length / longest_piece_m));
    if (pieces > most_pieces) {
        map.chainage_m.back() = std::numeric_limits<double>::infinity();
        return;
    }
    for (double k = 1; k <= pieces; ++k) {
        const Vec2 at = k == pieces ? to : Vec2(from + k / pieces * (to - from));
        map.chainage_m.push_back(map.chainage_m.back() + (metric(at) - metric(map.points.back())).norm());
        map.points.push_back(at);
    }
}

void lay_out(const OGRLineString& line, const MetricFrame& metric, const std::vector<double>& elevations,
             SectionLine& section) {
    for (int i = 0; i < line.getNumPoints(); ++i) {
        const Vec2 to(line.getX(i), line.getY(i));
        draw_to(to, metric, section.map);
        if (!elevations.empty())
            section.vertices.push_back(
                {to, section.map.chainage_m.back(), elevations[static_cast<std::size_t>(i)]});
    }
}

SectionLine section_line(const OGRFeature& feature, OGRLayer& layer, const LineQuery& query,
                         const std::string& driver) {
    const OGRLineString line = line_of(feature, query);
    check_shape(line, query, feature);
    const OGRSpatialReference whole = reference_of(layer, query);
    const OGRSpatialReference reference = map_reference(whole);
    check_degrees(reference, line, query, feature);
    SectionLine section;
    section.layer = layer.GetName();
    section.feature_id = static_cast<long>(feature.GetFID());
    section.elevation_unit_m = vertical_unit_m(whole);
    section.height_datum = height_datum(feature, driver);
    section.map.crs = wkt_of(reference);
    section.map.attributes = attributes_of(feature);
    lay_out(line, metric_frame(line, reference), elevations_of(line, feature), section);
    if (!std::isfinite(section.map.chainage_m.back()) || section.map.points.size() < 2)
        throw InputError(place_of(query, feature, "LINESTRING"),
                         "lies where its coordinate system does not hold, or is thousands of kilometres long",
                         "check the coordinates");
    return section;
}

/// What of a feature can be drawn that is no section.
MapLine sketch_of(const OGRFeature& feature, OGRLayer& layer, const LineQuery& query) {
    MapLine sketch{"", {}, {}, attributes_of(feature)};
    try {
        const OGRLineString line = line_of(feature, query);
        if (line.getNumPoints() < 2) return sketch;
        Polyline places = places_of(line, static_cast<std::size_t>(line.getNumPoints()));
        places.pop_back();  // the last stands twice
        if (!std::ranges::all_of(places, [](const Vec2& at) { return at.allFinite(); })) return sketch;
        sketch.crs = wkt_of(map_reference(reference_of(layer, query)));
        sketch.points = std::move(places);
        for (std::size_t i = 0; i < sketch.points.size(); ++i)
            sketch.chainage_m.push_back(
                i == 0 ? 0.0 : sketch.chainage_m.back() + (sketch.points[i] - sketch.points[i - 1]).norm());
    } catch (const InputError&) {
        // then there is nothing to draw
    }
    return sketch;
}

LineFeature line_feature(const OGRFeature& feature, OGRLayer& layer, const LineQuery& query,
                         const std::string& driver) {
    LineFeature listed{query.file, layer.GetName(), static_cast<long>(feature.GetFID()), {}, {}};
    try {
        listed.drawn = section_line(feature, layer, query, driver).map;
    } catch (const InputError& refusal) {
        listed.refusal = refusal;
        listed.drawn = sketch_of(feature, layer, query);
    }
    return listed;
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

GDALDatasetUniquePtr open_lines(const LineQuery& query) {
    return open_dataset(query.file, GDAL_OF_VECTOR,
                        "give a file with section lines, such as a GeoPackage or a shapefile");
}

/// Calls take(feature) for each feature that is asked for. Throws InputError when there is none.
template <class Take>
void for_features(OGRLayer& layer, const LineQuery& query, const Take& take) {
    CPLErrorReset();
    if (query.feature_id) {
        const OGRFeatureUniquePtr feature(layer.GetFeature(*query.feature_id));
        if (!feature) refuse_empty(layer, query, true);
        take(*feature);
        return;
    }
    if (!query.where.empty() && layer.SetAttributeFilter(query.where.c_str()) != OGRERR_NONE)
        refuse_condition(query);
    bool any = false;
    for (const auto& feature : layer) {
        any = true;
        take(*feature);
    }
    if (!any) refuse_empty(layer, query, false);
}

}  // namespace

std::vector<LineFeature> list_section_lines(const LineQuery& query) {
    const QuietGdal quiet;
    const auto data = open_lines(query);
    const std::string driver = data->GetDriverName();
    OGRLayer& layer = layer_of(*data, query);
    std::vector<LineFeature> features;
    for_features(layer, query, [&](const OGRFeature& feature) {
        features.push_back(line_feature(feature, layer, query, driver));
    });
    return features;
}

SectionLine read_section_line(const LineQuery& query) {
    const QuietGdal quiet;
    const auto data = open_lines(query);
    const std::string driver = data->GetDriverName();
    OGRLayer& layer = layer_of(*data, query);
    std::optional<SectionLine> line;
    int count = 0;
    for_features(layer, query, [&](const OGRFeature& feature) {
        if (++count == 1) line = section_line(feature, layer, query, driver);
    });
    if (count == 1) return std::move(*line);
    throw InputError({query.file, 0, "section.line", ""}, fmt::format("has {} lines", count),
                     "choose one with section.feature_id or section.where");
}

}  // namespace runout
