#include <fmt/format.h>

#include <cmath>

#include "core/units.h"
#include "validation/suite_cases.h"

namespace runout {
namespace {

constexpr double spacing = 0.01;
constexpr double layer_width = 0.15;

/// One series of Fig. 6: soil and thickness of the poured layers.
struct Pouring {
    double friction_deg;
    int layer_rows;
};

std::vector<Pouring> pourings(bool quick) {
    if (quick) return {{36.5, 5}};
    return {{27, 1}, {36.5, 1}, {40, 1}, {47, 1}, {36.5, 5}, {36.5, 10}, {36.5, 15}};
}

std::string name_of(const Pouring& p) {
    return fmt::format("phi{}-layer{}", p.friction_deg, p.layer_rows);
}

/// Poured after the first column of 0.06 m2. Thin layers bring the heap to its slope with less, and cost
/// most.
double poured_area(const Pouring& p) {
    return p.layer_rows == 1 ? 0.045 : 0.09;
}

double repose_deg(const Pouring& p) {
    return degrees(std::atan(std::sin(radians(p.friction_deg))));
}

std::vector<PlannedRun> plan(bool quick) {
    std::vector<PlannedRun> runs;
    for (const Pouring& p : pourings(quick)) {
        const double height = p.layer_rows * spacing;
        const int layers = static_cast<int>(std::lround(poured_area(p) / (layer_width * height)));
        for (int seed = 1; seed <= 4; ++seed) {
            runs.push_back({lattices_of(name_of(p))[seed - 1],
                            "poured-heap/case.toml",
                            {{"material.friction_angle_deg", fmt::format("{}", p.friction_deg)},
                             {"effects.release.layers", std::to_string(layers)},
                             {"effects.release.layer_height_m", fmt::format("{}", height)},
                             {"run.lattice_seed", std::to_string(seed)}}});
        }
    }
    return runs;
}

/// Mean slope of the surface over the last quarter of the releases, deg: avalanches make it rise and fall.
double asymptotic_angle(const std::vector<StageRow>& stages) {
    const std::size_t first = stages.size() - stages.size() / 4;
    double sum = 0.0;
    for (std::size_t i = first; i < stages.size(); ++i) sum += stages[i].surface_angle_deg;
    return sum / static_cast<double>(stages.size() - first);
}

Estimate over_lattices(const CaseRuns& runs, const Pouring& p,
                       double (*quantity)(const std::vector<StageRow>&)) {
    const auto names = lattices_of(name_of(p));
    if (!all_are_results(runs, names)) return {};
    std::vector<double> values;
    for (const std::string& id : names) values.push_back(quantity(runs.stages(id)));
    return estimate_of(values, values);
}

ValidationEntry angle_entry(const CaseRuns& runs, const Pouring& p) {
    auto entry = entry_of(
        over_lattices(runs, p, asymptotic_angle),
        fmt::format("slope of the heap, phi {} deg, layers of {} dl, deg", p.friction_deg, p.layer_rows),
        "dl = 10 mm");
    entry.held_to = "atan(sin phi)";
    entry.reference = repose_deg(p);
    entry.kind = DeviationKind::absolute;
    if (p.layer_rows <= 5) entry.accepted = p.layer_rows == 1 ? 1.0 : 2.0;
    return entry;
}

double first_angle(const std::vector<StageRow>& stages) {
    return stages.front().surface_angle_deg;
}

ValidationEntry first_column_entry(const CaseRuns& runs, const Pouring& p) {
    auto entry =
        entry_of(over_lattices(runs, p, first_angle),
                 fmt::format("slope after the first column, phi {} deg, deg", p.friction_deg), "dl = 10 mm");
    entry.held_to = "the paper, read from its text";
    entry.reference = 21.0;
    entry.kind = DeviationKind::absolute;
    entry.accepted = 3.0;
    return entry;
}

Figure slope_figure(const CaseRuns& runs, bool quick) {
    Figure figure{.name = "slope",
                  .title = "Slope of a poured heap at rest after each release",
                  .x_label = "area of the heap, m2",
                  .y_label = "slope of its surface, deg"};
    for (const Pouring& p : pourings(quick)) {
        Curve curve{fmt::format("phi {} deg, layers of {} dl", p.friction_deg, p.layer_rows),
                    p.layer_rows == 1 ? Curve::Style::line : Curve::Style::markers,
                    {}};
        for (const StageRow& stage : runs.stages(lattices_of(name_of(p)).front()))
            curve.points.emplace_back(stage.area_m2, stage.surface_angle_deg);
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

CaseReport evaluate(const CaseRuns& runs, const std::string&, bool quick) {
    CaseReport report{.name = "poured-heap",
                      .title = "Angle of repose of a poured heap (Figs 5 and 6, table 1)"};
    for (const Pouring& p : pourings(quick)) report.entries.push_back(angle_entry(runs, p));
    for (const Pouring& p : pourings(quick))
        if (p.friction_deg == 36.5 && p.layer_rows == 5)
            report.entries.push_back(first_column_entry(runs, p));
    report.figures.push_back(slope_figure(runs, quick));
    report.remarks.emplace_back(
        "Angles are means over the last quarter of the releases and over four jittered lattices; the layers "
        "are "
        "thinner than anything a coarser spacing could pour, so the error bar is the scatter alone.");
    return report;
}

}  // namespace

ValidationCase poured_heap_case() {
    return {"poured-heap", plan, evaluate};
}

}  // namespace runout
