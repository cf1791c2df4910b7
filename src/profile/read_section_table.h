#pragma once

#include <string>

#include "profile/section_points.h"

namespace runout {

/// What the user says of a table; what is left empty is found in the file.
struct TableOptions {
    std::string columns{};  ///< of chainage and elevation: "Station,Elev" or "3,5"
    std::string unit{};     ///< m, cm, mm, ft, us-ft or in
    std::string decimal{};  ///< point or comma
};

/// The points of a section from the bytes of a text table, as programs and instruments write them
/// (docs/sections.md): chainage never decreasing, metres. `read_as` says how they were understood, and is
/// empty where the header is chainage_m and elevation_m alone. `path` is for messages. Throws InputError,
/// with the line: what table_text refuses, more than 1,000,000 lines, a reading that leaves a choice, missing
/// values, rows out of order, and what check_elevations refuses.
SectionPoints section_of_table(std::string bytes, const std::string& path, const TableOptions& options);

/// The same from a file. Throws InputError also as read_text_file.
SectionPoints read_section_table(const std::string& path, const TableOptions& options);

}  // namespace runout
