#include "scene/shaking_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/csv_rows.h"

namespace runout {
namespace {

constexpr std::array<std::string_view, 3> column_names = {"time_s", "horizontal_m_s2", "vertical_m_s2"};
constexpr const char* header = "the header is time_s,horizontal_m_s2 or time_s,horizontal_m_s2,vertical_m_s2";

/// Where each of column_names stands in the file; the last may be missing.
std::array<std::size_t, 3> read_header(const CsvRow& row, const std::string& path) {
    std::array<std::size_t, 3> columns;
    for (std::size_t c = 0; c < column_names.size(); ++c) {
        columns[c] =
            static_cast<std::size_t>(std::ranges::find(row.fields, column_names[c]) - row.fields.begin());
        if (columns[c] == row.fields.size() && c < 2)
            throw InputError({path, row.line, "column", ""},
                             fmt::format("{} is missing in the header", column_names[c]), header);
    }
    for (const std::string& name : row.fields)
        if (std::ranges::find(column_names, name) == column_names.end())
            throw InputError({path, row.line, "column", name}, "is not a known column", header);
    return columns;
}

}  // namespace

Shaking read_shaking_record(const std::string& path) {
    const std::vector<CsvRow> rows =
        read_csv_rows(path, "give the path of a CSV file with time_s,horizontal_m_s2");
    if (rows.size() < 3)
        throw InputError({path, 0, "", ""}, "has fewer than two rows of numbers",
                         "give a header time_s,horizontal_m_s2 and the record");
    const std::array<std::size_t, 3> columns = read_header(rows.front(), path);
    Shaking shaking;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const CsvRow& row = rows[i];
        if (row.fields.size() != rows.front().fields.size())
            throw InputError({path, row.line, "", ""}, fmt::format("has {} fields", row.fields.size()),
                             fmt::format("give {}, as in the header", rows.front().fields.size()));
        const auto value = [&](std::size_t c) {
            return csv_number({path, row.line, std::string(column_names[c]), row.fields[columns[c]]},
                              "give a number, such as 0.25");
        };
        const double time = value(0);
        const bool rises = shaking.time.empty() ? time == 0.0 : time > shaking.time.back();
        if (!rises)
            throw InputError({path, row.line, "time_s", row.fields[columns[0]]},
                             shaking.time.empty() ? "is not 0 in the first row" : "does not rise",
                             "times start at 0 s and rise");
        shaking.time.push_back(time);
        shaking.horizontal.push_back(value(1));
        shaking.vertical.push_back(columns[2] < row.fields.size() ? value(2) : 0.0);
    }
    return shaking;
}

}  // namespace runout
