#include "source/polygons.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_set_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace runout {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Point = Kernel::Point_2;
using Vector = Kernel::Vector_2;
using ExactPolygon = CGAL::Polygon_2<Kernel>;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;
using Piece = CGAL::Polygon_with_holes_2<Kernel>;

Point exact(const Vec2& p) {
    return {p.x(), p.y()};
}

Point exact(const Polyline& ground, const GroundPoint& p) {
    const Point a = exact(ground[p.segment]);
    return a + Number(p.fraction) * (exact(ground[p.segment + 1]) - a);
}

/// CGAL's lazy numbers hold an interval; asking for the exact value first makes this one correct rounding.
double rounded(const Number& number) {
    return CGAL::to_double(CGAL::exact(number));
}

Vec2 rounded(const Point& p) {
    return {rounded(p.x()), rounded(p.y())};
}

/// Unit vector that rises uphill at `angle`. A vertical one is made so exactly: cos(pi/2) is 6e-17 in
/// doubles.
Vector uphill(double angle) {
    const double across = std::cos(angle);
    return {std::abs(across) < 1e-15 ? 0.0 : -across, std::sin(angle)};
}

Number cross(const Vector& a, const Vector& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// A sum of lazy numbers is a chain as deep as it is long, and asked for at its end only, one of some ten
/// thousand corners overflows the stack.
Number area_of(const ExactPolygon& polygon) {
    Number twice = 0;
    int since_exact = 0;
    for (auto edge = polygon.edges_begin(); edge != polygon.edges_end(); ++edge) {
        twice += cross(edge->source() - CGAL::ORIGIN, edge->target() - CGAL::ORIGIN);
        if (++since_exact % 64 == 0) CGAL::exact(twice);
    }
    return twice / 2;
}

/// Perpendicular on the upper side of an uphill vector, of the same length.
Vector upward_normal(const Vector& v) {
    return {v.y(), -v.x()};
}

ExactPolygon counter_clockwise(ExactPolygon polygon) {
    if (polygon.orientation() == CGAL::CLOCKWISE) polygon.reverse_orientation();
    return polygon;
}

ExactPolygon without_straight_corners(const ExactPolygon& polygon) {
    ExactPolygon kept;
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i)
        if (!CGAL::collinear(polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]))
            kept.push_back(polygon[i]);
    return kept;
}

/// A frame that leaves room around the ground and a region.
struct Frame {
    double left, right, bottom, top;

    explicit Frame(const Polyline& ground) : left(0), right(0), bottom(0), top(0) {
        const double room = extent(ground);
        left = ground.front().x() - room;
        right = ground.back().x() + room;
        const auto [low, high] = std::ranges::minmax(ground, {}, [](const Vec2& p) { return p.y(); });
        bottom = low.y() - room;
        top = high.y() + room;
    }
    void include(const ExactPolygon& polygon) {
        const auto box = polygon.bbox();
        bottom = std::min(bottom, box.ymin() - (top - bottom));
        top = std::max(top, box.ymax() + (top - bottom));
    }
};

/// The hill under the ground. Level shelves beyond both ends make a vertical face at an end a face like any
/// other.
ExactPolygon hill(const Polyline& ground, const Frame& frame) {
    ExactPolygon polygon;
    polygon.push_back(Point(frame.left, frame.bottom));
    polygon.push_back(Point(frame.right, frame.bottom));
    polygon.push_back(Point(frame.right, ground.back().y()));
    for (auto p = ground.rbegin(); p != ground.rend(); ++p) polygon.push_back(exact(*p));
    polygon.push_back(Point(frame.left, ground.front().y()));
    return polygon;
}

/// Everything vertically between a counter-clockwise polygon and the level `y`, which is above or below all
/// of it; the polygon itself included.
PolygonSet shadow(const ExactPolygon& polygon, double y) {
    const bool upward = Number(y) >= polygon.top_vertex()->y();
    std::vector<ExactPolygon> columns;
    for (auto edge = polygon.edges_begin(); edge != polygon.edges_end(); ++edge) {
        const Point a = edge->source();
        const Point b = edge->target();
        if (upward ? a.x() >= b.x() : a.x() <= b.x())
            continue;  // lower edges run towards +x, upper ones back
        ExactPolygon column;
        column.push_back(a);
        column.push_back(b);
        column.push_back(Point(b.x(), y));
        column.push_back(Point(a.x(), y));
        columns.push_back(column);
    }
    PolygonSet all;
    all.join(columns.begin(), columns.end());
    return all;
}

