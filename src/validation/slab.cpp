#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "validation/suite_cases.h"

namespace runout {
namespace {

constexpr double g = 9.81;

constexpr double slab_spacing = 0.005;
constexpr int slab_columns = 300;
constexpr double slab_friction_deg = 38.0;
constexpr const char* slab_instants = "[0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08, 0.09]";

struct Slab {
    int slope_deg;
    int rows;
    double base_friction_deg;  ///< 0: rough
};

std::vector<Slab> slabs(bool quick) {
    std::vector<Slab> all;
    for (const int slope : {45, 60, 70}) {
        for (const int rows : {1, 2, 3, 5, 10}) {
            if (!quick || slope != 60) all.push_back({slope, rows, 0});
        }
    }
    all.push_back({45, 10, 20});
    if (!quick) all.push_back({60, 10, 30});
    return all;
}

std::string name_of(const Slab& slab) {
    return slab.base_friction_deg > 0 ? fmt::format("base{}-{}deg", slab.base_friction_deg, slab.slope_deg)
                                      : fmt::format("{}thick-{}deg", slab.rows, slab.slope_deg);
}

std::vector<PlannedRun> plan_slabs(bool quick) {
    std::vector<PlannedRun> plan;
    for (const Slab& slab : slabs(quick)) {
        const double head = 3.3 * std::sin(radians(slab.slope_deg));  // a quarter of the plane above it
        Settings set = {{"section.file", fmt::format("../../profiles/plane-{}.csv", slab.slope_deg)},
                        {"source.thickness_m", fmt::format("{}", slab.rows * slab_spacing)},
                        {"source.drop_height_m", fmt::format("{}", head)},
                        {"run.snapshot_times_s", slab_instants}};
        if (slab.base_friction_deg > 0)
            set.emplace_back("effects.base_friction.angle_deg", fmt::format("{}", slab.base_friction_deg));
        for (int seed = 1; seed <= 4; ++seed) {
            plan.push_back({lattices_of(name_of(slab))[seed - 1], "slab/case.toml", set});
            plan.back().set.emplace_back("run.lattice_seed", std::to_string(seed));
        }
    }
    return plan;
}

/// Mean acceleration since release of the middle fifth, m/s2; particles were packed column by column.
double slab_acceleration(const Snapshot& state, const Slab& slab) {
    const double slope = radians(slab.slope_deg);
    double sum = 0.0;
    const int first = 2 * slab_columns / 5 * slab.rows;
    const int last = 3 * slab_columns / 5 * slab.rows;
    for (int i = first; i < last; ++i)
        sum += state.vx_m_s[i] * std::cos(slope) - state.vy_m_s[i] * std::sin(slope);
    return sum / (last - first) / state.time_s;
}

double exact_slab_acceleration(const Slab& slab) {
    const double slope = radians(slab.slope_deg);
    const double own = std::sin(radians(slab_friction_deg));
    const double strength =
        slab.base_friction_deg > 0 ? std::min(own, std::tan(radians(slab.base_friction_deg))) : own;
    return g * (std::sin(slope) - strength * std::cos(slope));
}

ValidationEntry slab_entry(const CaseRuns& runs, const Slab& slab) {
    const double exact = exact_slab_acceleration(slab);
    ValidationEntry entry;
    entry.quantity = slab.base_friction_deg > 0
                         ? fmt::format("acceleration, {} deg, base friction {} deg, m/s2", slab.slope_deg,
                                       slab.base_friction_deg)
                         : fmt::format("acceleration, {} deg, {} thick, m/s2", slab.slope_deg, slab.rows);
    entry.held_to = "exact";
    entry.reference = exact;
    entry.accepted = slab.base_friction_deg > 0 ? 0.03 : slab.rows >= 5 ? 0.01 : 0.02;
    entry.computed = exact;
    entry.scatter = 0.0;
    std::vector<std::vector<Snapshot>> lattices;
    for (const std::string& id : lattices_of(name_of(slab))) lattices.push_back(runs.snapshots(id));
    for (std::size_t instant = 0; instant < lattices.front().size(); ++instant) {
        std::vector<double> found;
        for (const auto& states : lattices) found.push_back(slab_acceleration(states.at(instant), slab));
        const Estimate estimate = estimate_of(found, found);
        if (std::abs(estimate.mean - exact) < std::abs(entry.computed - exact)) continue;
        entry.computed = estimate.mean;
        entry.scatter = estimate.scatter;
    }
    entry.resolution = fmt::format("{} x {} particles", slab.rows, slab_columns);
    return entry;
}

CaseReport evaluate_slabs(const CaseRuns& runs, const std::string&, bool quick) {
    CaseReport report{.name = "slab", .title = "Slab on a rough plane, and on a base of less friction"};
    for (const Slab& slab : slabs(quick)) report.entries.push_back(slab_entry(runs, slab));
    report.remarks.emplace_back(
        "Each acceleration is speed over time since release, the mean over four jittered lattices, at that "
        "of nine "
        "instants from 0.01 to 0.09 s where it is furthest from the exact value.");
    return report;
}

}  // namespace

ValidationCase slab_case() {
    return {"slab", plan_slabs, evaluate_slabs};
}

}  // namespace runout
