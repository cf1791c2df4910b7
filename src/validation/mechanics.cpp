#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "validation/data_file.h"
#include "validation/suite_cases.h"

namespace runout {
namespace {

constexpr double g = 9.81;

// --- silo ------------------------------------------------------------------------------------------------

std::vector<PlannedRun> plan_silo(bool) {
    std::vector<PlannedRun> plan;
    const Settings water = {{"material.friction_angle_deg", "0"},
                            {"run.snapshot_times_s", "[0, 0.1, 0.3]"},
                            {"run.time_limit_s", "0.31"}};
    plan_ensemble(plan, "frictionless", "silo/case.toml", water, "run.particle_spacing_m", 0.0025);
    plan_ensemble(plan, "soil", "silo/case.toml", {{"run.snapshot_times_s", "[0, 0.1, 0.3]"}},
                  "run.particle_spacing_m", 0.0025);
    return plan;
}

constexpr double silo_height = 0.1;

/// Root mean square of p - rho g (h - y) over all particles, in rho g h.
double pressure_misfit(const Snapshot& state) {
    const double scale = 2000 * g * silo_height;
    double sum = 0.0;
    for (std::size_t i = 0; i < state.x_m.size(); ++i) {
        const double exact = 2000 * g * (silo_height - state.y_m[i]);
        sum += std::pow((state.pressure_pa[i] - exact) / scale, 2);
    }
    return std::sqrt(sum / static_cast<double>(state.x_m.size()));
}

double greatest_move(const Snapshot& from, const Snapshot& to) {
    double greatest = 0.0;
    for (std::size_t i = 0; i < from.x_m.size(); ++i)
        greatest =
            std::max(greatest, std::hypot(double(to.x_m[i]) - from.x_m[i], double(to.y_m[i]) - from.y_m[i]));
    return greatest;
}

/// As estimate(), also of runs that end by their time limit.
Estimate over_lattices(const std::string& id, auto quantity) {
    std::vector<double> fine, coarse;
    for (const std::string& name : lattices_of(id)) fine.push_back(quantity(name));
    for (const std::string& name : coarse_lattices_of(id)) coarse.push_back(quantity(name));
    return estimate_of(fine, coarse);
}

CaseReport evaluate_silo(const CaseRuns& runs, const std::string&, bool) {
    CaseReport report{.name = "silo", .title = "Soil at rest between two walls"};
    const std::string resolution = "40 x 40 particles";
    auto pressure = entry_of(
        over_lattices("frictionless",
                      [&](const std::string& id) { return pressure_misfit(runs.snapshots(id).back()); }),
        "pressure at phi = 0 off rho g (h - z), rms, in rho g h", resolution);
    pressure.held_to = "exact";
    pressure.kind = DeviationKind::at_most;
    pressure.accepted = 0.02;
    report.entries.push_back(pressure);
    auto moved = entry_of(over_lattices("soil",
                                        [&](const std::string& id) {
                                            const auto states = runs.snapshots(id);
                                            return greatest_move(states.front(), states.back()) /
                                                   runs.run(id).work.particle_spacing_m;
                                        }),
                          "farthest that any particle moves in 0.3 s, in spacings", resolution);
    moved.held_to = "exact";
    moved.kind = DeviationKind::at_most;
    moved.accepted = 0.5;
    report.entries.push_back(moved);
    return report;
}

// --- similarity and energy -------------------------------------------------------------------------------

const Settings ten_times_as_long = {{"section.file", "../../profiles/wall-level-30m.csv"},
                                    {"source.points", "[[0, 0], [2, 0], [2, 2], [0, 2]]"}};
const Settings ten_times_as_heavy = {{"run.gravity_m_s2", "98.1"}};
const Settings sixteen_times_both = {{"section.file", "../../profiles/wall-level-48m.csv"},
                                     {"source.points", "[[0, 0], [3.2, 0], [3.2, 3.2], [0, 3.2]]"},
                                     {"run.gravity_m_s2", "156.96"}};

std::vector<PlannedRun> plan_similarity(bool) {
    const std::string file = "similarity/case.toml";
    std::vector<PlannedRun> plan;
    const auto add = [&](const std::string& id, Settings set) {
        set.emplace_back("run.resolution", "20");
        plan_lattices(plan, id, file, set);
    };
    add("model", {});
    add("large", ten_times_as_long);
    add("heavy", ten_times_as_heavy);
    add("sixteen", sixteen_times_both);
    plan_ensemble(plan, "energy", file, {}, "run.resolution", 50);
    return plan;
}

/// Greatest difference of two final thickness profiles at equal places, in sqrt(S).
double profile_difference(const CaseRuns& runs, const std::string& a, const std::string& b) {
    const auto first = runs.deposit(a);
    const auto second = runs.deposit(b);
    const double scale_a = std::sqrt(runs.run(a).measures.source_area_m2);
    const double scale_b = std::sqrt(runs.run(b).measures.source_area_m2);
    if (first.size() != second.size()) return std::numeric_limits<double>::infinity();
    double greatest = 0.0;
    for (std::size_t i = 0; i < first.size(); ++i)
        greatest = std::max(greatest, std::abs(first[i].thickness_by_mass_m / scale_a -
                                               second[i].thickness_by_mass_m / scale_b));
    return greatest;
}

// Other roundings send single particles elsewhere, as in every collapse of grains, but not the heap: a tenth
// of a spacing, well below what another lattice changes.
constexpr double rounding_band = 5e-3;

/// Greatest difference of the final profiles, on the mean of the lattices: one pair of runs is one draw of
/// what rounding does.
ValidationEntry similarity_entry(const CaseRuns& runs, const std::string& other, const std::string& what,
                                 double accepted) {
    const std::vector<std::string> model = lattices_of("model");
    const std::vector<std::string> scaled = lattices_of(other);
    std::vector<double> differences;
    for (std::size_t k = 0; k < model.size(); ++k)
        differences.push_back(profile_difference(runs, model[k], scaled[k]));
    auto entry = entry_of(mean_and_scatter(differences),
                          fmt::format("final profile with {}, greatest difference in sqrt(S)", what),
                          "sqrt(S)/dl = 20");
    entry.held_to = "exact";
    entry.kind = DeviationKind::at_most;
    entry.accepted = accepted;
    return entry;
}

/// Work of friction over the loss of mechanical energy, both since release.
double friction_share(const CaseRuns& runs, const std::string& id) {
    const auto series = runs.series(id);
    const auto mechanical = [](const SeriesRow& row) {
        return row.kinetic_energy_j_m + row.potential_energy_j_m;
    };
    return series.back().plastic_work_j_m / (mechanical(series.front()) - mechanical(series.back()));
}

CaseReport evaluate_similarity(const CaseRuns& runs, const std::string&, bool) {
    CaseReport report{.name = "similarity", .title = "Similarity and energy of a collapsing column"};
    // A power of two changes no rounding, so nothing at all may differ.
    report.entries.push_back(similarity_entry(runs, "sixteen", "length and gravity times 16", 0.0));
    report.entries.push_back(similarity_entry(runs, "large", "length times 10", rounding_band));
    report.entries.push_back(similarity_entry(runs, "heavy", "gravity times 10", rounding_band));
    auto energy =
        entry_of(estimate(runs, "energy", [&](const std::string& id) { return friction_share(runs, id); }),
                 "work of friction over loss of mechanical energy", "sqrt(S)/dl = 50");
    energy.held_to = "exact";
    energy.reference = 1.0;
    energy.accepted = 0.03;
    energy.remark =
        "The rest is the work of the pressure field, which is zero for a velocity free of divergence and is "
        "the error of the projection here.";
    report.entries.push_back(energy);
    return report;
}

// --- dam break -------------------------------------------------------------------------------------------

constexpr double dam_width = 0.1;

std::vector<PlannedRun> plan_dam_break(bool quick) {
    std::vector<PlannedRun> plan;
    std::string times;
    for (int k = 1; k <= 20; ++k) times += fmt::format("{}{:.3f}", k == 1 ? "" : ", ", 0.011 * k);
    plan_ensemble(plan, "square", "dam-break/case.toml", {{"run.snapshot_times_s", "[" + times + "]"}},
                  "run.resolution", quick ? 20 : 40);
    return plan;
}

/// Foremost soil that is part of a front three rows of particles wide, over the width of the column, against
/// t sqrt(g/W).
std::vector<Vec2> surge(const CaseRuns& runs, const std::string& id) {
    const double spacing = runs.run(id).work.particle_spacing_m;
    std::vector<Vec2> points;
    for (const Snapshot& state : runs.snapshots(id)) {
        std::vector<float> x = state.x_m;
        const std::size_t third = x.size() - 3;
        std::nth_element(x.begin(), x.begin() + static_cast<long>(third), x.end());
        points.emplace_back(state.time_s * std::sqrt(g / dam_width), (x[third] + 0.5 * spacing) / dam_width);
    }
    return points;
}

/// Speed of the front between x = 2 W and 3 W, in sqrt(g W): free of how a gate was lifted.
double surge_speed(const std::vector<Vec2>& points) {
    return 1.0 / (crossing(points, 3.0) - crossing(points, 2.0));
}

CaseReport evaluate_dam_break(const CaseRuns& runs, const std::string& folder, bool quick) {
    CaseReport report{.name = "dam-break", .title = "Dam break: a column without friction"};
    const std::vector<Vec2> measured = read_points(folder + "/martin_moyce1952_surge.csv");
    std::vector<double> fine, coarse;
    for (const std::string& id : lattices_of("square")) fine.push_back(surge_speed(surge(runs, id)));
    for (const std::string& id : coarse_lattices_of("square")) coarse.push_back(surge_speed(surge(runs, id)));
    auto speed = entry_of(estimate_of(fine, coarse), "speed of the front from x = 2 W to 3 W, in sqrt(g W)",
                          fmt::format("sqrt(S)/dl = {}", quick ? 20 : 40));
    speed.held_to = "Martin and Moyce 1952";
    speed.reference = surge_speed(measured);
    speed.accepted = 0.15;
    speed.remark =
        "The experiment was slowed by its bed and gate; ideal fluid of depth H never exceeds 2 sqrt(g H).";
    report.entries.push_back(speed);
    auto bound = speed;
    bound.quantity = "the same over Ritter's limit 2 sqrt(g H)";
    bound.held_to = "exact bound";
    bound.reference = ValidationEntry::none;
    bound.computed /= 2.0;
    bound.scatter /= 2.0;
    bound.error /= 2.0;
    bound.kind = DeviationKind::at_most;
    bound.accepted = 1.0;
    bound.remark.clear();
    report.entries.push_back(bound);
    report.figures.push_back(
        {.name = "surge",
         .title = "Front of the dam break",
         .x_label = "t sqrt(g/W)",
         .y_label = "x/W",
         .curves = {{"computed", Curve::Style::line, surge(runs, lattices_of("square").front())},
                    {"Martin and Moyce 1952", Curve::Style::markers, measured}}});
    return report;
}

}  // namespace

ValidationCase silo_case() {
    return {"silo", plan_silo, evaluate_silo};
}

ValidationCase similarity_case() {
    return {"similarity", plan_similarity, evaluate_similarity};
}

ValidationCase dam_break_case() {
    return {"dam-break", plan_dam_break, evaluate_dam_break};
}

}  // namespace runout
