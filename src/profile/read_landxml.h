#pragma once

#include <string>

#include "profile/section_points.h"

namespace runout {

/// Which of the sections of a LandXML file. Empty: not said.
struct LandXmlChoice {
    std::string alignment{};  ///< its name
    std::string station{};    ///< of a cross-section, "120.5" or "0+120.5"; or "profile", the long profile
    std::string surface{};    ///< name of CrossSectSurf or ProfSurf
    std::string unit{};       ///< replaces what the file says
};

/// A surface of a LandXML cross-section (offset = chainage) or of a long profile (station = chainage), in
/// metres by the unit of the file. Parts of a surface that meet end to end are joined. Throws InputError: a
/// file that is not LandXML, no section in it, several to choose from (listed), an unknown unit, a point that
/// is no pair of numbers, what join_lines and check_elevations refuse.
SectionPoints read_landxml(const std::string& path, const LandXmlChoice& choice);

}  // namespace runout
