#include "measures/bed_walls.h"

#include <algorithm>
#include <cmath>

namespace runout {
namespace {

constexpr double steepness = 2.5;  // 68 deg

bool is_steep(const Vec2& along) {
    return std::abs(along.y()) > steepness * along.x();
}

/// Steep segments that follow each other are one face.
std::vector<BedWall> faces_of(const BedLine& line, double least_height) {
    std::vector<BedWall> faces;
    for (int s = 0; s < line.segments();) {
        const Vec2 from = line.start(s);
        const bool rises = line.end(s).y() > from.y();
        int end = s;
        const auto goes_on = [&] {
            const Vec2 along = line.end(end) - line.start(end);
            return is_steep(along) && (along.y() > 0) == rises;
        };
        while (end < line.segments() && goes_on()) ++end;
        const Vec2 to = end > s ? line.end(end - 1) : from;
        if (std::abs(to.y() - from.y()) >= least_height && end > s)
            faces.push_back({rises ? from : to, rises ? to : from, rises});
        s = std::max(end, s + 1);
    }
    return faces;
}

}  // namespace

double BedWall::x_at(double elevation) const {
    const double share = std::clamp((elevation - foot.y()) / (top.y() - foot.y()), 0.0, 1.0);
    return foot.x() + share * (top.x() - foot.x());
}

std::vector<BedWall> walls_of(const BedLine& ground, const BedLine& bed, double least_height) {
    std::vector<BedWall> walls = faces_of(ground, least_height);
    for (const BedWall& face : faces_of(bed, least_height))
        if (face.top.y() > ground.elevation(face.top.x()) + 0.5 * least_height) walls.push_back(face);
    std::ranges::sort(walls, {}, [](const BedWall& wall) { return std::min(wall.foot.x(), wall.top.x()); });
    return walls;
}

}  // namespace runout
