#include "profile/checked_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/input_error.h"

namespace runout {
namespace {

// More is a slip: the earth is smaller. Nearer points would be one after the origin is moved to the toe.
constexpr double farthest_m = 1e8;

/// Points in file order, each with the line it stands on.
struct Section {
    std::vector<Vec2> points;
    std::vector<int> lines;
    const std::string& file;

    [[nodiscard]] InputPlace place(std::size_t i, const std::string& key, double value) const {
        return {file, i < lines.size() ? lines[i] : 0, key, fmt::format("{:.12g}", value)};
    }
};

void check_point(const Section& s, std::size_t i) {
    const Vec2& p = s.points[i];
    if (!p.allFinite())
        throw InputError(s.place(i, "chainage_m, elevation_m", std::isfinite(p.x()) ? p.y() : p.x()),
                         "is not a finite number", "give metres, such as 12.5");
    if (std::max(std::abs(p.x()), std::abs(p.y())) > farthest_m)
        throw InputError(s.place(i, "chainage_m, elevation_m", std::abs(p.x()) > farthest_m ? p.x() : p.y()),
                         "is out of range", fmt::format("give metres up to {:g} of either sign", farthest_m));
    if (i == 0) return;
    const Vec2& before = s.points[i - 1];
    if (p.x() < before.x())
        throw InputError(s.place(i, "chainage_m", p.x()),
                         fmt::format("goes back behind {:.12g}, which is an overhang", before.x()),
                         "list the points so that the chainage never decreases");
    if ((p - before).norm() < nearest_points_m)
        throw InputError(s.place(i, "chainage_m", p.x()), "repeats the point before it",
                         "give each point once; a vertical face is two points with different elevations");
}

/// Keeps the two ends of a vertical face that is given by more points.
Section without_inner_points_of_walls(const Section& s) {
    Section kept{{}, {}, s.file};
    for (std::size_t i = 0; i < s.points.size(); ++i) {
        const std::size_t n = kept.points.size();
        if (n >= 2 && kept.points[n - 1].x() == s.points[i].x() &&
            kept.points[n - 2].x() == s.points[i].x()) {
            const double first = kept.points[n - 1].y() - kept.points[n - 2].y();
            const double next = s.points[i].y() - kept.points[n - 1].y();
            if (first * next < 0)
                throw InputError(s.place(i, "elevation_m", s.points[i].y()),
                                 fmt::format("goes up and down at the chainage {:.12g}", s.points[i].x()),
                                 "a vertical face is two points with one chainage");
            kept.points.pop_back();
            if (!kept.lines.empty()) kept.lines.pop_back();
        }
        kept.points.push_back(s.points[i]);
        if (i < s.lines.size()) kept.lines.push_back(s.lines[i]);
    }
    return kept;
}

/// Chainages as good as equal are one, that of the first: a vertical face, and not a sliver whose two sides
/// become one when the origin is moved to the toe.
void make_walls_vertical(Section& s) {
    for (std::size_t i = 1; i < s.points.size(); ++i)
        if (s.points[i].x() < s.points[i - 1].x() + nearest_points_m) s.points[i].x() = s.points[i - 1].x();
}

}  // namespace

std::vector<Vec2> checked_points(const SectionPoints& given) {
    const auto& [points, lines, file, read_as, map_line] = given;
    Section section{points, lines, file};
    if (points.size() < 2)
        throw InputError({file, 0, "", ""}, points.empty() ? "has no points" : "has one point only",
                         "a section needs at least two points");
    for (std::size_t i = 0; i < points.size(); ++i) check_point(section, i);
    make_walls_vertical(section);
    return without_inner_points_of_walls(section).points;
}

}  // namespace runout
