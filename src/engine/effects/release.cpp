#include "engine/effects/release.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

Release::Release(StagedRelease release, double head) : release_(std::move(release)), head_(head) {}

bool Release::goes_on(double& time) {
    if (masses_ < release_.masses.size()) {
        time = std::max(time, release_.masses[masses_].time);
        return true;
    }
    stage_ended_ = layers_ < release_.layers;
    return stage_ended_;
}

const LaterMass* Release::mass_due(double time) {
    const bool due = masses_ < release_.masses.size() && time >= release_.masses[masses_].time;
    return due ? &release_.masses[masses_++] : nullptr;
}

Release::Layer Release::next_layer(const Soil& soil, const BedLine& bed, double spacing) {
    const int columns = std::max(1, static_cast<int>(std::lround(release_.layer_width / spacing)));
    const int rows = std::max(1, static_cast<int>(std::lround(release_.layer_height / spacing)));
    // Not at the head itself, where a wall may stand.
    double top = bed.elevation(head_ + 0.5 * spacing);
    for (int i = 0; i < soil.count; ++i)
        if (soil.x[i] < head_ + columns * spacing) top = std::max(top, soil.y[i]);
    Layer layer{{}, top + (rows + 0.5) * spacing};
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j)
            layer.points.emplace_back(head_ + (i + 0.5) * spacing, top + (j + 1.0) * spacing);
    ++layers_;
    return layer;
}

std::vector<Vec2> place_mass(const Mass& mass, const Soil& soil, double spacing, double smoothing_ratio) {
    std::vector<Vec2> points = pack_mass(mass, spacing, smoothing_ratio).points;
    CellGrid grid;
    grid.size = spacing;
    std::vector<int> order;
    grid.sort(soil.x, soil.y, {0, soil.count}, order);
    while (overlaps(points, soil, grid, order, least_distance * spacing))
        for (Vec2& p : points) p.y() += spacing;
    return points;
}

}  // namespace runout
