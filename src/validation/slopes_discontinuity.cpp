#include "validation/slopes_discontinuity.h"

#include <fmt/format.h>

#include <cmath>

#include "core/units.h"
#include "validation/discontinuity.h"
#include "validation/slopes_shared.h"

namespace runout::slopes {
namespace {

constexpr const char* id = "fig15";
constexpr const char* instant = "[0.045]";
constexpr double face_deg = 70, base_deg = 35;
constexpr double crest = 0.384, exit_height = 0.384 - 0.15;     // above the toe, m
constexpr double base_length = 0.068495, scarp_top = 0.075629;  // behind P, m (cases/fig15)
constexpr double paper_deg = 55, band_deg = 4;

Vec2 on_face(double height) {
    return {-height / std::tan(radians(face_deg)), height};
}

Snapshot first_snapshot(const CaseRuns& runs, const std::string& run) {
    const std::vector<Snapshot> snapshots = runs.snapshots(run);
    return snapshots.empty() ? Snapshot{} : snapshots.front();
}

/// The plane through P that parts soil faster than `share` of the front's mean speed from the rest with the
/// fewest particles on the wrong side, rad.
double plane_of_speed(const Snapshot& s, const Vec2& exit, double share) {
    const double limit = share * find_discontinuity(s, exit).front_speed;
    std::size_t fewest = s.x_m.size() + 1;
    double best = ValidationEntry::none;
    const PlaneSearch search;
    for (double angle = search.lowest; angle <= search.highest; angle += search.step) {
        const Vec2 normal(std::sin(angle), std::cos(angle));
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < s.x_m.size(); ++i) {
            const bool front = (Vec2(s.x_m[i], s.y_m[i]) - exit).dot(normal) > 0.0;
            if (front != (std::hypot(s.vx_m_s[i], s.vy_m_s[i]) > limit)) ++wrong;
        }
        if (wrong < fewest) {
            fewest = wrong;
            best = angle;
        }
    }
    return best;
}

Estimate speed_plane(const CaseRuns& runs, double share) {
    return estimate(runs, id, [&](const std::string& run) {
        return degrees(plane_of_speed(first_snapshot(runs, run), on_face(exit_height), share));
    });
}

/// `quantity(discontinuity)` over the ensemble.
template <class Quantity>
Estimate over_lattices(const CaseRuns& runs, const Quantity& quantity) {
    return estimate(runs, id, [&](const std::string& run) {
        return quantity(find_discontinuity(first_snapshot(runs, run), on_face(exit_height)));
    });
}

Curve line_at(double angle, const std::string& label, Curve::Style style) {
    const Vec2 exit = on_face(exit_height);
    const double length = (crest - exit_height) / std::sin(angle);
    return {label, style, {exit, exit + length * Vec2(-std::cos(angle), std::sin(angle))}};
}

Figure velocity_figure(const CaseRuns& runs, double angle) {
    const Vec2 exit = on_face(exit_height);
    const Vec2 foot = exit + base_length * Vec2(-std::cos(radians(base_deg)), std::sin(radians(base_deg)));
    Figure figure{"discontinuity",
                  "Source of Fig. 15 at 0.045 s: where fast soil meets slow",
                  "x, m",
                  "y, m",
                  {},
                  true,
                  false};
    figure.curves.push_back({"source before release",
                             Curve::Style::line,
                             {exit, on_face(crest), {exit.x() - scarp_top, crest}, foot, exit}});
    figure.curves.push_back({"greatest change of speed, strip by strip", Curve::Style::markers,
                             discontinuity_trace(first_snapshot(runs, lattices_of(id).front()), exit)});
    figure.curves.push_back(
        line_at(angle, fmt::format("plane found, {:.1f} deg", degrees(angle)), Curve::Style::line));
    figure.curves.push_back(line_at(radians(paper_deg), "55 deg (the paper)", Curve::Style::dashed));
    return figure;
}

}  // namespace

void plan_discontinuity(std::vector<PlannedRun>& runs) {
    plan_ensemble(runs, id, "fig15/case.toml", {{"run.snapshot_times_s", instant}}, "run.resolution", 30);
}

void add_discontinuity(CaseReport& report, const CaseRuns& runs) {
    const std::string resolution = "sqrt(S)/dl = 30";
    const Estimate angle = over_lattices(runs, [](const Discontinuity& d) { return degrees(d.angle); });
    ValidationEntry entry = held(angle, "discontinuity angle of Fig. 15's source at 0.045 s, deg",
                                 {"the paper, text and Fig. 15", paper_deg, band_deg}, resolution,
                                 "plane through P with the greatest variance of speed between its sides");
    entry.kind = DeviationKind::absolute;
    report.entries.push_back(entry);
    report.entries.push_back(held(over_lattices(runs, [](const Discontinuity& d) { return d.contrast; }),
                                  "share of the variance of speed that the plane explains", {}, resolution,
                                  "1: two rigid blocks; 0.75: speed rising evenly across a slab"));
    report.entries.push_back(
        held(over_lattices(runs, [](const Discontinuity& d) { return d.rear_speed / d.front_speed; }),
             "speed below the plane over speed above it", {}, resolution));
    for (const double share : {0.5, 0.9})
        report.entries.push_back(
            held(speed_plane(runs, share),
                 fmt::format("plane through P below which soil has less than {:g} of the front's speed, deg",
                             share),
                 {"the paper, text and Fig. 15", paper_deg}, resolution));
    report.figures.push_back(velocity_figure(runs, radians(angle.mean)));
}

}  // namespace runout::slopes
