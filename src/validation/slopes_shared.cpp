#include "validation/slopes_shared.h"

#include <fmt/format.h>

#include <cmath>

#include "core/units.h"
#include "validation/profile_misfit.h"

namespace runout::slopes {

Estimate exact(double value) {
    return {value, ValidationEntry::none, ValidationEntry::none};
}

Estimate measured(const CaseRuns& runs, const std::string& id, double Measures::*value, double unit) {
    return estimate(runs, id, [&](const std::string& run) { return runs.run(run).measures.*value / unit; });
}

Estimate contiguous_run_out(const CaseRuns& runs, const std::string& id) {
    return estimate(runs, id, [&](const std::string& run) {
        const Measures m = runs.run(run).measures;
        return m.front_by_top_m / std::sqrt(m.deposit_area_m2);
    });
}

Estimate run_out(const CaseRuns& runs, const std::string& id) {
    return estimate(runs, id, [&](const std::string& run) {
        return front_of(runs, run) / std::sqrt(runs.run(run).measures.source_area_m2);
    });
}

double front_of(const CaseRuns& runs, const std::string& run) {
    return runs.run(run).measures.front_mass_995_m;
}

std::vector<Vec2> normalised_surface(const CaseRuns& runs, const std::string& run, double toe_chainage) {
    std::vector<Vec2> surface = deposit_surface(runs.deposit(run));
    const double unit = std::sqrt(runs.run(run).measures.source_area_m2);
    for (Vec2& p : surface) p = (p - Vec2(toe_chainage, 0.0)) / unit;
    return surface;
}

Curve surface_curve(const CaseRuns& runs, const std::string& run, double toe_chainage,
                    const std::string& label, Curve::Style style) {
    Curve curve{label, style, normalised_surface(runs, run, toe_chainage)};
    const StoredRun stored = runs.run(run);
    if (!curve.points.empty()) {
        const double half_bin = stored.work.particle_spacing_m / std::sqrt(stored.measures.source_area_m2);
        curve.points.emplace_back(curve.points.back().x() + half_bin, 0.0);
    }
    return curve;
}

Curve ground_curve(double slope_deg, double height, double length) {
    return {"ground",
            Curve::Style::dashed,
            {{-height / std::tan(radians(slope_deg)), height}, {0.0, 0.0}, {length, 0.0}}};
}

double chute_toe(double slope_deg) {
    return 0.5 + 1.2 / std::tan(radians(slope_deg));
}

std::string chute_file(double slope_deg) {
    return fmt::format("../../profiles/chute-{:.0f}.csv", slope_deg);
}

std::string text_of(double value) {
    return fmt::format("{:.10g}", value);
}

}  // namespace runout::slopes
