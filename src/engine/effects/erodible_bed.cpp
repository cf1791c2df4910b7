#include "engine/effects/erodible_bed.h"

#include <algorithm>
#include <cmath>

#include "engine/particles/chain.h"

namespace runout {
namespace {

constexpr double moved_spacings = 2.0;  // by which soil of the bed must move to count as debris

}  // namespace

ErodibleBed with_whole_particles(ErodibleBed layer, double spacing) {
    layer.depth = spacing * std::max(1.0, std::round(layer.depth / spacing));
    return layer;
}

Polygon layer_outline(const Polyline& ground, const ErodibleBed& layer) {
    const Polyline top = between(ground, layer.from, layer.to);
    Polygon outline;
    for (const Vec2& p : top) outline.emplace_back(p.x(), p.y() - layer.depth);
    outline.insert(outline.end(), top.rbegin(), top.rend());
    return outline;
}

Polyline lowered_by(const Polyline& ground, const ErodibleBed& layer) {
    const Polyline top = between(ground, layer.from, layer.to);
    Polyline piece{top.front()};
    for (const Vec2& p : top) piece.emplace_back(p.x(), p.y() - layer.depth);
    piece.push_back(top.back());
    return replaced(ground, piece);
}

UnmovedLayer::UnmovedLayer(int first_id, int end_id, double spacing)
    : first_id_(first_id),
      end_id_(end_id),
      far2_(std::pow(moved_spacings * spacing, 2)),
      moved_(static_cast<std::size_t>(end_id - first_id), 0) {}

void UnmovedLayer::observe(const Soil& soil, const std::vector<Vec2>& starts) {
    unmoved_.assign(static_cast<std::size_t>(soil.count), 0);
    for (int i = 0; i < soil.count; ++i) {
        if (soil.id[i] < first_id_ || soil.id[i] >= end_id_) continue;
        char& moved = moved_[static_cast<std::size_t>(soil.id[i] - first_id_)];
        if (moved == 0 && (Vec2{soil.x[i], soil.y[i]} - starts[soil.id[i]]).squaredNorm() > far2_) moved = 1;
        unmoved_[i] = moved == 0 ? 1 : 0;
    }
}

long UnmovedLayer::moved() const {
    return std::count(moved_.begin(), moved_.end(), 1);
}

}  // namespace runout
