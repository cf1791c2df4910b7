#include "profile/foot.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace runout {
namespace {

constexpr double widest_ditch = 0.1;          // of the scale
constexpr double shallowest_ditch = 0.006;    // of the scale: less is noise
constexpr double deepest_ditch = 0.1;         // of the scale
constexpr double level_again = 0.25;          // of the depth: rise beyond the rim
constexpr double densest_gap = 0.1;           // of the scale: with longer segments the points are corners
constexpr double fitted_face = 0.2;           // of the scale, length of ground to fit a line to
constexpr double fitted_level_below = 0.095;  // of the scale: no step that matters is as near
constexpr double fitted_level_above = 0.2;    // of the scale
constexpr double straight = 0.015;            // of the scale: how far ground on a straight line lies off it
constexpr double same_point = 0.02;           // of a segment
constexpr double sharpest_flat = 0.25;        // sine of the least angle of a bend

double highest_between(const Polyline& ground, std::size_t from, double x0, double x1) {
    double highest = -INFINITY;
    for (std::size_t i = from; i + 1 < ground.size() && ground[i].x() <= x1; ++i) {
        const Vec2& a = ground[i];
        const Vec2& b = ground[i + 1];
        if (b.x() < x0) continue;
        const double run = b.x() - a.x();
        const auto at = [&](double x) {
            return run > 0 ? a.y() + (b.y() - a.y()) * ((x - a.x()) / run) : b.y();
        };
        highest = std::max({highest, at(std::max(x0, a.x())), at(std::min(x1, b.x()))});
    }
    return highest;
}

/// Level of the far rim of a ditch in which the toe lies.
std::optional<double> rim_above(const Polyline& ground, std::size_t toe, double scale) {
    const double x = ground[toe].x();
    const double wide = widest_ditch * scale;
    const double near = highest_between(ground, toe, x, x + wide);
    const double depth = near - ground[toe].y();
    if (depth < shallowest_ditch * scale || depth > deepest_ditch * scale) return std::nullopt;
    const double beyond = highest_between(ground, toe, x + wide, x + 2 * wide);
    return beyond <= near + level_again * depth ? std::optional(near) : std::nullopt;
}

/// Index of the lowest point of the face at or above `level`, put in where there is none.
std::size_t point_at_level(Polyline& ground, const Descent& face, double level) {
    for (std::size_t i = face.toe; i > face.crest; --i) {
        const Vec2& below = ground[i];
        const Vec2& above = ground[i - 1];
        if (above.y() < level) continue;
        const double share = (level - below.y()) / (above.y() - below.y());
        if (share > 1 - same_point) return i - 1;
        if (share < same_point) return i;
        const Vec2 point = below + share * (above - below);
        ground.insert(ground.begin() + static_cast<long>(i), point);
        return i;
    }
    return face.toe;
}

/// The toe of a face cut short at a ditch: before that, the ground may have been level.
std::size_t lowest_of_face(const Polyline& ground, const Descent& face, double inclination) {
    const double slope = std::tan(inclination / 2);
    std::size_t lowest = face.toe;
    for (std::size_t i = face.toe; i > face.crest; --i)
        if (ground[i].y() + slope * ground[i].x() < ground[lowest].y() + slope * ground[lowest].x())
            lowest = i;
    return lowest;
}

/// A straight line.
struct Line {
    Vec2 point;
    Vec2 direction;  ///< of length 1
};

double distance_to(const Line& line, const Vec2& point) {
    const Vec2 d = point - line.point;
    return std::abs(line.direction.x() * d.y() - line.direction.y() * d.x());
}

/// Least squares of the distances of the ground between two vertices, each part of it counting by its length;
/// none where the ground is not straight there.
std::optional<Line> fitted(const Polyline& ground, std::size_t from, std::size_t to, double off) {
    double length = 0;
    Vec2 centre(0, 0);
    for (std::size_t i = from; i < to; ++i) {
        const double part = (ground[i + 1] - ground[i]).norm();
        length += part;
        centre += part * 0.5 * (ground[i] + ground[i + 1] - 2 * ground[from]);
    }
    centre = ground[from] + centre / length;
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (std::size_t i = from; i < to; ++i) {
        const Vec2 a = ground[i] - centre;
        const Vec2 b = ground[i + 1] - centre;
        const double part = (b - a).norm() / 3;
        xx += part * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x());
        yy += part * (a.y() * a.y() + a.y() * b.y() + b.y() * b.y());
        xy += part * (a.x() * a.y() + 0.5 * (a.x() * b.y() + a.y() * b.x()) + b.x() * b.y());
    }
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
    const Line line{centre, {std::cos(angle), std::sin(angle)}};
    for (std::size_t i = from; i <= to; ++i)
        if (distance_to(line, ground[i]) > off) return std::nullopt;
    return line;
}

