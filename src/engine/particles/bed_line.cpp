#include "engine/particles/bed_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace runout {
namespace {

/// Unit normal of a segment that goes `along`.
Vec2 left_of(const Vec2& along) {
    const Vec2 t = along.normalized();
    return {-t.y(), t.x()};
}

}  // namespace

BedLine::BedLine(Polyline points, bool closed) : points_(std::move(points)), closed_(closed) {}

Vec2 BedLine::normal(int segment) const {
    return left_of(end(segment) - start(segment));
}

BedLine::Nearest BedLine::nearest(const Vec2& point) const {
    return nearest(point, 0, segments());
}

BedLine::Nearest BedLine::nearest(const Vec2& point, int segment, int reach) const {
    const int count = segments();
    const int first = closed_ ? segment - std::min(reach, count / 2) : std::max(0, segment - reach);
    const int last = closed_ ? segment + std::min(reach, count / 2) : std::min(count - 1, segment + reach);
    Nearest best;
    double best2 = std::numeric_limits<double>::infinity();
    Vec2 offset{0, 0};
    bool beyond_end = false;
    for (int s = first; s <= last; ++s) {
        const int seg = (s + count) % count;
        const Vec2 a = start(seg);
        const Vec2 along = end(seg) - a;
        const double at = (point - a).dot(along) / along.squaredNorm();
        const double u = std::clamp(at, 0.0, 1.0);
        const Vec2 from = point - (a + u * along);
        const double d2 = from.squaredNorm();
        // At a shared vertex both segments are equally near; their normals add up to the vertex normal.
        if (d2 < best2 * (1.0 - 1e-12)) {
            best2 = d2;
            best.segment = seg;
            best.normal = left_of(along);
            offset = from;
            beyond_end = !closed_ && ((seg == 0 && at < 0.0) || (seg == count - 1 && at > 1.0));
        } else if (d2 <= best2 * (1.0 + 1e-12)) {
            best.normal += left_of(along);
        }
    }
    best.normal = best.normal.normalized();
    const double distance = std::sqrt(best2);
    const bool inside = !beyond_end && offset.dot(best.normal) < 0.0;
    best.distance = inside ? -distance : distance;
    return best;
}

BedLine::Nearest BedLine::below(double x, double y) const {
    const Nearest nothing{.distance = std::numeric_limits<double>::infinity()};
    if (closed_ || x < points_.front().x() || x > points_.back().x()) return nothing;
    const auto right = std::upper_bound(points_.begin() + 1, points_.end() - 1, x,
                                        [](double value, const Vec2& point) { return value < point.x(); });
    const Vec2& a = *(right - 1);
    const Vec2 along = *right - a;
    if (along.x() <= 0.0 || y >= a.y() + along.y() * (x - a.x()) / along.x()) return nothing;
    return nearest({x, y});
}

double BedLine::elevation(double x) const {
    if (x < points_.front().x()) return points_.front().y();
    double y = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
        const Vec2& a = points_[i];
        const Vec2& b = points_[i + 1];
        if (x < a.x() || x > b.x()) continue;
        const double width = b.x() - a.x();
        y = std::max(y, width > 0.0 ? a.y() + (b.y() - a.y()) * (x - a.x()) / width : std::max(a.y(), b.y()));
    }
    return std::isfinite(y) ? y : points_.back().y();
}

}  // namespace runout
