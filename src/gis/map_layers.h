#pragma once

#include <string>
#include <vector>

#include "core/output_file.h"
#include "gis/map_line.h"

namespace runout {

enum class GeometryKind { point, line, polygon };

/// One thing on the map: a point, a chain of points, or a ring whose first point is not repeated. Without
/// points it has attributes only.
struct MapFeature {
    Polyline points;
    std::vector<Attribute> attributes;  ///< NaN and nothing are written as NULL
};

/// Features of one kind. The fields of the layer are all attributes of its features, in the order they come.
struct MapLayer {
    std::string name;
    std::string title;  ///< for people
    GeometryKind kind = GeometryKind::line;
    std::vector<MapFeature> features;
    std::string style;  ///< QGIS layer style (QML)
};

/// Layers whose points are in the coordinate system `crs` (WKT or "EPSG:2326").
struct MapSheet {
    std::string crs;
    std::vector<MapLayer> layers;
};

/// Writes the layers that have features, whole or not at all and by the rules of write_output_file:
/// - .gpkg: one layer each, in `target_crs` (empty: as they are), with the table of styles that QGIS reads;
/// - .geojson, .json: one collection in WGS 84 (RFC 7946), the member `layer` telling which one a feature
///   belongs to.
/// Throws InputError: another ending, a place that cannot or must not be written, a GeoPackage that another
/// program has open, an unknown coordinate system.
void write_map(const std::string& path, const MapSheet& sheet, const std::string& target_crs,
               const OutputRules& rules = {});

/// Throws InputError when write_map would refuse that place, before the work.
void check_map_path(const std::string& path, const std::string& target_crs, const OutputRules& rules = {});

}  // namespace runout
