#pragma once

#include <string>
#include <vector>

namespace runout {

/// The files that a raster or a layer of lines consists of: itself, and what lies beside it or is named in it
/// - the .dbf and .prj of a shapefile, the .tfw of a TIFF, the sources of a virtual raster. In a fixed order.
/// `path` alone where it cannot be opened.
std::vector<std::string> dataset_files(const std::string& path);

}  // namespace runout
