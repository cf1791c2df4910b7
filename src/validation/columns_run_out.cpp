#include "validation/columns_run_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/units.h"
#include "validation/columns_laws.h"
#include "validation/data_file.h"
#include "validation/discontinuity.h"
#include "validation/suite_cases.h"

namespace runout {
namespace run_out_columns {
namespace {

constexpr const char* case_file = "column-run-out/case.toml";
constexpr double gravity = 9.81;
constexpr double none = ValidationEntry::none;
/// Aspect and (L_inf - L_0) / L_0 of the Mohr-Coulomb material points of Kumar (2015), friction angle 22.2
/// deg.
constexpr std::pair<double, double> kumar[] = {{0.4, 0.60}, {0.8, 1.18}, {1, 1.59},  {2, 3.20},
                                               {4, 7.97},   {6, 12.09},  {10, 17.08}};
constexpr std::array beads_aspects{0.5, 1.0, 2.0, 5.0};
constexpr double mangeney_length = 0.2, mangeney_height = 0.14, mangeney_repose_deg = 23.5;
constexpr double mangeney_front = 0.275;

double resolution(bool quick) {
    return quick ? 20.0 : 40.0;
}

std::string column(double length, double height) {
    return fmt::format("[[0, 0], [{0:.9g}, 0], [{0:.9g}, {1:.9g}], [0, {1:.9g}]]", length, height);
}

/// sin(phi) = tan(angle of repose), as the paper's table 1.
double mangeney_friction_angle() {
    return degrees(std::asin(std::tan(radians(mangeney_repose_deg))));
}

/// Shortly after release: the wedge has begun to move and has not yet changed its shape.
double early_instant() {
    return 0.3 * std::sqrt(root_area / gravity);
}

Settings column_settings(double friction_angle, double aspect) {
    return {{"source.points", column(length_of(aspect), aspect * length_of(aspect))},
            {"material.friction_angle_deg", fmt::format("{:.4f}", friction_angle)}};
}

std::vector<PlannedRun> plan_run_out(bool quick) {
    std::vector<PlannedRun> plan;
    const auto add = [&](const std::string& id, const Settings& set) {
        plan_ensemble(plan, id, case_file, set, "run.resolution", resolution(quick));
    };
    for (const double phi : friction_angles(quick))
        for (const double a : aspects(quick)) {
            Settings set = column_settings(phi, a);
            if (std::ranges::count(plane_aspects(quick), a) > 0)
                set.emplace_back("run.snapshot_times_s", fmt::format("[{:.4f}]", early_instant()));
            add(name_of(phi, a), set);
        }
    if (quick) return plan;
    for (const auto& [a, run_out] : kumar)
        add(name_of(kumar_friction_angle, a), column_settings(kumar_friction_angle, a));
    for (const double a : beads_aspects)
        add(name_of(beads_friction_angle, a), column_settings(beads_friction_angle, a));
    add("mangeney", {{"source.points", column(mangeney_length, mangeney_height)},
                     {"material.friction_angle_deg", fmt::format("{:.4f}", mangeney_friction_angle())}});
    return plan;
}

Estimate less_one(Estimate estimate) {
    estimate.mean -= 1.0;
    return estimate;
}

/// phi 37 against the law that does not ask for the material.
void add_lube(CaseReport& report, const Spread& spread, bool quick) {
    for (std::size_t k = 0; k < spread.aspects.size(); ++k) {
        const double a = spread.aspects[k];
        const bool judged = a >= 0.5 && a <= 10.0;
        std::string remark = fmt::format("contiguous front {:.2f}", spread.contiguous[k].mean);
        if (!judged) remark += "; outside the range that is judged";
        report.entries.push_back(
            held(spread.front[k], fmt::format("L_inf/L0, phi {}, a = {}", spread.friction_angle, a),
                 {"Lube et al. 2005", lube_front(a), judged ? 0.08 : none}, resolution_of(quick), remark));
    }
}

/// (a, (L_inf - L0)/L0) of Lajeunesse et al.
std::vector<Vec2> measured_run_outs(const std::string& folder) {
    return read_points(folder + "/lajeunesse2005_runout_digitised.csv");
}

std::string beside(double contiguous, double measured_near) {
    std::string remark = fmt::format("contiguous front {:.2f}", contiguous);
    if (!std::isnan(measured_near)) remark += fmt::format("; points near this a {:.2f}", measured_near);
    return remark;
}

/// phi 27, the paper's glass, against glass beads.
void add_lajeunesse(CaseReport& report, const Spread& spread, const std::vector<Vec2>& points) {
    for (std::size_t k = 0; k < spread.aspects.size(); ++k) {
        const double a = spread.aspects[k];
        const bool judged = spread.friction_angle == 27.0 && a <= 2.0;
        report.entries.push_back(
            held(less_one(spread.front[k]),
                 fmt::format("(L_inf - L0)/L0, phi {}, a = {}", spread.friction_angle, a),
                 {"Lajeunesse et al. 2005, law", lajeunesse_run_out(a), judged ? 0.15 : none},
                 resolution_of(false), beside(spread.contiguous[k].mean - 1.0, local_value(points, a))));
    }
}

void add_heights(CaseReport& report, const Spread& spread, const std::string& folder) {
    const auto heights = read_points(folder + "/lajeunesse2005_height_digitised.csv");
    for (std::size_t k = 0; k < spread.aspects.size(); ++k) {
        const double a = spread.aspects[k];
        report.entries.push_back(held(
            spread.height[k], fmt::format("H_inf/L0, phi 27, a = {}", a),
            {"Lajeunesse et al. 2005, points near a", local_value(heights, a), 0.12}, resolution_of(false)));
    }
}

void add_kumar(CaseReport& report, const CaseRuns& runs) {
    std::vector<double> columns;
    for (const auto& [a, run_out] : kumar) columns.push_back(a);
    const Spread spread = spread_of(runs, kumar_friction_angle, columns);
    for (std::size_t k = 0; k < columns.size(); ++k)
        report.entries.push_back(
            held(less_one(spread.front[k]), fmt::format("(L_inf - L0)/L0, phi 22.2, a = {}", columns[k]),
                 {"Kumar 2015, Mohr-Coulomb MPM", kumar[k].second}, resolution_of(false)));
}

void add_mangeney(CaseReport& report, const CaseRuns& runs) {
    const Estimate front = estimate(runs, "mangeney", [&](const std::string& run) {
        return runs.run(run).measures.front_mass_995_m - mangeney_length;
    });
    const Estimate contiguous = estimate(runs, "mangeney", [&](const std::string& run) {
        return runs.run(run).measures.front_by_top_m - mangeney_length;
    });
    report.entries.push_back(
        held(front, fmt::format("front past the gate, m, phi {:.1f}, a = 0.7", mangeney_friction_angle()),
             {"Mangeney et al. 2010", mangeney_front, 0.1}, resolution_of(false),
             fmt::format("contiguous front {:.3f}", contiguous.mean)));
}

/// Inclination of the plane on which the columns begin to slide, from the velocities.
void add_failure_plane(CaseReport& report, const CaseRuns& runs, double friction_angle, double aspect,
                       bool quick) {
    const Vec2 foot(length_of(aspect), 0.0);
    const Estimate angle = estimate(runs, name_of(friction_angle, aspect), [&](const std::string& run) {
        const std::vector<Snapshot> snapshots = runs.snapshots(run);
        return snapshots.empty() ? none : degrees(discontinuity_angle(snapshots.front(), foot));
    });
    report.entries.push_back(
        held(angle, fmt::format("initial failure plane, deg, phi {}, a = {}", friction_angle, aspect),
             {"45 + phi/2", 45.0 + 0.5 * friction_angle, 5.0}, resolution_of(quick)));
    report.entries.back().kind = DeviationKind::absolute;
}

void add_experiments(CaseReport& report, const CaseRuns& runs, const Spread& glass,
                     const std::string& folder) {
    const std::vector<Vec2> points = measured_run_outs(folder);
    add_lajeunesse(report, glass, points);
    add_heights(report, glass, folder);
    add_lajeunesse(
        report, spread_of(runs, beads_friction_angle, {beads_aspects.begin(), beads_aspects.end()}), points);
    add_kumar(report, runs);
    add_mangeney(report, runs);
}

CaseReport evaluate_run_out(const CaseRuns& runs, const std::string& folder, bool quick) {
    CaseReport report{
        "column-run-out", "Run-out of columns on a level bed (paper Fig. 8, eq. 10)", {}, {}, {}};
    std::vector<Spread> spreads;
    for (const double phi : friction_angles(quick)) {
        spreads.push_back(spread_of(runs, phi, aspects(quick)));
        if (phi == 37.0) add_lube(report, spreads.back(), quick);
        if (phi == 27.0) add_experiments(report, runs, spreads.back(), folder);
    }
    for (const double phi : friction_angles(quick))
        for (const double a : plane_aspects(quick)) add_failure_plane(report, runs, phi, a, quick);
    if (!quick) add_remarks(report, spreads, measured_run_outs(folder));
    add_figures(report, runs, spreads, folder);
    return report;
}

}  // namespace

std::vector<double> aspects(bool quick) {
    if (quick) return {0.5, 1, 1.5, 3};
    return {0.3, 0.5, 0.7, 1, 1.5, 2, 3, 5, 7, 10, 15, 20};
}

std::vector<double> friction_angles(bool quick) {
    if (quick) return {37};
    return {27, 37, 47};
}

std::vector<double> plane_aspects(bool quick) {
    if (quick) return {1.5};
    // The plane from the foot comes out on top of the one and at the wall of the other, whatever the
    // material.
    return {1.5, 3};
}

std::string resolution_of(bool quick) {
    return fmt::format("sqrt(S)/dl = {}", resolution(quick));
}

std::string name_of(double friction_angle, double aspect) {
    return fmt::format("phi{}-a{}", friction_angle, aspect);
}

double length_of(double aspect) {
    return root_area / std::sqrt(aspect);
}

Spread spread_of(const CaseRuns& runs, double friction_angle, const std::vector<double>& aspects) {
    Spread spread{friction_angle, aspects, {}, {}, {}};
    for (const double a : aspects) {
        const auto over_length = [&](double Measures::*value) {
            return estimate(runs, name_of(friction_angle, a), [&](const std::string& run) {
                return runs.run(run).measures.*value / length_of(a);
            });
        };
        spread.front.push_back(over_length(&Measures::front_mass_995_m));
        spread.contiguous.push_back(over_length(&Measures::front_by_top_m));
        spread.height.push_back(over_length(&Measures::deposit_height_m));
    }
    return spread;
}

std::vector<Vec2> eq10_points(const Spread& spread) {
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < spread.aspects.size(); ++k) {
        if (std::isnan(spread.front[k].mean)) continue;
        points.emplace_back(1.0 / std::sqrt(spread.aspects[k]),
                            spread.front[k].mean / std::sqrt(spread.aspects[k]));
    }
    const auto least = std::ranges::min_element(points, {}, [](const Vec2& p) { return p.y(); });
    points.erase(points.begin(), least);
    return points;
}

}  // namespace run_out_columns

ValidationCase column_run_out_case() {
    return {"column-run-out", run_out_columns::plan_run_out, run_out_columns::evaluate_run_out};
}

}  // namespace runout
