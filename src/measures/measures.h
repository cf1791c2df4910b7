#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/status.h"

namespace runout {

/// What run-out, reach angle and front of a run rest on (docs/front.md); a run of before database 10 has
/// "top".
constexpr const char* current_front_definition = "thickness";

/// What is said of a finished run. Names carry their units and are the same here, in the database and in
/// JSON. NaN where a measure does not exist (a reach angle of a source that stands), stored as NULL.
struct Measures {
    double run_out_m = 0;                ///< L_inf: front of the deposit at rest, horizontal, from the toe
    double run_out_normalised = 0;       ///< L_inf / sqrt(S_inf)
    double run_out_along_bed_m = 0;      ///< the same front, along the bed from the toe
    double farthest_front_m = 0;         ///< farthest front at any instant, horizontal, from the toe
    double front_thickness_m = 0;        ///< threshold of the front
    double front_window_m = 0;           ///< half-width of the window that the thickness is taken in
    double front_by_top_m = 0;           ///< contiguous front by top, horizontal, from the toe
    double front_by_mass_m = 0;          ///< the same front read off the thickness by mass
    double front_mass_995_m = 0;         ///< distance from the toe that 99.5 % of the mass does not pass
    double reach_angle_deg = 0;          ///< from the head of the source to the distal margin
    double source_area_m2 = 0;           ///< S_0
    double deposit_area_m2 = 0;          ///< S_inf
    double front_area_m2 = 0;            ///< S_front
    double front_area_ratio = 0;         ///< S_front / S_0
    double drop_height_m = 0;            ///< H_d to its datum
    double drop_height_normalised = 0;   ///< H_d / sqrt(S_inf)
    double deposit_height_m = 0;         ///< greatest thickness by top
    double toe_thickness_m = 0;          ///< thickness by top at the toe of the cut
    double peak_front_speed_m_s = 0;     ///< greatest speed of the soil in the window at the front
    double peak_mass_995_speed_m_s = 0;  ///< greatest speed of the 99.5 % mass point
    double time_to_rest_s = 0;           ///< simulated time at which motion ended
    double stray_particles = 0;          ///< particles not connected to the deposit
    double farthest_soil_m = 0;          ///< farthest single grain at any instant, horizontal, from the toe
    double beyond_front_area_m2 = 0;     ///< soil at rest beyond the front, thinner than the threshold
    double beyond_front_speed_m_s = 0;   ///< greatest speed of a grain beyond the front of its instant
    double eroded_area_m2 = 0;           ///< soil of an erodible bed that has moved; NaN: the bed is rigid
};

/// One column of Measures: drives the database, JSON and text alike.
struct MeasureField {
    const char* name;
    double Measures::*value;
    const char* meaning;  ///< one line, for people
};
std::span<const MeasureField> measure_fields();

/// State of the whole mass at one instant. Energies per metre of width.
struct SeriesRow {
    double time_s = 0;
    double front_m = 0;           ///< front, horizontal, from the toe; NaN: nothing is that thick
    double front_mass_995_m = 0;  ///< 99.5 % mass point, horizontal, from the toe
    double kinetic_energy_j_m = 0;
    double potential_energy_j_m = 0;  ///< above the toe
    double plastic_work_j_m = 0;      ///< dissipated by friction since release
    double mass_kg_m = 0;
};

/// One bin of the deposit, chainage and elevation as in the section file.
struct DepositRow {
    double chainage_m = 0;
    double bed_elevation_m = 0;
    double thickness_by_mass_m = 0;
    double thickness_by_top_m = 0;
};

/// Particles at one instant, local frame; one value per particle, in the order they were packed.
struct Snapshot {
    double time_s = 0;
    std::vector<float> x_m, y_m;
    std::vector<float> vx_m_s, vy_m_s;
    std::vector<float> pressure_pa;
};

/// How the numbers of a frame are coded: value = low + code * step.
struct FrameScale {
    double time_s = 0;
    double x_low_m = 0, x_step_m = 0;
    double y_low_m = 0, y_step_m = 0;
    double speed_low_m_s = 0, speed_step_m_s = 0;
    double pressure_low_pa = 0, pressure_step_pa = 0;
};

/// A picture of the moving mass, local frame: six bytes a particle, enough to look at and not to compute
/// with. One value per shown particle, the same ones in every frame, in the order they were packed.
struct Frame {
    FrameScale scale;
    std::vector<std::uint16_t> x, y;
    std::vector<std::uint8_t> speed, pressure;
};

/// The heap at rest after one release of a staged run; the first row is the source alone.
struct StageRow {
    double time_s = 0;
    double area_m2 = 0;            ///< released so far
    double surface_angle_deg = 0;  ///< of the free surface in the middle part of the deposit
    double deposit_height_m = 0;   ///< greatest thickness by top
    double run_out_m = 0;          ///< as Measures::run_out_m
};

/// What a place reads at one instant.
struct PlaceRow {
    double time_s = 0;
    double thickness_m = 0;     ///< soil area per width
    double speed_m_s = 0;       ///< mean over depth; negative away from the run-out
    double kinetic_head_m = 0;  ///< speed^2 / 2g
    double passed_area_m2 = 0;  ///< soil that has passed since release, net
};

/// What passed one place.
struct PlaceRecord {
    std::string name;
    std::string kind;
    double chainage_m = 0;      ///< of its near edge
    double width_m = 0;         ///< from there away from the cut
    double arrival_time_s = 0;  ///< first instant at which the front is at or beyond it; NaN: not reached
    double greatest_thickness_m = 0;
    double greatest_speed_m_s = 0;
    double greatest_kinetic_head_m = 0;
    double greatest_momentum_flux_n_m = 0;  ///< rho v^2 h
    double final_thickness_m = 0;           ///< at the near edge, as all of rows
    double passed_area_m2 = 0;              ///< at the end
    std::vector<PlaceRow> rows;
};

/// What passed along the section, at equal steps of horizontal distance from the toe, towards the run-out.
/// One value each; speeds, heads and fluxes are of soil as thick as the front.
struct Envelope {
    double first_m = 0, step_m = 0;
    std::vector<double> greatest_thickness_m;
    std::vector<double> greatest_speed_m_s;  ///< averaged over depth and window
    std::vector<double> greatest_kinetic_head_m;
    std::vector<double> greatest_momentum_flux_n_m;  ///< rho v^2 h, per metre of width
    std::vector<double> arrival_time_s;              ///< of the front; NaN: not reached
    std::vector<double> final_thickness_m;
    std::vector<double> passed_area_m2;  ///< soil that has passed since release, net
};

/// Load of a barrier over the last stored interval, per metre of width; x towards the run-out.
struct BarrierRow {
    double time_s = 0;
    double force_x_n_m = 0, force_y_n_m = 0;  ///< mean over the interval
    double moment_n = 0;                      ///< about the foot of its face, at the instant
    double impulse_x_n_s_m = 0;               ///< since release
};

/// What the debris did to a barrier.
struct BarrierRecord {
    double arrival_time_s = 0;  ///< NaN: nothing arrived
    double greatest_force_n_m = 0;
    double greatest_force_time_s = 0;
    double greatest_moment_n = 0;
    double impulse_n_s_m = 0;
    double last_force_n_m = 0;  ///< when the run ended: the static load of a deposit at rest
    double run_up_m = 0;        ///< above the foot
    double overtopped_area_m2 = 0;
    double approach_speed_m_s = 0, approach_thickness_m = 0;
    double design_force_n_m = 0;  ///< alpha rho v^2 h of the approach
    std::vector<BarrierRow> rows;
};

/// One effect in one run.
struct EffectRow {
    std::string name;
    bool on = false;
    std::string why;
    double cost_s = 0;  ///< wall seconds of work of its own; NaN: none apart from the rest of the step
};

/// What the run took and how sound it was. Counts are exact and reproducible; seconds are not.
struct RunWork {
    long particles = 0;
    long boundary_particles = 0;
    double particle_spacing_m = 0;  ///< effective: particles * spacing^2 = source area
    long steps = 0;
    long pressure_iterations = 0;  ///< CG iterations, all steps
    long bed_guard_activations = 0;
    double highest_density_ratio = 0;  ///< densest particle at any instant / rho_0
    double simulated_s = 0;
    double wall_s = 0;
    double cpu_s = 0;
    int threads = 1;
    double peak_memory_mb = 0;  ///< resident memory of the program at its greatest, MB; 0: not known
    double spared_share = 0;    ///< of the particle steps: at rest or in free flight
};

/// Seconds spent in one phase of the step.
struct PhaseTime {
    std::string phase;
    double wall_s = 0;
};

/// How near the run came to violating one of the invariants of the engine (engine/watch/invariants.h).
struct InvariantRow {
    std::string invariant;
    double worst = 0;  ///< pure number; the run ends as `diverged` when it exceeds the limit
    double limit = 0;
    double time_s = 0;  ///< of the worst
    double x_m = 0;     ///< local frame
};

/// Everything that is stored of a run.
struct RunResult {
    RunStatus status = RunStatus::running;
    std::string status_detail;  ///< one sentence when the run did not settle
    Measures measures;
    RunWork work;
    std::vector<SeriesRow> series;
    std::vector<DepositRow> deposit;
    std::vector<PhaseTime> phases;
    std::vector<InvariantRow> invariants;
    std::vector<Snapshot> snapshots;
    std::vector<Frame> frames;     ///< empty unless asked for in RunControl
    std::vector<StageRow> stages;  ///< empty unless the release is staged
    std::vector<PlaceRecord> places;
    Envelope envelope;
    std::vector<BarrierRecord> barriers;  ///< one, or none
    std::vector<EffectRow> effects;       ///< all that the program knows
    std::vector<std::string> advice;      ///< sentences: effects that were off and may matter
};

}  // namespace runout
