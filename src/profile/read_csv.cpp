#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "core/input_error.h"
#include "profile/profile.h"

namespace runout {
namespace {

constexpr std::string_view chainage_name = "chainage_m";
constexpr std::string_view elevation_name = "elevation_m";

/// A line that says something, with its number in the file.
struct Row {
    int line = 0;
    std::vector<std::string> fields;
};

/// Which field holds which coordinate.
struct Columns {
    std::size_t chainage = 0;
    std::size_t elevation = 1;
};

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string_view unquoted(std::string_view text) {
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    return trimmed(text);
}

std::vector<std::string> split(std::string_view line) {
    std::vector<std::string> fields;
    for (std::size_t begin = 0; begin <= line.size();) {
        const auto end = std::min(line.find(',', begin), line.size());
        fields.emplace_back(unquoted(trimmed(line.substr(begin, end - begin))));
        begin = end + 1;
    }
    return fields;
}

std::ifstream opened(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
        throw InputError({path, 0, "", ""}, "does not exist",
                         "give the path of a CSV file with chainage_m,elevation_m");
    if (std::filesystem::is_directory(path, ignored))
        throw InputError({path, 0, "", ""}, "is a directory",
                         "give the path of a CSV file with chainage_m,elevation_m");
    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError({path, 0, "", ""}, "cannot be opened", "check that you may read it");
    return file;
}

std::vector<Row> read_rows(const std::string& path) {
    std::ifstream file = opened(path);
    std::vector<Row> rows;
    std::string text;
    for (int line = 1; std::getline(file, text); ++line) {
        std::string_view rest = text;
        if (line == 1 && rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
        rest = trimmed(rest.substr(0, rest.find('#')));
        if (!rest.empty()) rows.push_back({line, split(rest)});
    }
    return rows;
}

Columns read_header(const Row& header, const std::string& path) {
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

/// Reads with a point as decimal mark whatever the locale says.
double read_number(const std::string& text, std::string_view column, int line, const std::string& path) {
    const InputPlace place{path, line, std::string(column), text};
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const char* end = text.data() + text.size();
    if (begin == end) throw InputError(place, "is empty", "give metres, such as 12.5");
    double value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error == std::errc::invalid_argument || stop != end)
        throw InputError(place, "is not a number", "give metres, such as 12.5");
    if (error == std::errc::result_out_of_range || !std::isfinite(value))
        throw InputError(place, "is not a finite number", "give metres, such as 12.5");
    return value;
}

}  // namespace

Profile read_profile_csv(const std::string& path, const ProfileOptions& options) {
    const std::vector<Row> rows = read_rows(path);
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
        const Row& row = rows[i];
        if (row.fields.size() != 2)
            throw InputError(
                {path, row.line, "", ""},
                fmt::format("has {} field{}", row.fields.size(), row.fields.size() == 1 ? "" : "s"),
                "give one chainage and one elevation, with a comma between and a point as decimal mark");
        points.emplace_back(read_number(row.fields[columns.chainage], chainage_name, row.line, path),
                            read_number(row.fields[columns.elevation], elevation_name, row.line, path));
        lines.push_back(row.line);
    }
    if (points.size() == 1)
        throw InputError({path, lines.front(), "", ""}, "has one point only",
                         "a section needs at least two points");
    return make_profile(points, lines, path, options);
}

}  // namespace runout
