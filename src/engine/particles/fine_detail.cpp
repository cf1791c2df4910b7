#include "engine/particles/fine_detail.h"

#include <algorithm>

namespace runout {
namespace {

constexpr double finest_edge = 2.0;     // spacings
constexpr double finest_detail = 0.25;  // spacings

/// Whether all points between two of a chain lie within `far` of the straight way from one to the other.
bool is_straight(const Polyline& chain, std::size_t from, std::size_t to, double far) {
    const Vec2 way = chain[to] - chain[from];
    const double length2 = way.squaredNorm();
    for (std::size_t k = from + 1; k < to; ++k) {
        const Vec2 off = chain[k] - chain[from];
        const double along = length2 > 0.0 ? std::clamp(off.dot(way) / length2, 0.0, 1.0) : 0.0;
        if ((off - along * way).squaredNorm() > far * far) return false;
    }
    return true;
}

}  // namespace

Polyline without_fine_detail(const Polyline& chain, double spacing) {
    const double reach = finest_edge * spacing;
    Polyline kept = {chain.front()};
    for (std::size_t from = 0; from + 1 < chain.size();) {
        std::size_t to = from + 1;
        while (to + 1 < chain.size() && (chain[to + 1] - chain[from]).squaredNorm() < reach * reach) ++to;
        while (to > from + 1 && !is_straight(chain, from, to, finest_detail * spacing))
            to = from + (to - from + 1) / 2;
        kept.push_back(chain[to]);
        from = to;
    }
    return kept;
}

}  // namespace runout