/// Upper boundary of what is left of the hill, from the left shelf to the right one.
std::vector<Point> upper_boundary(const ExactPolygon& hill_left) {
    std::vector<Point> corners(hill_left.vertices_begin(), hill_left.vertices_end());
    // The lower right corner of the frame comes first in the order of x - y; the boundary follows it.
    const auto start = std::ranges::max_element(
        corners, [](const Point& a, const Point& b) { return a.x() - a.y() < b.x() - b.y(); });
    std::rotate(corners.begin(), start, corners.end());
    std::reverse(corners.begin(), corners.end());
    // Now: lower left corner, left shelf, ..., right shelf, lower right corner.
    return {corners.begin() + 1, corners.end() - 1};
}

std::vector<Piece> pieces_of(const PolygonSet& set) {
    std::vector<Piece> pieces;
    set.polygons_with_holes(std::back_inserter(pieces));
    return pieces;
}

std::vector<ExactPolygon> common_part(const ExactPolygon& a, const ExactPolygon& b) {
    std::vector<Piece> pieces;
    CGAL::intersection(a, b, std::back_inserter(pieces));
    std::vector<ExactPolygon> outlines;
    for (const Piece& piece : pieces) outlines.push_back(piece.outer_boundary());
    return outlines;
}

bool has_on_boundary(const ExactPolygon& polygon, const Point& p) {
    for (auto edge = polygon.edges_begin(); edge != polygon.edges_end(); ++edge)
        if (edge->has_on(p)) return true;
    return false;
}

Region make_region(const ExactPolygon& polygon);

Region box(const Point& foot, const Vector& base, const Vector& side) {
    ExactPolygon polygon;
    polygon.push_back(foot);
    polygon.push_back(foot + base);
    polygon.push_back(foot + base + side);
    polygon.push_back(foot + side);
    return make_region(polygon);
}

}  // namespace

struct Region::Exact {
    ExactPolygon polygon;  ///< counter-clockwise
};

namespace {

Region make_region(const ExactPolygon& polygon) {
    return Region(std::make_shared<const Region::Exact>(
        Region::Exact{counter_clockwise(without_straight_corners(polygon))}));
}

}  // namespace

Region::Region(std::shared_ptr<const Exact> exact) : exact_(std::move(exact)) {}

Polygon Region::outline() const {
    Polygon corners;
    for (const Point& p : exact_->polygon.container()) corners.push_back(rounded(p));
    return without_needless_corners(corners, 1e-12 * extent(corners));
}

double Region::area() const {
    return rounded(area_of(exact_->polygon));
}

double Region::area_above(const Vec2& point, double angle) const {
    const auto box = exact_->polygon.bbox();
    const double reach = 4 * (std::abs(box.xmax() - point.x()) + std::abs(box.xmin() - point.x()) +
                              std::abs(box.ymax() - point.y()) + std::abs(box.ymin() - point.y()));
    const Vector along = Number(reach) * uphill(angle);
    const Point p = exact(point);
    ExactPolygon above;
    above.push_back(p - along);
    above.push_back(p - along + upward_normal(along));
    above.push_back(p + along + upward_normal(along));
    above.push_back(p + along);
    Number sum = 0;
    for (const ExactPolygon& part : common_part(exact_->polygon, above)) sum += area_of(part);
    return rounded(sum);
}

double Region::area_in(const Polyline& ground) const {
    Frame frame(ground);
    frame.include(exact_->polygon);
    Number sum = 0;
    for (const ExactPolygon& part : common_part(exact_->polygon, hill(ground, frame))) sum += part.area();
    return rounded(sum);
}

double Region::air_below(const Polyline& ground) const {
    Frame frame(ground);
    frame.include(exact_->polygon);
    PolygonSet air = shadow(exact_->polygon, frame.bottom);
    air.difference(hill(ground, frame));
    air.difference(exact_->polygon);
    Number sum = 0;
    for (const Piece& piece : pieces_of(air)) {
        sum += piece.outer_boundary().area();
        for (const ExactPolygon& hole : piece.holes()) sum += hole.area();  // negative: clockwise
    }
    return rounded(sum);
}

