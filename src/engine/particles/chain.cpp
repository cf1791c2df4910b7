#include "engine/particles/chain.h"

#include "engine/particles/bed_line.h"

namespace runout {

Polyline between(const Polyline& chain, double from, double to) {
    const BedLine line(chain);
    Polyline part{{from, line.elevation(from)}};
    for (const Vec2& p : chain)
        if (p.x() > from && p.x() < to) part.push_back(p);
    part.emplace_back(to, line.elevation(to));
    return part;
}

Polyline replaced(const Polyline& chain, const Polyline& piece) {
    Polyline result;
    for (const Vec2& p : chain)
        if (p.x() < piece.front().x()) result.push_back(p);
    result.insert(result.end(), piece.begin(), piece.end());
    for (const Vec2& p : chain)
        if (p.x() > piece.back().x()) result.push_back(p);
    return result;
}

double polygon_area(const Polygon& outline) {
    double twice = 0.0;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++)
        twice += outline[j].x() * outline[i].y() - outline[i].x() * outline[j].y();
    return 0.5 * twice;
}

}  // namespace runout
