#pragma once

#include <memory>
#include <string>

#include "gis/map_line.h"

namespace runout {

/// Metres on a map: true lengths about a centre, in a coordinate system that may count in feet or degrees.
class MapMetric {
  public:
    /// `crs` as WKT. Throws InputError when it is not known.
    MapMetric(const std::string& crs, const Vec2& centre);
    ~MapMetric();

    [[nodiscard]] Vec2 metres(const Vec2& map) const;
    [[nodiscard]] Vec2 map(const Vec2& metres) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The same line with its points in another coordinate system; chainages stay. Throws InputError when there
/// is no way from one to the other.
MapLine in_system(const MapLine& line, const std::string& crs);

/// Whether a ring (first point not repeated) bounds an area without touching itself.
bool is_valid_ring(const Polyline& ring);

}  // namespace runout
