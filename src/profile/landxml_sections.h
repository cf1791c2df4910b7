#pragma once

#include <string>
#include <vector>

#include "core/geometry.h"

namespace runout {

/// One surface of a cross-section or long profile, as a LandXML file has it.
struct LandXmlSection {
    std::string alignment;
    std::string station;  ///< as written; "profile" for a long profile
    std::string surface;
    std::vector<Polyline> parts;          ///< (offset or station, elevation) in units of the file
    std::vector<std::vector<int>> lines;  ///< of each point; empty where the encoding has none to count
};

/// A file with all its sections.
struct LandXmlFile {
    std::vector<LandXmlSection> sections;
    std::string unit;  ///< as section.unit has it; empty: the file does not say
};

/// Throws InputError: no such file, too large, XML that does not parse, no LandXML, an unknown unit, a list
/// of points that is not pairs of numbers.
LandXmlFile load_landxml(const std::string& path);

}  // namespace runout
