#pragma once

#include <ogr_geometry.h>

#include <string>
#include <vector>

#include "gis/drawing.h"

// Shared by the files of this room only: it shows GDAL's own types.

namespace runout {

/// Points taken from a drawing so far; throws InputError beyond most_drawn_points.
class DrawnPointCount {
  public:
    explicit DrawnPointCount(std::string file) : file_(std::move(file)) {}
    void add(std::size_t points);

  private:
    std::string file_;
    std::size_t count_ = 0;
};

enum class Parts { one, many };

/// The lines in a geometry, without their layer: of a line, and with `many` of a multi-line as well. Other
/// geometries, and none at all, have none.
std::vector<DrawnLine> drawn_lines(const OGRGeometry* geometry, DrawnPointCount& count,
                                   Parts parts = Parts::one);

}  // namespace runout
