// Masses given by coordinates: any simple polygon, or the ground above a slip line.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ranges>

#include "source/polygon_place.h"
#include "source/shapes.h"
#include "source/spec_check.h"

namespace runout {
namespace {

constexpr const char* points_key = "source.points";

// Below this a coordinate is 0: exact arithmetic on numbers near the smallest double leaves its intervals, m.
constexpr double dust = 1e-12;

/// The user's coordinates are decimals: what is nearer to the ground than this is on it.
double contact_tolerance(double area) {
    return 1e-3 * std::sqrt(area);
}

std::vector<Vec2> local_points(const Profile& profile, const SourceSpec& spec) {
    std::vector<Vec2> points;
    for (const SectionPoint& p : spec.points) points.push_back(profile.to_local(p));
    const double left = profile.ground.front().x();
    const double right = profile.ground.back().x();
    // A decimal may miss the end of the section by its rounding.
    const double rounding = 1e-9 * (right - left);
    for (Vec2& p : points) {
        if (p.x() < left - rounding || p.x() > right + rounding)
            refuse(spec, points_key, fmt::format("leaves the section at {}", shown(profile, p)),
                   fmt::format("the section goes from {} to {}", shown(profile, profile.ground.front()),
                               shown(profile, profile.ground.back())));
        p.x() = std::clamp(p.x(), left, right);
        for (double* c : {&p.x(), &p.y()})
            if (std::abs(*c) < dust) *c = 0;
    }
    return points;
}

void add_crossing(std::vector<Vec2>& points, const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const Vec2 ab = b - a;
    const Vec2 cd = d - c;
    const double cross = ab.x() * cd.y() - ab.y() * cd.x();
    if (cross == 0) return;
    const Vec2 ac = c - a;
    const double t = (ac.x() * cd.y() - ac.y() * cd.x()) / cross;
    const double u = (ac.x() * ab.y() - ac.y() * ab.x()) / cross;
    if (t >= 0 && t <= 1 && u >= 0 && u <= 1) points.emplace_back(a + t * ab);
}

/// Corners on or in the ground, and points where the outline passes through its surface.
std::vector<Vec2> contact_points(const Polygon& outline, const Polyline& ground, double tolerance) {
    std::vector<Vec2> contact;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2& a = outline[i];
        const Vec2& b = outline[(i + 1) % outline.size()];
        if (a.y() <= elevation_at(ground, a.x()) || distance(a, ground) <= tolerance) contact.push_back(a);
        for (std::size_t k = 0; k + 1 < ground.size(); ++k)
            add_crossing(contact, a, b, ground[k], ground[k + 1]);
    }
    return contact;
}

bool more_downhill(const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() > b.x() : a.y() < b.y();
}

bool higher(const Vec2& a, const Vec2& b) {
    return a.y() != b.y() ? a.y() > b.y() : a.x() < b.x();
}

Vec2 highest(const std::vector<Vec2>& points) {
    return *std::ranges::min_element(points, higher);
}

Vec2 most_downhill(const std::vector<Vec2>& points) {
    return *std::ranges::min_element(points, more_downhill);
}

Vec2 lowest(const std::vector<Vec2>& points) {
    return *std::ranges::max_element(points, higher);
}

/// A mass whose outline follows the ground to the last decimal but one would leave slivers; it takes none of
/// it.
bool stands_on(const Polyline& ground, const Polyline& bed, double tolerance) {
    const auto near = [tolerance](const Polyline& line) {
        return [&line, tolerance](const Vec2& p) { return distance(p, line) <= tolerance; };
    };
    return std::ranges::all_of(bed, near(ground)) && std::ranges::all_of(ground, near(bed));
}

/// An end of a slip line, brought to the surface when it misses it by no more than the rounding of a drawing.
Vec2 daylight(const Profile& profile, const SourceSpec& spec, const Vec2& end, double tolerance) {
    const double surface = elevation_at(profile.ground, end.x());
    if (end.y() >= surface) return end;
    const Vec2 on_ground = nearest(end, profile.ground);
    if ((on_ground - end).norm() <= tolerance) return on_ground;
    refuse(spec, points_key, fmt::format("ends inside the ground at {}", shown(profile, end)),
           fmt::format("go on to the surface, which is at {} there", shown(profile, {end.x(), surface})));
}

}  // namespace

Source derive_polygon(const Profile& profile, const SourceSpec& spec) {
    std::vector<Vec2> corners = local_points(profile, spec);
    if (corners.front() == corners.back()) corners.pop_back();  // a closed ring, as map data have it
    const auto region = simple_polygon(corners);
    if (!region || is_film(region->area(), corners))
        refuse(spec, points_key, "is not a simple polygon",
               "list three corners or more in order around the source, without crossing or touching lines");

    const Polygon outline = region->outline();
    const double tolerance = contact_tolerance(region->area());
    const std::vector<Vec2> contact = contact_points(outline, profile.ground, tolerance);
    const auto surfaces = [&](const Vec2& p) { return distance(p, profile.ground) <= tolerance; };
    if (!contact.empty() && std::ranges::none_of(contact, surfaces))
        refuse(spec, points_key, "lies under the ground and nowhere reaches its surface",
               "give a polygon that has a part of the surface on its outline");
    const Vec2 exit = contact.empty() ? lowest(outline) : most_downhill(contact);
    // On level ground no contact is higher than the exit, and the drop is that of the mass itself.
    const bool leans = !contact.empty() && highest(contact).y() > exit.y() + tolerance;
    const Vec2 head = leans ? highest(contact) : highest(outline);

    Source source = source_from(*region, profile, spec, exit, head);
    if (stands_on(profile.ground, source.bed, tolerance))
        source.bed = without_needless_points(profile.ground, 1e-10 * extent(profile.ground));
    return source;
}

PolygonPlace polygon_place(const Polyline& ground, const Polygon& outline) {
    const auto region = simple_polygon(outline);
    if (!region) return {};
    return {region->area(), region->area_in(ground), region->air_below(ground)};
}

Source derive_slip_surface(const Profile& profile, const SourceSpec& spec) {
    Polyline line = local_points(profile, spec);
    if (line.front().x() > line.back().x()) std::ranges::reverse(line);
    const Polyline& ground = profile.ground;
    const double contact = 1e-3 * extent(line);
    for (std::size_t i = 1; i < line.size(); ++i)
        if (line[i].x() < line[i - 1].x())
            refuse(spec, points_key, fmt::format("turns back at {}", shown(profile, line[i - 1])),
                   "list the slip line from end to end, its chainage always going the same way");
    line.front() = daylight(profile, spec, line.front(), contact);
    line.back() = daylight(profile, spec, line.back(), contact);

    const auto pieces = ground_above(ground, line);
    if (!pieces)
        refuse(spec, points_key, "doubles back on itself", "list each point of the slip line once, in order");
    const auto real = std::ranges::count_if(
        *pieces, [&](const Region& piece) { return piece.area() > 1e-9 * pieces->front().area(); });
    if (real != 1)
        refuse(spec, points_key, fmt::format("cuts off {} pieces of ground", real),
               "the slip line must cut off exactly one");
    if (is_film(pieces->front().area(), line))
        refuse(spec, points_key, "cuts off a film of ground without thickness",
               "draw the slip line below the surface");
    const Polygon outline = pieces->front().outline();
    const Vec2 head = *std::ranges::min_element(
        outline, [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() > b.y(); });
    return source_from(pieces->front(), profile, spec, most_downhill(outline), head);
}

}  // namespace runout
