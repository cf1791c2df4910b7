#pragma once

#include <ogrsf_frmts.h>

#include <string>
#include <vector>

#include "gis/section_line.h"

// Shared by the files of this room only: it shows GDAL's own types. What a feature says as a section line.

namespace runout {

/// Where a feature is at fault.
InputPlace place_of(const LineQuery& query, const OGRFeature& feature, const std::string& value);

/// The one line in the geometry of a feature. Throws InputError: another geometry, several parts.
OGRLineString line_of(const OGRFeature& feature, const LineQuery& query);

/// Throws InputError: a coordinate that is not finite, no length, a line that closes or crosses itself.
void check_shape(const OGRLineString& line, const LineQuery& query, const OGRFeature& feature);

/// The coordinate system of a layer, or the one that the query gives. Throws InputError when there is none.
OGRSpatialReference reference_of(OGRLayer& layer, const LineQuery& query);

/// Throws InputError when coordinates are no degrees though their system counts in degrees.
void check_degrees(const OGRSpatialReference& reference, const OGRLineString& line, const LineQuery& query,
                   const OGRFeature& feature);

std::vector<Attribute> attributes_of(const OGRFeature& feature);

/// What heights are counted from where that is no level, in words of KML, whose default is to have none; else
/// empty.
std::string height_datum(const OGRFeature& feature, const std::string& driver);

/// Elevation of each vertex, NaN where the file gives none; empty for a line in the plane.
std::vector<double> elevations_of(const OGRLineString& line, const OGRFeature& feature);

}  // namespace runout
