#pragma once

#include <string>

namespace runout {

/// The map that a GeoPackage's bytes hold, with a mark by which it is known as an unedited output of this
/// program: the SHA-256 of its layers, features and styles, as metadata of the file. Throws InputError naming
/// `path` when GDAL cannot write it.
std::string with_map_mark(const std::string& geopackage, const std::string& path);

/// Whether a file is a map of this program whose content is as it was written. Looking at it in a GIS changes
/// bytes of a GeoPackage, and no content.
bool is_unedited_map(const std::string& path);

}  // namespace runout
