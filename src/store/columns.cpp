#include "store/columns.h"

#include <array>

namespace runout {
namespace {

constexpr std::array work = {
    WorkColumn{"particles", &RunWork::particles},
    WorkColumn{"boundary_particles", &RunWork::boundary_particles},
    WorkColumn{"particle_spacing_m", &RunWork::particle_spacing_m},
    WorkColumn{"steps", &RunWork::steps},
    WorkColumn{"pressure_iterations", &RunWork::pressure_iterations},
    WorkColumn{"wall_guard_activations", &RunWork::bed_guard_activations},
    WorkColumn{"highest_density_ratio", &RunWork::highest_density_ratio},
    WorkColumn{"simulated_s", &RunWork::simulated_s},
    WorkColumn{"wall_s", &RunWork::wall_s},
    WorkColumn{"cpu_s", &RunWork::cpu_s},
    WorkColumn{"threads", &RunWork::threads},
    WorkColumn{"peak_memory_mb", &RunWork::peak_memory_mb},
    WorkColumn{"spared_share", &RunWork::spared_share},
};

constexpr std::array series = {
    RealColumn<SeriesRow>{"time_s", &SeriesRow::time_s},
    RealColumn<SeriesRow>{"front_mass_995_m", &SeriesRow::front_mass_995_m},
    RealColumn<SeriesRow>{"kinetic_energy_j_m", &SeriesRow::kinetic_energy_j_m},
    RealColumn<SeriesRow>{"potential_energy_j_m", &SeriesRow::potential_energy_j_m},
    RealColumn<SeriesRow>{"plastic_work_j_m", &SeriesRow::plastic_work_j_m},
    RealColumn<SeriesRow>{"mass_kg_m", &SeriesRow::mass_kg_m},
    RealColumn<SeriesRow>{"front_m", &SeriesRow::front_m},
};

constexpr std::array deposit = {
    RealColumn<DepositRow>{"chainage_m", &DepositRow::chainage_m},
    RealColumn<DepositRow>{"bed_elevation_m", &DepositRow::bed_elevation_m},
    RealColumn<DepositRow>{"thickness_by_mass_m", &DepositRow::thickness_by_mass_m},
    RealColumn<DepositRow>{"thickness_by_top_m", &DepositRow::thickness_by_top_m},
};

constexpr std::array stage = {
    RealColumn<StageRow>{"time_s", &StageRow::time_s},
    RealColumn<StageRow>{"area_m2", &StageRow::area_m2},
    RealColumn<StageRow>{"surface_angle_deg", &StageRow::surface_angle_deg},
    RealColumn<StageRow>{"deposit_height_m", &StageRow::deposit_height_m},
    RealColumn<StageRow>{"run_out_m", &StageRow::run_out_m},
};

constexpr std::array place_numbers = {
    RealColumn<PlaceRecord>{"chainage_m", &PlaceRecord::chainage_m},
    RealColumn<PlaceRecord>{"width_m", &PlaceRecord::width_m},
    RealColumn<PlaceRecord>{"arrival_time_s", &PlaceRecord::arrival_time_s},
    RealColumn<PlaceRecord>{"greatest_thickness_m", &PlaceRecord::greatest_thickness_m},
    RealColumn<PlaceRecord>{"greatest_speed_m_s", &PlaceRecord::greatest_speed_m_s},
    RealColumn<PlaceRecord>{"greatest_kinetic_head_m", &PlaceRecord::greatest_kinetic_head_m},
    RealColumn<PlaceRecord>{"greatest_momentum_flux_n_m", &PlaceRecord::greatest_momentum_flux_n_m},
    RealColumn<PlaceRecord>{"final_thickness_m", &PlaceRecord::final_thickness_m},
    RealColumn<PlaceRecord>{"passed_area_m2", &PlaceRecord::passed_area_m2},
};

constexpr std::array barrier = {
    RealColumn<BarrierRecord>{"arrival_time_s", &BarrierRecord::arrival_time_s},
    RealColumn<BarrierRecord>{"greatest_force_n_m", &BarrierRecord::greatest_force_n_m},
    RealColumn<BarrierRecord>{"greatest_force_time_s", &BarrierRecord::greatest_force_time_s},
    RealColumn<BarrierRecord>{"greatest_moment_n", &BarrierRecord::greatest_moment_n},
    RealColumn<BarrierRecord>{"impulse_n_s_m", &BarrierRecord::impulse_n_s_m},
    RealColumn<BarrierRecord>{"last_force_n_m", &BarrierRecord::last_force_n_m},
    RealColumn<BarrierRecord>{"run_up_m", &BarrierRecord::run_up_m},
    RealColumn<BarrierRecord>{"overtopped_area_m2", &BarrierRecord::overtopped_area_m2},
    RealColumn<BarrierRecord>{"approach_speed_m_s", &BarrierRecord::approach_speed_m_s},
    RealColumn<BarrierRecord>{"approach_thickness_m", &BarrierRecord::approach_thickness_m},
    RealColumn<BarrierRecord>{"design_force_n_m", &BarrierRecord::design_force_n_m},
};

constexpr std::array frame_scale = {
    RealColumn<FrameScale>{"time_s", &FrameScale::time_s},
    RealColumn<FrameScale>{"x_low_m", &FrameScale::x_low_m},
    RealColumn<FrameScale>{"x_step_m", &FrameScale::x_step_m},
    RealColumn<FrameScale>{"y_low_m", &FrameScale::y_low_m},
    RealColumn<FrameScale>{"y_step_m", &FrameScale::y_step_m},
    RealColumn<FrameScale>{"speed_low_m_s", &FrameScale::speed_low_m_s},
    RealColumn<FrameScale>{"speed_step_m_s", &FrameScale::speed_step_m_s},
    RealColumn<FrameScale>{"pressure_low_pa", &FrameScale::pressure_low_pa},
    RealColumn<FrameScale>{"pressure_step_pa", &FrameScale::pressure_step_pa},
};

constexpr std::array pilot = {
    RealColumn<PilotRow>{"resolution", &PilotRow::resolution},
    RealColumn<PilotRow>{"lattice_seed", &PilotRow::lattice_seed},
    RealColumn<PilotRow>{"run_out_m", &PilotRow::run_out_m},
    RealColumn<PilotRow>{"reach_angle_deg", &PilotRow::reach_angle_deg},
    RealColumn<PilotRow>{"deposit_height_m", &PilotRow::deposit_height_m},
    RealColumn<PilotRow>{"particles", &PilotRow::particles},
    RealColumn<PilotRow>{"steps", &PilotRow::steps},
    RealColumn<PilotRow>{"pressure_iterations", &PilotRow::pressure_iterations},
    RealColumn<PilotRow>{"cpu_s", &PilotRow::cpu_s},
};

constexpr std::array appraisal = {
    RealColumn<Appraisal>{"run_out_error_m", &Appraisal::run_out_error_m},
    RealColumn<Appraisal>{"reach_angle_error_deg", &Appraisal::reach_angle_error_deg},
    RealColumn<Appraisal>{"expected_cpu_s", &Appraisal::expected_cpu_s},
    RealColumn<Appraisal>{"choosing_cpu_s", &Appraisal::choosing_cpu_s},
};

constexpr std::array appraisal_words = {
    AppraisalText{"accuracy_asked", &Appraisal::accuracy_asked},
    AppraisalText{"error_origin", &Appraisal::error_origin},
    AppraisalText{"error_note", &Appraisal::error_note},
};

constexpr std::array snapshot = {
    SnapshotColumn{"x_m", &Snapshot::x_m},
    SnapshotColumn{"y_m", &Snapshot::y_m},
    SnapshotColumn{"vx_m_s", &Snapshot::vx_m_s},
    SnapshotColumn{"vy_m_s", &Snapshot::vy_m_s},
    SnapshotColumn{"pressure_pa", &Snapshot::pressure_pa},
};

// A member that is added to one of these structs and not to its list would be lost without a word.
static_assert(sizeof(SeriesRow) == series.size() * sizeof(double));
static_assert(sizeof(DepositRow) == deposit.size() * sizeof(double));
static_assert(sizeof(StageRow) == stage.size() * sizeof(double));
static_assert(sizeof(PlaceRecord) == place_numbers.size() * sizeof(double) + 2 * sizeof(std::string) +
                                         sizeof(std::vector<PlaceRow>));
static_assert(sizeof(BarrierRecord) == barrier.size() * sizeof(double) + sizeof(std::vector<BarrierRow>));
static_assert(sizeof(FrameScale) == frame_scale.size() * sizeof(double));
static_assert(sizeof(PilotRow) == pilot.size() * sizeof(double));
static_assert(sizeof(Appraisal) ==
              appraisal.size() * sizeof(double) + appraisal_words.size() * sizeof(std::string));
static_assert(sizeof(Snapshot) == sizeof(double) + snapshot.size() * sizeof(std::vector<float>));

}  // namespace

std::span<const WorkColumn> work_columns() {
    return work;
}
std::span<const RealColumn<SeriesRow>> series_columns() {
    return series;
}
std::span<const RealColumn<DepositRow>> deposit_columns() {
    return deposit;
}
std::span<const RealColumn<StageRow>> stage_columns() {
    return stage;
}
std::span<const RealColumn<PlaceRecord>> place_columns() {
    return place_numbers;
}
std::span<const RealColumn<BarrierRecord>> barrier_columns() {
    return barrier;
}
std::span<const RealColumn<FrameScale>> frame_scale_columns() {
    return frame_scale;
}
std::span<const RealColumn<PilotRow>> pilot_columns() {
    return pilot;
}
std::span<const RealColumn<Appraisal>> appraisal_numbers() {
    return appraisal;
}
std::span<const AppraisalText> appraisal_texts() {
    return appraisal_words;
}
std::span<const SnapshotColumn> snapshot_columns() {
    return snapshot;
}

}  // namespace runout
