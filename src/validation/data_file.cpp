#include "validation/data_file.h"

#include <charconv>
#include <limits>
#include <sstream>
#include <utility>

#include "core/input_error.h"
#include "core/text_file.h"

namespace runout {
namespace {

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields(1);
    for (const char c : line) {
        if (c == ',') {
            fields.emplace_back();
        } else if (c != '\r') {
            fields.back() += c;
        }
    }
    return fields;
}

double number_of(const std::vector<std::string>& fields, std::size_t column, const InputPlace& place) {
    double value = 0;
    if (column < fields.size()) {
        const std::string& text = fields[column];
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc{} && end == text.data() + text.size()) return value;
    }
    throw InputError(place, "has no number in column " + std::to_string(column + 1), "give x and y");
}

}  // namespace

std::vector<Vec2> read_points(const std::string& path, const std::string& label) {
    std::istringstream file(read_text_file(path, "it comes with the program under cases/"));
    InputPlace place{.file = path, .line = 0, .key = {}, .value = {}};
    std::vector<Vec2> points;
    bool in_header = true;
    for (std::string line; std::getline(file, line);) {
        ++place.line;
        if (line.empty() || line.front() == '#') continue;
        if (std::exchange(in_header, false)) continue;
        const auto fields = fields_of(line);
        const std::size_t first = label.empty() ? 0 : 1;
        if (!label.empty() && fields.front() != label) continue;
        points.emplace_back(number_of(fields, first, place), number_of(fields, first + 1, place));
    }
    return points;
}

double crossing(const std::vector<Vec2>& points, double y) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec2& a = points[i];
        const Vec2& b = points[i + 1];
        if (a.y() <= y && b.y() > y) return a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y());
    }
    // A last point that lies on it counts.
    if (!points.empty() && points.back().y() >= y) return points.back().x();
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace runout
