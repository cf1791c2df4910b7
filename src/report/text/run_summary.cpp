#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/printable.h"
#include "report/text/place_doubt.h"
#include "report/text/table.h"

namespace runout {
namespace {

// Below 20 particles along sqrt(S) the run-out of a column changes by more than 3 % on refinement.
constexpr double coarse_particles_along_root_area = 20;

std::string title(const StoredRun& run) {
    return printable(run.name.empty() ? run.section_origin : run.name);
}

std::string duration(double seconds) {
    if (seconds < 120) return fmt::format("{:.3g} s", seconds);
    return fmt::format("{:.0f} min {:.0f} s", std::floor(seconds / 60), std::fmod(std::floor(seconds), 60));
}

std::string front_line(const StoredRun& run) {
    const Measures& m = run.measures;
    if (!(m.run_out_m > 0)) return fmt::format("{}: the debris does not pass the toe.\n", title(run));
    return fmt::format(
        "{}: the front stops {:.4g} m past the toe, {:.3g} times the square root of the deposit's area.\n",
        title(run), m.run_out_m, m.run_out_normalised);
}

/// What counts as the front, and what lies or flew beyond it.
std::string definition_lines(const StoredRun& run) {
    const Measures& m = run.measures;
    if (run.front_definition != current_front_definition) return former_front_sentence() + "\n";
    std::string text = fmt::format(
        "The front is the farthest place where all soil is {:.3g} m thick in a window of +-{:.3g} m; "
        "distances "
        "are horizontal.\n",
        m.front_thickness_m, m.front_window_m);
    constexpr double worth_saying = 0.001;  // of the distance
    if (m.farthest_front_m > m.run_out_m * (1 + worth_saying))
        text += fmt::format("On the way it was {:.4g} m past the toe.\n", m.farthest_front_m);
    if (m.farthest_soil_m > m.farthest_front_m)
        text += fmt::format(
            "Thinner debris and single grains come {:.4g} m past the toe, at up to {:.3g} m/s; {:.3g} m2 lie "
            "beyond the front.\n",
            m.farthest_soil_m, m.beyond_front_speed_m_s, m.beyond_front_area_m2);
    return text;
}

/// Where the run-out counts from, and what speaks against it.
std::string face_lines(const StoredRun& run) {
    const auto origin = [](const std::string& word) { return word.empty() ? "" : ", " + word; };
    std::string text = fmt::format(
        "Toe at chainage {:.6g} m, elevation {:.5g} m{}; crest at {:.6g} m{}; face {:.4g} m high, {:.1f} "
        "deg.\n",
        run.toe_chainage_m, run.toe_elevation_m, origin(run.toe_origin), run.crest_chainage_m,
        origin(run.crest_origin), run.face_height_m, run.slope_angle_deg);
    for (const std::string& doubt : section_doubts(run)) text += "WARNING: " + doubt + "\n";
    return text;
}

std::string deposit_lines(const StoredRun& run) {
    const Measures& m = run.measures;
    std::string text;
    if (std::isfinite(m.reach_angle_deg)) text += fmt::format("Reach angle {:.1f} deg. ", m.reach_angle_deg);
    text += fmt::format("Deposit up to {:.3g} m thick, {:.3g} m at the toe.\n", m.deposit_height_m,
                        m.toe_thickness_m);
    text += fmt::format("Front speed up to {:.3g} m/s; at rest after {:.3g} s.\n", m.peak_front_speed_m_s,
                        m.time_to_rest_s);
    if (m.stray_particles > 0)
        text += fmt::format("{:.0f} stray particle{} apart from the deposit.\n", m.stray_particles,
                            m.stray_particles == 1 ? "" : "s");
    return text;
}

/// How sure the numbers are as numbers; and beside it how much nature scatters, so that nobody pays for
/// digits that mean nothing.
std::string error_lines(const StoredRun& run) {
    const Appraisal& a = run.appraisal;
    if (!std::isfinite(a.run_out_error_m))
        return fmt::format("Numerical error not known{}{}; `runout accuracy` tells it.\n",
                           a.error_note.empty() ? "" : ": ", a.error_note);
    const double root_area = std::sqrt(run.measures.source_area_m2);
    const double scale = std::max(run.measures.run_out_m, root_area);
    std::string text =
        fmt::format("Numerical error +-{:.2g} m ({:.1f} %{}) of the run-out", a.run_out_error_m,
                    100.0 * a.run_out_error_m / scale, scale > run.measures.run_out_m ? " of sqrt(S)" : "");
    if (std::isfinite(a.reach_angle_error_deg))
        text += fmt::format(", +-{:.1f} deg of the reach angle", a.reach_angle_error_deg);
    return text + fmt::format(" (95 %; {}: {}).\n", a.error_origin, a.error_note) +
           "Empirical relations of travel distance scatter by a factor of 1.4 either way.\n";
}

std::string source_line(const StoredRun& run) {
    const Measures& m = run.measures;
    return fmt::format("Source {}: {:.4g} m2, drop height {:.4g} m, S_front/S {:.3f}; friction {:.1f} deg.\n",
                       run.source_type, m.source_area_m2, m.drop_height_m, m.front_area_ratio,
                       run.friction_angle_deg);
}

std::string place_line(const StoredRun& run, const PlaceRecord& place) {
    std::string text =
        fmt::format("Place {}{} at chainage {:.5g} m", printable(place.name),
                    place.kind.empty() ? "" : fmt::format(" ({})", printable(place.kind)), place.chainage_m);
    if (place.width_m > 0) text += fmt::format(", {:.3g} m wide", place.width_m);
    const PlaceDoubt doubt = place_doubt(run, place);
    text += ": " + doubt.sentence();
    if (!doubt.reached) return text + ".\n";
    return text + fmt::format(
                      "{}after {:.3g} s, up to {:.3g} m thick, {:.3g} m/s, kinetic head {:.3g} m, momentum "
                      "flux {:.3g} kN/m; {:.4g} m2 pass, {:.3g} m lie at the end.\n",
                      doubt.within_error() ? "; " : " ", place.arrival_time_s, place.greatest_thickness_m,
                      place.greatest_speed_m_s, place.greatest_kinetic_head_m,
                      1e-3 * place.greatest_momentum_flux_n_m, place.passed_area_m2, place.final_thickness_m);
}

std::string barrier_lines(const BarrierRecord& barrier) {
    if (std::isnan(barrier.arrival_time_s)) return "Barrier: nothing arrives.\n";
    return fmt::format(
        "Barrier: force up to {:.3g} kN/m at {:.3g} s (alpha rho v^2 h of the approach, {:.3g} m/s and "
        "{:.3g} m: "
        "{:.3g} kN/m),\n  moment up to {:.3g} kNm/m, impulse {:.3g} kNs/m, {:.3g} kN/m at the end; run-up "
        "{:.3g} m, "
        "{:.3g} m2 beyond it.\n",
        1e-3 * barrier.greatest_force_n_m, barrier.greatest_force_time_s, barrier.approach_speed_m_s,
        barrier.approach_thickness_m, 1e-3 * barrier.design_force_n_m, 1e-3 * barrier.greatest_moment_n,
        1e-3 * barrier.impulse_n_s_m, 1e-3 * barrier.last_force_n_m, barrier.run_up_m,
        barrier.overtopped_area_m2);
}

/// "Effects on: cohesion, barrier (0.2 s). Off: rate, ..."
std::string effects_line(const StoredRun& run) {
    if (run.effects.empty()) return {};
    std::string on, off;
    for (const EffectRow& effect : run.effects) {
        std::string& list = effect.on ? on : off;
        list += (list.empty() ? "" : ", ") + printable(effect.name);
        if (effect.on && std::isfinite(effect.cost_s)) list += " (" + duration(effect.cost_s) + ")";
    }
    return fmt::format("Effects on: {}. Off: {}.\n", on.empty() ? "none" : on, off.empty() ? "none" : off);
}

std::string effect_lines(const StoredRun& run) {
    std::string text;
    for (const PlaceRecord& place : run.places) text += place_line(run, place);
    for (const BarrierRecord& barrier : run.barriers) text += barrier_lines(barrier);
    if (std::isfinite(run.measures.eroded_area_m2))
        text += fmt::format("{:.4g} m2 of the bed were carried along.\n", run.measures.eroded_area_m2);
    text += effects_line(run);
    for (const std::string& sentence : run.advice) text += "Advice: " + printable(sentence) + "\n";
    return text;
}

std::string work_line(const StoredRun& run) {
    const RunWork& w = run.work;
    const std::string spared =
        std::isfinite(w.spared_share)
            ? fmt::format("; {:.3g} % of the particle steps spared, at rest or in free flight",
                          100 * w.spared_share)
            : "";
    const double expected = run.appraisal.expected_cpu_s;
    return fmt::format("{} particles of {:.3g} m, {} steps, {} ({} of CPU time{}){}.\n", w.particles,
                       w.particle_spacing_m, w.steps, duration(w.wall_s), duration(w.cpu_s),
                       std::isfinite(expected) ? fmt::format(", {} expected", duration(expected)) : "",
                       spared);
}

std::string resolution_line(const StoredRun& run) {
    const std::string warning = resolution_warning(run);
    return warning.empty() ? warning : warning + "\n";
}

std::string failed_lines(const StoredRun& run) {
    const std::string detail = run.status_detail.empty() ? "" : " (" + printable(run.status_detail) + ")";
    return fmt::format("{}: no result: {}{}.\n", title(run), status_reason(run.status), detail) +
           work_line(run);
}

}  // namespace

std::vector<std::string> section_doubts(const StoredRun& run) {
    std::vector<std::string> doubts;
    std::istringstream text(run.section_doubts);
    for (std::string line; std::getline(text, line);) doubts.push_back(line);
    return doubts;
}

std::string former_front_sentence() {
    return "This front has the former definition: contiguous by top, along the bed (before database 10).";
}

std::string resolution_warning(const StoredRun& run) {
    const double along = std::sqrt(run.measures.source_area_m2) / run.work.particle_spacing_m;
    if (along < coarse_particles_along_root_area)
        return fmt::format(
            "Coarse: only {:.0f} particles along sqrt(S); a finer run may move the front by several per "
            "cent.",
            along);
    const Measures& m = run.measures;
    constexpr double kernel_peak = 0.9375;  // of a window, over its half-width
    const double grain = run.work.particle_spacing_m * run.work.particle_spacing_m;
    if (run.front_definition == current_front_definition &&
        kernel_peak * grain >= m.front_thickness_m * m.front_window_m)
        return fmt::format("Coarse: one particle alone is as thick as the front, {:.3g} m.",
                           m.front_thickness_m);
    return {};
}

std::string status_reason(RunStatus status) {
    switch (status) {
        case RunStatus::running:
            return "it has not ended";
        case RunStatus::time_limit:
            return "it was still moving at the time limit";
        case RunStatus::left_section:
            return "soil reached an end of the section";
        case RunStatus::not_converged:
            return "the pressure equation did not reach its tolerance";
        case RunStatus::diverged:
            return "an invariant of the physics was violated";
        case RunStatus::interrupted:
            return "it was stopped";
        case RunStatus::not_a_body:
            return "what came to rest is no body of soil";
        case RunStatus::settled:
        case RunStatus::stable:
            break;
    }
    return {};
}

std::string run_summary(const StoredRun& run) {
    if (!is_result(run.status)) return failed_lines(run);
    if (run.status == RunStatus::stable)
        return fmt::format("{}: the source stands at this strength: no run-out.\n", title(run)) +
               source_line(run) + effect_lines(run) + work_line(run);
    return front_line(run) + definition_lines(run) + face_lines(run) + deposit_lines(run) + error_lines(run) +
           source_line(run) + effect_lines(run) + work_line(run) + resolution_line(run);
}

std::string time_table(const std::vector<PhaseTime>& phases) {
    double whole = 0.0;
    for (const PhaseTime& phase : phases) whole += phase.wall_s;
    if (!(whole > 0.0)) return {};
    std::string text = fmt::format("{:<12}{:>9}{:>8}\n", "Time in", "s", "share");
    for (const PhaseTime& phase : phases) {
        text += fmt::format("{:<12}{:>9.3f}{:>6.0f} %\n", phase.phase, phase.wall_s,
                            100.0 * phase.wall_s / whole);
    }
    return text;
}

}  // namespace runout
