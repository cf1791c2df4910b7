#include <fmt/format.h>

#include <string_view>

#include "core/csv_rows.h"
#include "core/input_error.h"
#include "profile/profile.h"

namespace runout {
namespace {

constexpr std::string_view chainage_name = "chainage_m";
constexpr std::string_view elevation_name = "elevation_m";

/// Which field holds which coordinate.
struct Columns {
    std::size_t chainage = 0;
    std::size_t elevation = 1;
};

Columns read_header(const CsvRow& header, const std::string& path) {
    constexpr std::size_t missing = 2;
    Columns columns{missing, missing};
    for (std::size_t i = 0; i < header.fields.size(); ++i) {
        const std::string& name = header.fields[i];
        const InputPlace place{path, header.line, "column", name};
        if (name != chainage_name && name != elevation_name)
            throw InputError(place, "is not a known column", "the header is chainage_m,elevation_m");
        std::size_t& column = name == chainage_name ? columns.chainage : columns.elevation;
        if (column != missing)
            throw InputError(place, "stands twice in the header", "the header is chainage_m,elevation_m");
        column = i;
    }
    if (columns.chainage == missing || columns.elevation == missing)
        throw InputError({path, header.line, "column", ""},
                         fmt::format("{} is missing in the header",
                                     columns.chainage == missing ? chainage_name : elevation_name),
                         "the header is chainage_m,elevation_m");
    return columns;
}

}  // namespace

Profile read_profile_csv(const std::string& path, const ProfileOptions& options) {
    const std::vector<CsvRow> rows =
        read_csv_rows(path, "give the path of a CSV file with chainage_m,elevation_m");
    if (rows.empty())
        throw InputError({path, 0, "", ""}, "is empty",
                         "give a header chainage_m,elevation_m and at least two points");
    const Columns columns = read_header(rows.front(), path);
    if (rows.size() == 1)
        throw InputError({path, rows.front().line, "", ""}, "has a header but no points",
                         "a section needs at least two points");

    std::vector<Vec2> points;
    std::vector<int> lines;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const CsvRow& row = rows[i];
        if (row.fields.size() != 2)
            throw InputError(
                {path, row.line, "", ""},
                fmt::format("has {} field{}", row.fields.size(), row.fields.size() == 1 ? "" : "s"),
                "give one chainage and one elevation, with a comma between and a point as decimal mark");
        const auto metres = [&](std::size_t column, std::string_view name) {
            return csv_number({path, row.line, std::string(name), row.fields[column]},
                              "give metres, such as 12.5");
        };
        points.emplace_back(metres(columns.chainage, chainage_name),
                            metres(columns.elevation, elevation_name));
        lines.push_back(row.line);
    }
    if (points.size() == 1)
        throw InputError({path, lines.front(), "", ""}, "has one point only",
                         "a section needs at least two points");
    return make_profile({points, lines, path}, options);
}

}  // namespace runout
