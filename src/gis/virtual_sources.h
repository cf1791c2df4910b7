#pragma once

#include <string>

namespace runout {

/// Holds a virtual data set (VRT of GDAL or OGR), or one among its sources, against what such a file may
/// name: files in its own folder or below, which exist. Throws InputError that names the source: one
/// elsewhere, on another machine, or none that is a file; a query of its own; sources nested too deeply.
void check_virtual_sources(const std::string& path);

}  // namespace runout
