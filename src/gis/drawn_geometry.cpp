#include "gis/drawn_geometry.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "core/input_error.h"

namespace runout {
namespace {

DrawnLine drawn_line(const OGRLineString& line) {
    DrawnLine drawn;
    for (int i = 0; i < line.getNumPoints(); ++i) {
        drawn.points.emplace_back(line.getX(i), line.getY(i));
        drawn.level = drawn.level && line.getZ(i) == line.getZ(0);
    }
    return drawn;
}

}  // namespace

void DrawnPointCount::add(std::size_t points) {
    count_ += points;
    if (count_ > most_drawn_points)
        throw InputError({file_, 0, "", ""},
                         fmt::format("has more than {} points on its lines", most_drawn_points),
                         "keep the lines of the section alone, or draw them with fewer points");
}

std::vector<DrawnLine> drawn_lines(const OGRGeometry* geometry, DrawnPointCount& count, Parts parts) {
    std::unique_ptr<OGRGeometry> straight;
    if (geometry != nullptr && geometry->hasCurveGeometry() != 0) {
        straight.reset(geometry->getLinearGeometry(1));
        geometry = straight.get();
    }
    if (geometry == nullptr) return {};
    const OGRwkbGeometryType kind = wkbFlatten(geometry->getGeometryType());
    std::vector<DrawnLine> lines;
    if (kind == wkbLineString) {
        count.add(static_cast<std::size_t>(geometry->toLineString()->getNumPoints()));
        lines.push_back(drawn_line(*geometry->toLineString()));
    }
    if (kind == wkbMultiLineString && parts == Parts::many)
        for (const OGRLineString* part : geometry->toMultiLineString())
            for (DrawnLine& line : drawn_lines(part, count)) lines.push_back(std::move(line));
    std::erase_if(lines, [](const DrawnLine& line) { return line.points.size() < 2; });
    return lines;
}

}  // namespace runout
