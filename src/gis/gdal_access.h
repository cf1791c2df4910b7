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

/// Opens for reading. `kind` is GDAL_OF_RASTER or GDAL_OF_VECTOR. Throws InputError: no such file, or none of
/// GDAL's drivers reads it.
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
    /// NaN where the transformation fails.
    [[nodiscard]] Vec2 operator()(const Vec2& point) const;

  private:
    bool same_;
    std::unique_ptr<OGRCoordinateTransformation> steps_;
};

/// A system in which lengths about `centre` (in `reference`) are true: the system itself unless it counts in
/// degrees, else a transverse Mercator through the centre.
OGRSpatialReference metric_reference(const OGRSpatialReference& reference, const Vec2& centre);

/// Brings points to metric_reference(), in metres.
struct MetricFrame {
    MetricFrame(const OGRSpatialReference& reference, const Vec2& centre);

    [[nodiscard]] Vec2 operator()(const Vec2& point) const { return unit_m * transformation(point); }

    double unit_m;  ///< metres in a unit of the frame
    Transformation transformation;
};

}  // namespace runout
