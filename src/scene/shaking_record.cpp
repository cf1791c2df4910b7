#include "scene/shaking_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/csv_rows.h"

namespace runout {
namespace {

constexpr std::array<std::string_view, 3> column_names = {"time_s", "horizontal_m_s2", "vertical_m_s2"};
constexpr const char* header = "the header is time_s,horizontal_m_s2 or time_s,horizontal_m_s2,vertical_m_s2";

// Strong-motion instruments take 100 to 2,000 samples a second; the greatest acceleration of the ground that
// was ever recorded is 4.4 g (Aratozawa, 2008); no earthquake shook for ten minutes.
constexpr double least_interval = 1e-5;  // s
constexpr double longest_record = 3600;  // s
constexpr double most_gravities = 5;

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

double time_of(const InputPlace& place, const std::vector<double>& earlier) {
    const double time = csv_number(place, "give seconds, such as 0.25");
    if (earlier.empty() && time != 0.0)
        throw InputError(place, "is not 0 in the first row", "times start at 0 s and rise");
    if (earlier.empty()) return time;
    if (!(time > earlier.back())) throw InputError(place, "does not rise", "times start at 0 s and rise");
    if (time - earlier.back() < least_interval)
        throw InputError(place, fmt::format("comes {:.3g} s after the row before", time - earlier.back()),
                         fmt::format("give rows at least {:g} s apart", least_interval));
    if (time > longest_record)
        throw InputError(place, "is later than any earthquake lasts",
                         fmt::format("end the record by {:.0f} s", longest_record));
    return time;
}

double acceleration_of(const InputPlace& place, double gravity) {
    const double value = csv_number(place, "give m/s2, such as 2.5");
    if (std::abs(value) > most_gravities * gravity)
        throw InputError(place,
                         fmt::format("is {:.3g} times the gravity of the run", std::abs(value) / gravity),
                         fmt::format("give m/s2, up to {:.4g} (1 gal is 0.01 m/s2, 1 g is 9.81)",
                                     most_gravities * gravity));
    return value;
}

}  // namespace

Shaking read_shaking_record(const std::string& path, double gravity) {
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
        const auto place = [&](std::size_t c) {
            return InputPlace{path, row.line, std::string(column_names[c]), row.fields[columns[c]]};
        };
        shaking.time.push_back(time_of(place(0), shaking.time));
        shaking.horizontal.push_back(acceleration_of(place(1), gravity));
        shaking.vertical.push_back(columns[2] < row.fields.size() ? acceleration_of(place(2), gravity) : 0.0);
    }
    return shaking;
}

}  // namespace runout
