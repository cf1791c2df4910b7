#include "source/ground_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace runout {
namespace {

Vec2 nearest_on_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 ab = b - a;
    const double length2 = ab.squaredNorm();
    const double t = length2 > 0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
    return a + t * ab;
}

/// The points since the last one that was kept, as far as a straight segment from there can stand for them.
/// It remembers the directions from which all of them lie within the tolerance, so that a long straight
/// stretch costs no more than its points.
class StraightRun {
  public:
    StraightRun(const Vec2& start, double tolerance) : start_(start), tolerance_(tolerance) {}

    void pass(const Vec2& point) {
        const Vec2 way = point - start_;
        const double length = way.norm();
        farthest_ = std::max(farthest_, length);
        if (length <= tolerance_) return;
        if (ahead_ == Vec2{}) ahead_ = way / length;
        const double spread = std::asin(tolerance_ / length);
        lowest_ = std::max(lowest_, direction(way) - spread);
        highest_ = std::min(highest_, direction(way) + spread);
    }

    [[nodiscard]] bool may_end_at(const Vec2& end) const {
        const Vec2 way = end - start_;
        if (way.norm() < farthest_ - tolerance_) return false;
        return ahead_ == Vec2{} || (direction(way) >= lowest_ && direction(way) <= highest_);
    }

  private:
    /// Against the first point passed, so that it is small and exact on a straight stretch.
    [[nodiscard]] double direction(const Vec2& way) const {
        return std::atan2(ahead_.x() * way.y() - ahead_.y() * way.x(), ahead_.dot(way));
    }

    Vec2 start_;
    double tolerance_;
    Vec2 ahead_{0, 0};
    double farthest_ = 0;
    double lowest_ = -std::numeric_limits<double>::infinity();
    double highest_ = std::numeric_limits<double>::infinity();
};

void add(std::vector<Stretch>& way, std::size_t segment, double from, double to) {
    if (from != to) way.push_back({segment, from, to});
}

}  // namespace

Vec2 position(const Polyline& ground, const GroundPoint& point) {
    const Vec2& a = ground[point.segment];
    const Vec2& b = ground[point.segment + 1];
    return point.fraction == 1 ? b : a + point.fraction * (b - a);
}

GroundPoint at_vertex(const Polyline& ground, std::size_t index) {
    return index + 1 < ground.size() ? GroundPoint{index, 0} : GroundPoint{index - 1, 1};
}

GroundPoint on_segment_above(const GroundPoint& point) {
    return point.fraction == 0 && point.segment > 0 ? GroundPoint{point.segment - 1, 1} : point;
}

std::vector<Stretch> walk(const GroundPoint& from, const GroundPoint& to) {
    std::vector<Stretch> way;
    if (from.segment == to.segment) {
        add(way, from.segment, from.fraction, to.fraction);
    } else if (from.segment < to.segment) {
        add(way, from.segment, from.fraction, 1);
        for (std::size_t i = from.segment + 1; i < to.segment; ++i) add(way, i, 0, 1);
        add(way, to.segment, 0, to.fraction);
    } else {
        add(way, from.segment, from.fraction, 0);
        for (std::size_t i = from.segment - 1; i > to.segment; --i) add(way, i, 1, 0);
        add(way, to.segment, 1, to.fraction);
    }
    return way;
}

std::optional<GroundPoint> first_at_elevation(const Polyline& ground, const std::vector<Stretch>& way,
                                              double elevation) {
    for (const Stretch& s : way) {
        const double y_from = position(ground, {s.segment, s.from}).y();
        const double y_to = position(ground, {s.segment, s.to}).y();
        if (elevation == y_from) return GroundPoint{s.segment, s.from};
        if (elevation == y_to) return GroundPoint{s.segment, s.to};
        if ((elevation - y_from) * (elevation - y_to) > 0) continue;
        const double top = ground[s.segment].y();
        return GroundPoint{s.segment, (top - elevation) / (top - ground[s.segment + 1].y())};
    }
    return std::nullopt;
}

double elevation_at(const Polyline& ground, double x) {
    double highest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < ground.size(); ++i) {
        const Vec2& a = ground[i];
        const Vec2& b = ground[i + 1];
        if (x < a.x() || x > b.x()) continue;
        const double y = a.x() == b.x() ? std::max(a.y(), b.y())
                                        : a.y() + (b.y() - a.y()) * ((x - a.x()) / (b.x() - a.x()));
        highest = std::max(highest, y);
    }
    return highest;
}

double inclination(const Polyline& ground, std::size_t segment) {
    const Vec2 d = ground[segment + 1] - ground[segment];
    return std::atan2(-d.y(), d.x());
}

double extent(const Polyline& points) {
    Vec2 low = points.front();
    Vec2 high = points.front();
    for (const Vec2& p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    return (high - low).maxCoeff();
}

Vec2 nearest(const Vec2& point, const Polyline& line) {
    Vec2 best = line.front();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec2 candidate = nearest_on_segment(point, line[i], line[i + 1]);
        if ((candidate - point).squaredNorm() < (best - point).squaredNorm()) best = candidate;
    }
    return best;
}

double distance(const Vec2& point, const Polyline& line) {
    return (nearest(point, line) - point).norm();
}

Polyline without_needless_points(const Polyline& line, double tolerance) {
    Polyline kept{line.front()};
    StraightRun run(line.front(), tolerance);
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        run.pass(line[i]);
        if (run.may_end_at(line[i + 1])) continue;
        kept.push_back(line[i]);
        run = StraightRun(line[i], tolerance);
    }
    kept.push_back(line.back());
    return kept;
}

Polygon without_needless_corners(const Polygon& outline, double tolerance) {
    // Begin at a corner that is surely one: the leftmost.
    Polygon ring = outline;
    const auto leftmost = std::ranges::min_element(
        ring, [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    std::rotate(ring.begin(), leftmost, ring.end());
    ring.push_back(ring.front());
    Polygon kept = without_needless_points(ring, tolerance);
    kept.pop_back();
    return kept;
}

}  // namespace runout