bool Region::touches(const Polyline& ground, const GroundPoint& point) const {
    return has_on_boundary(exact_->polygon, exact(ground, point));
}

Polyline Region::bed_in(const Polyline& ground) const {
    Frame frame(ground);
    frame.include(exact_->polygon);
    PolygonSet left(hill(ground, frame));
    left.difference(shadow(exact_->polygon, frame.top));

    Polyline bed;
    for (const Point& corner : upper_boundary(pieces_of(left).front().outer_boundary())) {
        const Vec2 p = rounded(corner);
        if (p.x() >= ground.front().x() && p.x() <= ground.back().x()) bed.push_back(p);
    }
    if (bed.empty() || bed.front() != ground.front()) bed.insert(bed.begin(), ground.front());
    if (bed.back() != ground.back()) bed.push_back(ground.back());
    return without_needless_points(bed, 1e-10 * extent(ground));
}

Vec2 corner_at(const Polyline& ground, const GroundPoint& point) {
    return rounded(exact(ground, point));
}

Region box_on_ground(const Polyline& ground, const GroundPoint& foot, double length, double thickness) {
    const Vector face = exact(ground[foot.segment]) - exact(ground[foot.segment + 1]);
    return box(exact(ground, foot), Number(length) * face, Number(thickness) * upward_normal(face));
}

Region box_at_dip(const Polyline& ground, const GroundPoint& foot, double dip, double length,
                  double thickness) {
    const Vector base = uphill(dip);
    return box(exact(ground, foot), Number(length) * base, Number(thickness) * upward_normal(base));
}

std::optional<Region> wedge(const Polyline& ground, const WedgeCut& cut) {
    const Frame frame(ground);
    const Number sky = frame.top;
    const Point exit = exact(ground, cut.exit);
    const Point top = exact(ground, cut.top);
    const Vector base = uphill(cut.base_angle);
    const Vector scarp = uphill(cut.scarp_angle);

    // Foot of the scarp: exit + u base = top + v scarp.
    const Vector apart = top - exit;
    const Number u = cross(apart, scarp) / cross(base, scarp);
    if (u <= 0) return std::nullopt;
    const Point foot = exit + u * base;

    ExactPolygon cutter;
    cutter.push_back(exit);
    cutter.push_back(Point(exit.x(), sky));
    if (foot.y() < sky) {
        cutter.push_back(top + ((sky - top.y()) / scarp.y()) * scarp);
        cutter.push_back(foot);
    } else {
        cutter.push_back(exit + ((sky - exit.y()) / base.y()) * base);
    }
    for (const ExactPolygon& part : common_part(hill(ground, frame), counter_clockwise(cutter)))
        if (has_on_boundary(part, exit)) return make_region(part);
    return std::nullopt;
}

std::optional<Region> simple_polygon(const std::vector<Vec2>& corners) {
    ExactPolygon polygon;
    for (const Vec2& p : corners) polygon.push_back(exact(p));
    if (polygon.size() < 3 || !polygon.is_simple() || area_of(polygon) == 0) return std::nullopt;
    return make_region(polygon);
}

std::optional<std::vector<Region>> ground_above(const Polyline& ground, const Polyline& line) {
    Frame frame(ground);
    ExactPolygon cutter;
    for (const Vec2& p : line) cutter.push_back(exact(p));
    frame.include(cutter);
    if (line.back().y() != frame.top) cutter.push_back(Point(line.back().x(), frame.top));
    cutter.push_back(Point(line.front().x(), frame.top));
    if (!cutter.is_simple()) return std::nullopt;

    std::vector<ExactPolygon> parts = common_part(hill(ground, frame), counter_clockwise(cutter));
    std::ranges::sort(parts,
                      [](const ExactPolygon& a, const ExactPolygon& b) { return area_of(a) > area_of(b); });
    std::vector<Region> regions;
    for (const ExactPolygon& part : parts) regions.push_back(make_region(part));
    return regions;
}

}  // namespace runout