std::optional<Vec2> meeting(const Line& a, const Line& b) {
    const double sine = a.direction.x() * b.direction.y() - a.direction.y() * b.direction.x();
    if (std::abs(sine) < sharpest_flat) return std::nullopt;
    const Vec2 d = b.point - a.point;
    return a.point + (d.x() * b.direction.y() - d.y() * b.direction.x()) / sine * a.direction;
}

/// The vertices from `end` away, one step after another, as long as the way along the ground from there is no
/// longer than `length`: the index of the last.
std::size_t last_within(const Polyline& ground, std::size_t end, int step, double length) {
    std::size_t last = end;
    double way = 0;
    for (std::size_t i = end; step > 0 ? i + 1 < ground.size() : i > 0;) {
        const std::size_t next = step > 0 ? i + 1 : i - 1;
        way += (ground[next] - ground[i]).norm();
        if (way > length) break;
        last = i = next;
    }
    return last;
}

std::optional<Line> line_beside(const Polyline& ground, std::size_t end, int step, double length,
                                double off) {
    const std::size_t near = step > 0 ? end + 1 : end - 1;
    const std::size_t far = last_within(ground, near, step, length);
    if (far == near) return std::nullopt;
    return fitted(ground, std::min(near, far), std::max(near, far), off);
}

/// Where lines fitted to the ground on both sides of `end` meet, no further from it than its neighbours; none
/// where points are corners. `face` is +1 where the face is to the right of it.
std::optional<Vec2> bend_at(const Polyline& ground, std::size_t end, int face, double scale) {
    if (end < 2 || end + 2 >= ground.size()) return std::nullopt;
    const double longest = densest_gap * scale;
    const Vec2 here = ground[end];
    if ((ground[end - 1] - here).norm() > longest || (ground[end + 1] - here).norm() > longest)
        return std::nullopt;
    const double off = straight * scale;
    const auto slope = line_beside(ground, end, face, fitted_face * scale, off);
    const double level_length = (face < 0 ? fitted_level_below : fitted_level_above) * scale;
    const auto level = line_beside(ground, end, -face, level_length, off);
    if (!slope || !level || std::min(distance_to(*slope, here), distance_to(*level, here)) > off)
        return std::nullopt;
    const auto bend = meeting(*slope, *level);
    const bool near = bend && bend->x() > ground[end - 1].x() && bend->x() < ground[end + 1].x();
    return near ? bend : std::nullopt;
}

/// The index of a point of the ground next to `end` and at `x`, put in unless one is as good as there.
std::size_t point_beside(Polyline& ground, std::size_t end, double x) {
    const std::size_t left = x < ground[end].x() ? end - 1 : end;
    const double share = (x - ground[left].x()) / (ground[left + 1].x() - ground[left].x());
    if (!(share > same_point && share < 1 - same_point)) return end;  // also where it is vertical
    const Vec2 point(x, ground[left].y() + share * (ground[left + 1].y() - ground[left].y()));
    ground.insert(ground.begin() + static_cast<long>(left) + 1, point);
    return left + 1;
}

}  // namespace

PlacedEnds placed_ends(Polyline& ground, const Face& face, double scale, const GivenEnds& given) {
    Descent ends = face.ends;
    std::optional<Vec2> toe;
    std::optional<Vec2> crest;
    const auto rim = given.toe ? std::nullopt : rim_above(ground, ends.toe, scale);
    if (rim)
        ends.toe = lowest_of_face(ground, {ends.crest, point_at_level(ground, ends, *rim)}, face.inclination);
    else if (!given.toe)
        toe = bend_at(ground, ends.toe, -1, scale);
    if (!given.crest) crest = bend_at(ground, ends.crest, +1, scale);
    if (toe) ends.toe = point_beside(ground, ends.toe, toe->x());
    const std::size_t points = ground.size();
    if (crest) ends.crest = point_beside(ground, ends.crest, crest->x());
    ends.toe += ground.size() - points;
    const Vec2 rise = crest.value_or(ground[ends.crest]) - toe.value_or(ground[ends.toe]);
    return {ends, std::atan2(rise.y(), -rise.x())};
}

}  // namespace runout
