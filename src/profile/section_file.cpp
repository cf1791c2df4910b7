#include "profile/section_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "core/input_error.h"
#include "core/words.h"
#include "profile/read_section_table.h"

namespace runout {
namespace {

// A format shows within these.
constexpr std::size_t start_bytes = 4096;

std::string start_of(const std::string& path) {
    std::error_code failure;
    if (!std::filesystem::is_regular_file(path, failure)) return {};  // a pipe would have to be waited for
    std::ifstream stream(path, std::ios::binary);
    std::string start(start_bytes, '\0');
    stream.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(stream.gcount()));
    return start;
}

bool is_dxf(const std::string& path, std::string_view start) {
    if (lower_ending(path) == ".dxf" || start.starts_with("AutoCAD Binary DXF")) return true;
    const std::size_t first = start.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && start[first] == '0' &&
           start.substr(first, 40).find("SECTION") != std::string_view::npos;
}

/// XML in any encoding: its first sign is "<".
bool is_xml(const std::string& /*path*/, std::string_view start) {
    const std::size_t first = start.find_first_not_of(std::string_view("\xEF\xBB\xBF\xFE\xFF\0 \t\r\n", 10));
    return first != std::string_view::npos && start[first] == '<';
}

/// GeoPackage, shapefile, FlatGeobuf, GeoJSON: by how they begin. GML and KML are XML, and lie on the map.
bool is_vector_file(const std::string& /*path*/, std::string_view start) {
    constexpr std::array<std::string_view, 3> signs = {std::string_view("SQLite format 3\0", 16),
                                                       std::string_view("\0\0\x27\x0a", 4), "fgb"};
    if (std::ranges::any_of(signs, [&](std::string_view sign) { return start.starts_with(sign); }))
        return true;
    const std::size_t first = start.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && start[first] == '{';
}

bool is_anything(const std::string& /*path*/, std::string_view /*start*/) {
    return true;
}

SectionContent read_drawing(const std::string& path, const SectionFileOptions& options) {
    return section_of_drawing(read_dxf(path), {options.dxf_layers, options.unit});
}

SectionContent read_xml(const std::string& path, const SectionFileOptions& options) {
    LandXmlChoice choice = options.landxml;
    choice.unit = options.unit;
    return {read_landxml(path, choice), {}};
}

SectionContent read_vector_file(const std::string& path, const SectionFileOptions& options) {
    return section_of_drawing(read_local_lines({.file = path}), {options.dxf_layers, options.unit});
}

SectionContent read_table(const std::string& path, const SectionFileOptions& options) {
    return {read_section_table(path, {options.columns, options.unit, options.decimal}), {}};
}

}  // namespace

std::span<const SectionFormat> section_formats() {
    static const std::vector<SectionFormat> formats = {
        {"a drawing (DXF)", {"section.unit", "section.dxf_layers"}, {".dxf"}, is_dxf, read_drawing},
        {"LandXML",
         {"section.unit", "section.alignment", "section.station", "section.surface"},
         {".xml", ".landxml"},
         is_xml,
         read_xml},
        {"lines in a local system",
         {"section.unit", "section.dxf_layers"},
         {},
         is_vector_file,
         read_vector_file},
        {"a table",
         {"section.unit", "section.columns", "section.decimal"},
         {".csv", ".txt", ".tsv", ".dat", ".prn", ".xyz", ".pts"},
         is_anything,
         read_table},
    };
    return formats;
}

const SectionFormat& format_of_section(const std::string& path) {
    const std::string start = start_of(path);
    return *std::ranges::find_if(section_formats(),
                                 [&](const SectionFormat& format) { return format.recognises(path, start); });
}

SectionContent read_section_file(const std::string& path, const SectionFileOptions& options) {
    return format_of_section(path).read(path, options);
}

}  // namespace runout
