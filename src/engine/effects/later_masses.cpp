#include "engine/effects/later_masses.h"

#include <algorithm>

#include "engine/particles/cell_grid.h"
#include "engine/particles/packing.h"

namespace runout {
namespace {

constexpr double least_distance = 0.7;  // spacings

bool overlaps(const std::vector<Vec2>& points, const Soil& soil, const CellGrid& grid,
              const std::vector<int>& order, double distance) {
    return std::any_of(points.begin(), points.end(), [&](const Vec2& p) {
        bool near = false;
        grid.around(p.x(), p.y(), 1, [&](int first, int last) {
            for (int k = first; k < last; ++k)
                near = near || (p - Vec2{soil.x[order[k]], soil.y[order[k]]}).norm() < distance;
        });
        return near;
    });
}

}  // namespace

std::vector<Vec2> place_mass(const LaterMass& mass, const Soil& soil, double spacing,
                             double smoothing_ratio) {
    Source shape;
    shape.outline = mass.outline;
    shape.bed = mass.bed;
    shape.area = mass.area;
    const Packing packing = pack_source(shape, spacing, smoothing_ratio);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < packing.x.size(); ++i) points.emplace_back(packing.x[i], packing.y[i]);
    CellGrid grid;
    grid.size = spacing;
    std::vector<int> order;
    grid.sort(soil.x, soil.y, {0, soil.count}, order);
    while (overlaps(points, soil, grid, order, least_distance * spacing))
        for (Vec2& p : points) p.y() += spacing;
    return points;
}

}  // namespace runout
