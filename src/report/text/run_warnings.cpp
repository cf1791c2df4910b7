#include <fmt/format.h>

#include <cmath>

#include "report/page/html.h"
#include "report/page/run_page_parts.h"
#include "report/text/table.h"

namespace runout {
namespace {

// theta_id = 55 deg was found at phi = 38 deg (the paper); it moves with phi, as 45 deg + phi/2 does.
constexpr double plane_angle_deg = 55, plane_friction_deg = 38, plane_band_deg = 2;
constexpr double sound_density = 1.1;

void add_front_plane(std::vector<std::string>& warnings, const StoredRun& run) {
    if (std::abs(run.discontinuity_angle_deg - plane_angle_deg) > 0.01) return;  // chosen for this soil
    if (std::abs(run.friction_angle_deg - plane_friction_deg) <= plane_band_deg) return;
    warnings.push_back(
        fmt::format("S_front stands above a plane of {:g} deg, which was found for a friction angle of {:g} "
                    "deg; this run has {:.4g} "
                    "deg. Give source.discontinuity_angle_deg if you rely on S_front.",
                    plane_angle_deg, plane_friction_deg, run.friction_angle_deg));
}

void add_soundness(std::vector<std::string>& warnings, const StoredRun& run) {
    if (run.work.highest_density_ratio > sound_density)
        warnings.push_back(fmt::format("At some instant soil was {:.3g} times as dense as at the start.",
                                       run.work.highest_density_ratio));
    if (run.work.bed_guard_activations > 0)
        warnings.push_back(
            fmt::format("Particles had to be put back onto the bed {} times in {} steps of {} particles.",
                        run.work.bed_guard_activations, run.work.steps, run.work.particles));
    if (run.measures.stray_particles > 0 && is_result(run.status))
        warnings.push_back(
            fmt::format("{:.0f} particles lie apart from the deposit.", run.measures.stray_particles));
}

}  // namespace

std::vector<std::string> run_warnings(const RunData& run) {
    std::vector<std::string> warnings;
    if (!is_result(run.run.status))
        warnings.push_back(fmt::format("This run ended as {}: {}{}{}. Its numbers are not a result.",
                                       to_string(run.run.status), status_reason(run.run.status),
                                       run.run.status_detail.empty() ? "" : "; ", run.run.status_detail));
    for (const std::string& doubt : section_doubts(run.run)) warnings.push_back(doubt);
    if (run.run.front_definition != current_front_definition) warnings.push_back(former_front_sentence());
    const std::string coarse = resolution_warning(run.run);
    if (is_result(run.run.status) && !coarse.empty()) warnings.push_back(coarse);
    add_front_plane(warnings, run.run);
    add_soundness(warnings, run.run);
    const StoredValue scheme = fact_of(run, "scenario", "friction_scheme");
    if (scheme == StoredValue(std::string("explicit")))
        warnings.emplace_back(
            "Friction was explicit, as the paper printed it: heaps creep, and deposits come out too flat.");
    if (const StoredTable* advice = further_table(run, "advice"); advice != nullptr)
        for (const auto& row : advice->rows)
            warnings.push_back(stored_text(cell_of(*advice, row, "sentence")));
    return warnings;
}

std::vector<std::string> validity_envelope() {
    return {
        "Plane strain: one metre of a slide that is infinitely wide. A real mass spreads sideways or is led "
        "by a channel.",
        "Dry Coulomb soil at critical state, unless an effect above says otherwise. A wet failure needs a "
        "strength that "
        "stands for its water, and the choice of it dominates the result.",
        "Incompressible: the mass neither dilates nor bulks. Experiments swell by about a tenth.",
        "The source is given, not found: this is no stability analysis.",
        "S_front above a plane of 55 deg holds near a friction angle of 38 deg.",
        "The front is the least certain number: it is read off a thin edge. The scatter of real landslides "
        "is far "
        "greater than any numerical error here.",
        "An aid to judgement, not a prediction.",
    };
}

PageSection warnings_section(const RunData& run) {
    const std::vector<std::string> warnings = run_warnings(run);
    std::string body;
    if (!warnings.empty())
        body += "<div class=\"warnings\" role=\"note\">\n" + bullet_list(warnings) + "</div>\n";
    body += "<h3>What this can be used for</h3>\n" + bullet_list(validity_envelope());
    return {"validity", "Warnings and range of validity", body, {}, {}};
}

}  // namespace runout
