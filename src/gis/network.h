#pragma once

#include <string>

namespace runout {

/// Lets GDAL reach servers, its other file systems (/vsicurl/, /vsis3/, ...) and sources of a virtual raster
/// anywhere on the disk. To be said before anything is read; unsaid, all that stays closed.
void allow_network();

bool network_is_allowed();

/// Shuts every file system of GDAL but plain files and local archives, and its HTTP client. Lasts as long as
/// the program.
void close_network();

/// Whether a path names one of the file systems of GDAL that may lie on another machine.
bool is_remote(const std::string& path);

}  // namespace runout
