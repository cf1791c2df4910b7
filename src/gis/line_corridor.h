#pragma once

#include <ogr_geometry.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "gis/map_line.h"

// Shared by the files of this room only: it shows GDAL's own types.

namespace runout {

/// The ground within a distance of a section line, in a frame of true lengths about its middle. Beyond the
/// ends chainages go on along the straight continuation.
class LineCorridor {
  public:
    LineCorridor(const MapLine& line, double half_width_m);

    /// The frame that stretch_of() takes geometries in.
    [[nodiscard]] const OGRSpatialReference& frame() const { return frame_; }
    /// Its rim, in the frame.
    [[nodiscard]] Polyline rim() const;
    /// Least and greatest chainage of what of a geometry is in the corridor; none: nothing is. Throws
    /// std::invalid_argument where it cannot be cut.
    [[nodiscard]] std::optional<std::pair<double, double>> stretch_of(const OGRGeometry& geometry) const;

  private:
    [[nodiscard]] double chainage_of(const Vec2& point) const;

    OGRSpatialReference frame_;
    Polyline points_;
    std::vector<double> chainage_m_;
    OGRLineString axis_;
    double finest_;  ///< of pieces to project, in units of the frame
    std::unique_ptr<OGRGeometry> area_;
};

/// All points of a geometry.
Polyline vertices_of(const OGRGeometry& geometry);

}  // namespace runout
