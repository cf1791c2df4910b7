#include "engine/effects/bed_shape.h"

#include <algorithm>
#include <cmath>

#include "engine/particles/bed_line.h"

namespace runout {
namespace {

/// The part of a chain between two x, its ends included.
Polyline between(const Polyline& chain, double from, double to) {
    const BedLine line(chain);
    Polyline part{{from, line.elevation(from)}};
    for (const Vec2& p : chain)
        if (p.x() > from && p.x() < to) part.push_back(p);
    part.emplace_back(to, line.elevation(to));
    return part;
}

/// The chain with what lies between the ends of `piece` replaced by it.
Polyline replaced(const Polyline& chain, const Polyline& piece) {
    Polyline result;
    for (const Vec2& p : chain)
        if (p.x() < piece.front().x()) result.push_back(p);
    result.insert(result.end(), piece.begin(), piece.end());
    for (const Vec2& p : chain)
        if (p.x() > piece.back().x()) result.push_back(p);
    return result;
}

Polyline lowered(const Polyline& ground, const ErodibleBed& layer) {
    const Polyline top = between(ground, layer.from, layer.to);
    Polyline piece{top.front()};
    for (const Vec2& p : top) piece.emplace_back(p.x(), p.y() - layer.depth);
    piece.push_back(top.back());
    return replaced(ground, piece);
}

}  // namespace

Effects with_whole_layers(Effects effects, double spacing) {
    if (effects.erodible_bed) {
        double& depth = effects.erodible_bed->depth;
        depth = spacing * std::max(1.0, std::round(depth / spacing));
    }
    return effects;
}

Polygon layer_outline(const Polyline& ground, const ErodibleBed& layer) {
    const Polyline top = between(ground, layer.from, layer.to);
    Polygon outline;
    for (const Vec2& p : top) outline.emplace_back(p.x(), p.y() - layer.depth);
    outline.insert(outline.end(), top.rbegin(), top.rend());
    return outline;
}

Polyline barrier_outline(const Polyline& ground, const Barrier& barrier) {
    const BedLine line(ground);
    const Vec2 foot{barrier.x, line.elevation(barrier.x)};
    // cos / sin and not 1 / tan: a vertical face is vertical to the last digit.
    const double lean = barrier.height * std::cos(barrier.inclination) / std::sin(barrier.inclination);
    const Vec2 front = foot + Vec2{std::abs(lean) < 1e-12 * barrier.height ? 0.0 : lean, barrier.height};
    const Vec2 back = front + Vec2{barrier.thickness, 0.0};
    return {foot, front, back, {back.x(), std::min(back.y(), line.elevation(back.x()))}};
}

Polyline shape_bed(const Polyline& ground, const Effects& effects) {
    Polyline bed = ground;
    if (effects.erodible_bed) bed = lowered(bed, *effects.erodible_bed);
    if (effects.barrier) bed = replaced(bed, barrier_outline(bed, *effects.barrier));
    return bed;
}

double polygon_area(const Polygon& outline) {
    double twice = 0.0;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++)
        twice += outline[j].x() * outline[i].y() - outline[i].x() * outline[j].y();
    return 0.5 * twice;
}

}  // namespace runout
