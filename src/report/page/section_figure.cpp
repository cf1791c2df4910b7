#include "report/page/section_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/units.h"
#include "engine/particles/bed_line.h"

namespace runout {
namespace {

/// The bed of the source: the part of its outline that is bed and not ground.
Polyline slip_surface(const SectionGeometry& geometry) {
    const auto& outline = geometry.outline;
    if (outline.empty()) return {};
    const auto [first, last] = std::ranges::minmax(outline, {}, [](const Vec2& point) { return point.x(); });
    return clipped(geometry.bed, first.x(), last.x());
}

double greatest_x(const Polyline& line) {
    double x = -1e300;
    for (const Vec2& point : line) x = std::max(x, point.x());
    return x;
}

/// Bed and surface of the deposit as one closed polygon.
Polyline deposit_polygon(const RunData& run) {
    Polyline polygon = deposit_surface(run);
    if (polygon.empty()) return polygon;
    Polyline bed = clipped(run.geometry.bed, polygon.front().x(), polygon.back().x());
    std::ranges::reverse(bed);
    polygon.insert(polygon.end(), bed.begin(), bed.end());
    polygon.push_back(polygon.front());
    return polygon;
}

Polyline closed(const Polygon& polygon) {
    Polyline line = polygon;
    if (!line.empty()) line.push_back(line.front());
    return line;
}

}  // namespace

Polyline clipped(const Polyline& line, double from, double to) {
    Polyline kept;
    const auto crossing = [](const Vec2& a, const Vec2& b, double x) {
        return Vec2(x, a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x()));
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool inside = line[i].x() >= from && line[i].x() <= to;
        if (i > 0) {
            const Vec2& a = line[i - 1];
            const Vec2& b = line[i];
            for (const double x : {from, to})
                if (a.x() < x && b.x() > x) kept.push_back(crossing(a, b, x));
        }
        if (inside) kept.push_back(line[i]);
    }
    return kept;
}

Polyline deposit_surface(const RunData& run) {
    Polyline surface;
    for (const DepositRow& row : run.deposit) {
        if (!std::isfinite(row.thickness_by_top_m)) continue;
        surface.push_back(run.geometry.profile.to_local(
            {row.chainage_m, row.bed_elevation_m + std::max(0.0, row.thickness_by_top_m)}));
    }
    if (!run.geometry.profile.descends_with_chainage) std::ranges::reverse(surface);
    return surface;
}

SectionWindow section_view(const RunData& run) {
    const Polyline surface = deposit_surface(run);
    Polyline shown = run.geometry.outline;
    shown.insert(shown.end(), surface.begin(), surface.end());
    shown.emplace_back(0, 0);
    for (const PlaceRecord& place : run.run.places) {
        const double near = run.geometry.profile.to_local({place.chainage_m, 0}).x();
        shown.emplace_back(near + place.width_m, BedLine(run.geometry.profile.ground).elevation(near));
    }
    SectionWindow view{shown.front(), shown.front()};
    for (const Vec2& point : shown) {
        view.low = view.low.cwiseMin(point);
        view.high = view.high.cwiseMax(point);
    }
    const double margin = 0.06 * std::max(view.high.x() - view.low.x(), view.high.y() - view.low.y());
    view.low -= Vec2(2 * margin, margin);
    view.high += Vec2(2 * margin, margin);
    return view;
}

Polyline discontinuity_line(const SectionGeometry& geometry) {
    // Long enough for the source, cut where it has risen to the top of the source's outline above it.
    const Vec2 direction(-std::cos(geometry.discontinuity_angle), std::sin(geometry.discontinuity_angle));
    double length = 0;
    const auto& outline = geometry.outline;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 a = outline[i] - geometry.exit_point;
        const Vec2 b = outline[(i + 1) % outline.size()] - geometry.exit_point;
        const double side_a = direction.x() * a.y() - direction.y() * a.x();
        const double side_b = direction.x() * b.y() - direction.y() * b.x();
        if (side_a * side_b > 0 || side_a == side_b) continue;
        const Vec2 crossing = a + (b - a) * (side_a / (side_a - side_b));
        length = std::max(length, crossing.dot(direction));
    }
    if (!(length > 0)) return {};
    return {geometry.exit_point, geometry.exit_point + length * direction};
}

namespace {

/// A number that the case gave for the barrier; NaN: none.
double barrier_number(const StoredRun& run, const char* key) {
    for (const EffectSetting& setting : run.effect_settings)
        if (setting.effect == "barrier" && setting.key == key) return std::atof(setting.value.c_str());
    return std::nan("");
}

/// Its outline; no points where there is none.
Curve barrier_curve(const RunData& run) {
    const double height = barrier_number(run.run, "height_m");
    if (!(height > 0)) return {"barrier", Curve::Style::line, {}};
    const BedLine ground(run.geometry.profile.ground);
    const double foot = run.geometry.profile.to_local({barrier_number(run.run, "chainage_m"), 0}).x();
    const double inclination = radians(barrier_number(run.run, "inclination_deg"));
    const double edge = foot + (std::isnan(inclination) ? 0.0 : height / std::tan(inclination));
    const double back = edge + std::max(0.0, barrier_number(run.run, "thickness_m"));
    const double top = ground.elevation(foot) + height;
    return {"barrier",
            Curve::Style::line,
            {{foot, ground.elevation(foot)}, {edge, top}, {back, top}, {back, ground.elevation(back)}}};
}

}  // namespace

Polyline place_posts(const RunData& run, const PlaceRecord& place, const SectionWindow& view) {
    const double near = run.geometry.profile.to_local({place.chainage_m, 0}).x();
    const BedLine ground(run.geometry.profile.ground);
    const double top = ground.elevation(near) + 0.1 * (view.high.y() - view.low.y());
    Polyline posts = {{near, ground.elevation(near)}, {near, top}};
    if (place.width_m > 0) {
        const double far = near + place.width_m;
        posts.insert(posts.end(), {{far, top}, {far, ground.elevation(far)}});
    }
    return posts;
}

Figure section_figure(const RunData& run) {
    const SectionWindow view = section_view(run);
    const auto& geometry = run.geometry;
    Figure figure{"section", "Section to scale", "distance from the toe, m", "elevation above the toe, m", {},
                  true};
    figure.curves.push_back({"deposit", Curve::Style::area, deposit_polygon(run)});
    figure.curves.push_back(
        {"ground before", Curve::Style::line, clipped(geometry.profile.ground, view.low.x(), view.high.x())});
    figure.curves.push_back({"source", Curve::Style::dashed, closed(geometry.outline)});
    figure.curves.push_back({"slip surface", Curve::Style::line, slip_surface(geometry)});
    figure.curves.push_back(
        {"discontinuity line (front above it)", Curve::Style::dashed, discontinuity_line(geometry)});
    const Polyline surface = deposit_surface(run);
    figure.curves.push_back({"surface of the deposit", Curve::Style::line, surface});
    figure.curves.push_back(barrier_curve(run));
    for (const PlaceRecord& place : run.run.places)
        figure.curves.push_back({place.name, Curve::Style::line, place_posts(run, place, view)});
    std::erase_if(figure.curves, [](const Curve& curve) { return curve.points.empty(); });
    if (greatest_x(surface) < -1e299) figure.title = "Section to scale; no deposit is stored";
    return figure;
}

}  // namespace runout
