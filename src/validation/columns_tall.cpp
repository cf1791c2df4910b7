#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "validation/columns_laws.h"
#include "validation/profile_misfit.h"
#include "validation/suite_cases.h"

namespace runout {
namespace {

constexpr double none = ValidationEntry::none;
constexpr double full_spacing = 0.0016, quick_spacing = 0.0032;

/// A column of the paper's Fig. 7.
struct TallColumn {
    std::string id, label;
    std::string file = "tall-columns/case.toml";
    double friction_angle = 40;  // deg
    double length = 0.02, height = 0.25;
    double plane_deg = 0;
    std::string points = {};  ///< in place of those of the file
};

std::string upright(double length, double height) {
    return fmt::format("[[0, 0], [{0:.9g}, 0], [{0:.9g}, {1:.9g}], [0, {1:.9g}]]", length, height);
}

/// The column of the file as it stands in a box tilted with the plane: its sides are normal to the plane.
std::string tilted(double length, double height, double plane_deg) {
    const double t = radians(plane_deg);
    const Vec2 foot = length * Vec2(std::cos(t), -std::sin(t));
    const Vec2 top = height * Vec2(std::sin(t), std::cos(t));
    return fmt::format("[[0, 0], [{:.9g}, {:.9g}], [{:.9g}, {:.9g}], [{:.9g}, {:.9g}]]", foot.x(), foot.y(),
                       foot.x() + top.x(), foot.y() + top.y(), top.x(), top.y());
}

TallColumn material(const char* name, double friction_angle) {
    return {name, fmt::format("{}, phi {}", name, friction_angle), "tall-columns/case.toml", friction_angle};
}

TallColumn grit_column(const char* name, double length, double height) {
    return {fmt::format("grit-{}", name),
            fmt::format("{}: {} x {} cm", name, 100 * length, 100 * height),
            "tall-columns/case.toml",
            47,
            length,
            height,
            0,
            upright(length, height)};
}

TallColumn on_plane(double plane_deg) {
    return {fmt::format("slope-{:02.0f}", plane_deg),
            fmt::format("plane of {:.0f} deg", plane_deg),
            fmt::format("tall-columns/slope-{:02.0f}.toml", plane_deg),
            40,
            0.02,
            0.25,
            plane_deg};
}

TallColumn leaning(double plane_deg) {
    TallColumn column = on_plane(plane_deg);
    column.id += "-leaning";
    column.points = tilted(column.length, column.height, plane_deg);
    return column;
}

std::vector<TallColumn> materials() {
    return {material("glass", 27), material("sand", 40), material("grit", 47)};
}

std::vector<TallColumn> grit_columns() {
    return {grit_column("A", 0.06, 0.12), grit_column("B", 0.04, 0.08), grit_column("C", 0.02, 0.16)};
}

std::vector<TallColumn> planes() {
    return {material("sand", 40), on_plane(5), on_plane(10), on_plane(15)};
}

std::vector<TallColumn> all_columns(bool quick) {
    std::vector<TallColumn> all = materials();
    if (quick) return all;
    std::ranges::copy(grit_columns(), std::back_inserter(all));
    std::ranges::copy(std::vector{on_plane(5), on_plane(10), on_plane(15), leaning(15)},
                      std::back_inserter(all));
    return all;
}

std::vector<PlannedRun> plan_tall(bool quick) {
    std::vector<PlannedRun> plan;
    for (const TallColumn& column : all_columns(quick)) {
        Settings set{{"material.friction_angle_deg", fmt::format("{}", column.friction_angle)}};
        if (!column.points.empty()) set.emplace_back("source.points", column.points);
        plan_ensemble(plan, column.id, column.file, set, "run.particle_spacing_m",
                      quick ? quick_spacing : full_spacing);
    }
    return plan;
}

std::string resolution_of(bool quick) {
    const double spacing = quick ? quick_spacing : full_spacing;
    return fmt::format("dl = {} mm, {:.0f} particles in 2 x 25 cm", 1000 * spacing,
                       0.02 * 0.25 / (spacing * spacing));
}

Estimate front_of(const CaseRuns& runs, const TallColumn& column) {
    return estimate(runs, column.id,
                    [&](const std::string& run) { return runs.run(run).measures.front_mass_995_m; });
}

/// "b goes further than a" as a number: run-out a / run-out b, at most 1.
void add_order(CaseReport& report, const CaseRuns& runs, const TallColumn& shorter, const TallColumn& further,
               const std::string& why, bool quick) {
    report.entries.push_back(limited(ratio(front_of(runs, shorter), front_of(runs, further)),
                                     fmt::format("run-out of {} / {}", shorter.label, further.label),
                                     {"paper, Fig. 7: " + why, none, 1.0}, resolution_of(quick)));
}

void add_laws(CaseReport& report, const CaseRuns& runs, bool quick) {
    for (const TallColumn& column : materials()) {
        const double aspect = column.height / column.length;
        Estimate front = front_of(runs, column);
        front.mean /= column.length;
        front.scatter /= column.length;
        front.error /= column.length;
        const std::string quantity = fmt::format("L_inf/L0, {}, a = {}", column.label, aspect);
        report.entries.push_back(
            held(front, quantity, {"Lube et al. 2005", lube_front(aspect)}, resolution_of(quick)));
        if (column.id == "glass")
            report.entries.push_back(held(front, quantity,
                                          {"Lajeunesse et al. 2005, law", 1.0 + lajeunesse_run_out(aspect)},
                                          resolution_of(quick)));
    }
}

double surface_angle(const std::vector<Vec2>& surface, double run_out) {
    std::vector<Vec2> middle;
    for (const Vec2& p : surface)
        if (p.x() >= 0.25 * run_out && p.x() <= 0.75 * run_out) middle.push_back(p);
    if (middle.size() < 3) return none;
    return degrees(std::atan(-fit_line(middle).slope));
}

/// What every column must keep: its area, and a surface no steeper than its repose.
void add_limits(CaseReport& report, const CaseRuns& runs, const TallColumn& column, bool quick) {
    const Estimate area = estimate(runs, column.id, [&](const std::string& run) {
        const Measures measures = runs.run(run).measures;
        return measures.deposit_area_m2 / measures.source_area_m2;
    });
    report.entries.push_back(held(area, "area of the deposit / of the column, " + column.label,
                                  {"exact", 1.0, 0.02}, resolution_of(quick)));
    const Estimate angle = estimate(runs, column.id, [&](const std::string& run) {
        return surface_angle(deposit_surface(runs.deposit(run)), runs.run(run).measures.front_mass_995_m);
    });
    const double repose = degrees(std::atan(std::sin(radians(column.friction_angle))));
    report.entries.push_back(limited(angle, "slope of the middle half of the deposit, deg, " + column.label,
                                     {fmt::format("angle of repose {:.1f} deg", repose), none, repose},
                                     resolution_of(quick)));
}

/// Distance along the plane and height normal to it, over sqrt(S).
std::vector<Vec2> normalised(const std::vector<Vec2>& surface, const TallColumn& column) {
    const double t = radians(column.plane_deg);
    const double unit = std::sqrt(column.length * column.height);
    std::vector<Vec2> points;
    for (const Vec2& p : surface)
        points.emplace_back((p.x() * std::cos(t) - p.y() * std::sin(t)) / unit,
                            (p.x() * std::sin(t) + p.y() * std::cos(t)) / unit);
    return points;
}

Figure figure_of(const CaseRuns& runs, const std::vector<TallColumn>& columns, const std::string& name,
                 const std::string& title) {
    Figure figure{name, title, "along the bed / sqrt(S)", "normal to it / sqrt(S)", {}, true, false};
    for (const TallColumn& column : columns) {
        const std::string run = lattices_of(column.id).front();
        figure.curves.push_back(
            {column.label, Curve::Style::line, normalised(deposit_surface(runs.deposit(run)), column)});
    }
    return figure;
}

void add_grit(CaseReport& report, const CaseRuns& runs) {
    const std::vector<TallColumn> grit = grit_columns();
    add_order(report, runs, grit[1], grit[0], "larger area, same aspect", false);
    add_order(report, runs, grit[1], grit[2], "same area, higher aspect", false);
    report.figures.push_back(figure_of(runs, grit, "initial-size", "Grit, other initial sizes"));
}

void add_planes(CaseReport& report, const CaseRuns& runs) {
    const std::vector<TallColumn> steeper = planes();
    for (std::size_t k = 1; k < steeper.size(); ++k)
        add_order(report, runs, steeper[k - 1], steeper[k], "steeper plane", false);
    report.entries.push_back(held(ratio(front_of(runs, leaning(15)), front_of(runs, on_plane(15))),
                                  "run-out of a column that leans with the plane of 15 deg / upright",
                                  {"ours"}, resolution_of(false)));
    report.figures.push_back(figure_of(runs, steeper, "planes", "Quartz sand on planes"));
}

CaseReport evaluate_tall(const CaseRuns& runs, const std::string&, bool quick) {
    CaseReport report{"tall-columns", "Tall columns (paper Fig. 7)", {}, {}, {}};
    const std::vector<TallColumn> sorts = materials();
    add_order(report, runs, sorts[1], sorts[0], "smaller angle of repose", quick);
    add_order(report, runs, sorts[2], sorts[1], "smaller angle of repose", quick);
    add_laws(report, runs, quick);
    for (const TallColumn& column : sorts) add_limits(report, runs, column, quick);
    report.figures.push_back(figure_of(runs, sorts, "materials", "Column of 2 x 25 cm, three materials"));
    if (!quick) {
        add_grit(report, runs);
        add_planes(report, runs);
    }
    report.remarks.emplace_back(
        "The measured deposits of Balmforth & Kerswell (2005) are printed only as pictures, so the "
        "statements of the "
        "paper on its Fig. 7 are held as ratios of run-out (99.5 % mass point, along the plane).");
    report.remarks.emplace_back(
        "In a box that is tilted as a whole the wall leans over the soil. A section has no overhang, so on a "
        "plane the "
        "column stands with vertical sides, of the same base, area and height normal to the plane; one that "
        "leans "
        "with the plane before a vertical wall shows what that is worth.");
    return report;
}

}  // namespace

ValidationCase tall_columns_case() {
    return {"tall-columns", plan_tall, evaluate_tall};
}

}  // namespace runout
