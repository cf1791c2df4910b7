#pragma once

#include <cpl_error.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <memory>
#include <string>

#include "core/geometry.h"
#include "core/input_error.h"

// Shared by the files of this room only: it shows GDAL's own types.

namespace runout {

/// GDAL with its drivers, reporting through return values and not on standard error as well.
class QuietGdal {
  public:
    QuietGdal();
    ~QuietGdal();
    QuietGdal(const QuietGdal&) = delete;
    QuietGdal& operator=(const QuietGdal&) = delete;
};

/// Opens a local file for reading. `kind` is GDAL_OF_RASTER or GDAL_OF_VECTOR. Throws InputError: no such
/// file, none of the drivers that may (gis/drivers.h) reads it, or it refers to what it must not
/// (gis/virtual_sources.h).
GDALDatasetUniquePtr open_dataset(const std::string& path, unsigned kind, const std::string& valid);

/// GDAL's last complaint in brackets, or nothing.
std::string gdal_reason();

/// The horizontal part, with x to the east and y to the north whatever the authority says.
OGRSpatialReference map_reference(const OGRSpatialReference& reference);

/// From "EPSG:2326", WKT or a PROJ string. Throws InputError that names `key`.
OGRSpatialReference reference_from(const std::string& text, const std::string& key);

std::string wkt_of(const OGRSpatialReference& reference);

/// Metres in a vertical unit of the system; 0 when it says nothing of heights.
double vertical_unit_m(const OGRSpatialReference& reference);

/// Brings points of one system to another; leaves them alone where the two are the same.
class Transformation {
  public:
    Transformation(const OGRSpatialReference& from, const OGRSpatialReference& to);

    /// False when there is no way from one system to the other.
    [[nodiscard]] bool exists() const { return same_ || steps_; }
    /// NaN where the transformation fails, or the point lies beyond 1e9 units.
    [[nodiscard]] Vec2 operator()(const Vec2& point) const;

  private:
    bool same_;
    std::unique_ptr<OGRCoordinateTransformation> steps_;
};

/// A system in which lengths about `centre` (in `reference`) are true: the system itself where its scale
/// factor is within 0.1 % of 1 in every direction at each of `places`, else a transverse Mercator through the
/// centre. A system in degrees has no metres of its own.
OGRSpatialReference metric_reference(const OGRSpatialReference& reference, const Vec2& centre,
                                     const Polyline& places);

/// Brings points to metric_reference(), in metres.
struct MetricFrame {
    MetricFrame(const OGRSpatialReference& reference, const Vec2& centre, const Polyline& places);

    [[nodiscard]] Vec2 operator()(const Vec2& point) const { return unit_m * transformation(point); }

    double unit_m;       ///< metres in a unit of the frame
    bool is_the_system;  ///< the frame is the system of the points itself
    Transformation transformation;

  private:
    MetricFrame(const OGRSpatialReference& reference, const OGRSpatialReference& metric);
};

}  // namespace runout
