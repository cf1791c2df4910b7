#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "profile/read_drawing.h"
#include "profile/read_landxml.h"
#include "profile/section_points.h"

namespace runout {

/// What the user says of a section in a file of its own. Empty: not said.
struct SectionFileOptions {
    std::string columns{};
    std::string unit{};
    std::string decimal{};
    std::string dxf_layers{};
    LandXmlChoice landxml{};  ///< its unit is that above
};

/// A format that sections come in.
struct SectionFormat {
    std::string_view name;                  ///< "a drawing (DXF)"
    std::vector<std::string_view> keys;     ///< that say how to read it
    std::vector<std::string_view> endings;  ///< that stand for it on a command line: ".dxf"; may be none
    bool (*recognises)(const std::string& path, std::string_view start);
    SectionContent (*read)(const std::string& path, const SectionFileOptions& options);
};

/// All of them, in the order in which a file is tried; the last one takes what no other does.
std::span<const SectionFormat> section_formats();

/// By what the file holds, and by the ending .dxf; a table when it cannot be opened.
const SectionFormat& format_of_section(const std::string& path);

/// Reads a section by its format. Throws InputError.
SectionContent read_section_file(const std::string& path, const SectionFileOptions& options);

}  // namespace runout
