#pragma once

#include <map>
#include <string>

namespace runout {

/// What GDAL does not tell of a DXF.
struct DxfOutline {
    std::string unit;                            ///< of $INSUNITS, as section.unit has it; empty: not said
    bool imperial = false;                       ///< $MEASUREMENT says feet and inches
    std::map<std::string, long> lines_of_layer;  ///< entities of the model space that are lines, by layer
};

/// Goes once through the file. Throws InputError: no such file, a binary DXF, one that ends before its
/// entities do, a spline too large to be worked out, a unit that no section is in.
DxfOutline dxf_outline(const std::string& path);

}  // namespace runout
