#pragma once

namespace runout {

// Shared by the files of this room only.

/// The drivers that may read rasters, a list that ends with nullptr, as GDAL takes it. docs/maps.md has it
/// too.
const char* const* raster_drivers();

/// The same of lines.
const char* const* line_drivers();

/// Makes these drivers known to GDAL, and no others: what a file refers to is opened by them as well.
void register_drivers();

}  // namespace runout
