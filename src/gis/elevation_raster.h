#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gis/map_line.h"

namespace runout {

/// How an elevation follows from the cells around a point.
enum class Interpolation {
    bilinear,  ///< from 2 x 2 cell centres; exact on planes
    cubic,     ///< cubic convolution (Keys 1981, a = -1/2) from 4 x 4; exact on parabolic surfaces
};

struct RasterOptions {
    Interpolation interpolation = Interpolation::bilinear;
    std::string crs{};             ///< replaces what the file says, "EPSG:2326"
    std::string elevation_unit{};  ///< m, ft, us-ft; empty: metres, unless the file speaks of another unit
};

/// Metres in a unit named m, ft or us-ft.
double unit_m(const std::string& unit);

/// Throws InputError, the sentence about feet: elevations of `file` are in a unit of `stated_m` metres, and
/// no section.elevation_unit confirms it.
void refuse_unconfirmed_unit(const std::string& file, double stated_m);

/// The ground as a raster has it. Only the cells about a point are read, so the size of the raster does not
/// matter.
class ElevationRaster {
  public:
    /// Band 1 of any raster that GDAL reads. Throws InputError: unreadable, no band, no place on the map, no
    /// coordinate system, feet that section.elevation_unit does not confirm.
    ElevationRaster(const std::string& path, const RasterOptions& options);
    ~ElevationRaster();
    ElevationRaster(const ElevationRaster&) = delete;
    ElevationRaster& operator=(const ElevationRaster&) = delete;

    /// Elevation in metres at each point of a line in any coordinate system. Values belong to cell centres;
    /// within half a cell of the edge the outermost value holds. Throws InputError that names chainage and
    /// place: a point outside the raster; a cell without data, or with a value that is no elevation, where it
    /// is needed; a raster stored in pieces too large to read.
    [[nodiscard]] std::vector<double> elevations(const MapLine& line) const;

    /// Side of a cell at the middle of the line: square root of its area, m. Throws InputError when the line
    /// cannot be brought to the coordinate system of the raster.
    [[nodiscard]] double cell_size_m(const MapLine& line) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace runout
