#include "run/run_scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>
#include <optional>

#include "core/units.h"
#include "engine/simulation.h"
#include "measures/advice.h"
#include "measures/barrier.h"
#include "measures/deposit.h"
#include "measures/gauges.h"
#include "run/frames.h"
#include "run/peak_memory.h"
#include "run/series.h"
#include "run/snapshots.h"
#include "scene/effect_settings.h"
#include "scene/make_problem.h"

namespace runout {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double samples_per_time_scale = 20.0;
constexpr double looks_per_time_scale = 4.0;  // for advice: each costs a sum over pairs
constexpr double first_frames_per_time_scale = 20.0;
constexpr double progress_period_s = 0.1;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double cpu_seconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double thickness_at_toe(const DepositProfile& profile) {
    for (const auto& bin : profile.bins) {
        if (bin.x > 0.0 && bin.x <= profile.bin_width) return bin.by_top;
    }
    return 0.0;
}

std::vector<DepositRow> rows_of(const DepositProfile& profile, const Profile& section) {
    std::vector<DepositRow> rows;
    for (const auto& bin : profile.bins) {
        const Vec2 at = section.to_section({bin.x, bin.bed});
        rows.push_back({at.x(), at.y(), bin.by_mass, bin.by_top});
    }
    if (!section.descends_with_chainage) std::reverse(rows.begin(), rows.end());
    return rows;
}

/// Angle below the horizontal from the head of the source to the distal margin, degrees.
double reach_angle(const Vec2& head, const Vec2& margin) {
    return degrees(std::atan2(head.y() - margin.y(), margin.x() - head.x()));
}

double front_threshold(const Scene& scene) {
    return scene.run.front_thickness > 0 ? scene.run.front_thickness : 0.03 * std::sqrt(scene.source.area);
}

Measures measures_at_rest(const Scene& scene, const Simulation& simulation, const DepositProfile& profile,
                          const std::vector<char>& body, double peak_speed) {
    const StateView state = simulation.state();
    const BedLine& bed = *state.ground;
    const Source& source = scene.source;
    Measures m;
    m.front_thickness_m = front_threshold(scene);
    const double front = contiguous_front(profile, &DepositProfile::Bin::by_top, m.front_thickness_m);
    const double by_mass = contiguous_front(profile, &DepositProfile::Bin::by_mass, m.front_thickness_m);
    const bool stood = simulation.status() == RunStatus::stable;
    const auto beyond_toe = [&](double x) { return stood ? 0.0 : std::max(0.0, distance_along_bed(bed, x)); };
    m.run_out_m = beyond_toe(front);
    m.front_by_mass_m = beyond_toe(by_mass);
    m.front_mass_995_m = beyond_toe(mass_front(state, 0.005));
    m.source_area_m2 = source.area;
    m.deposit_area_m2 = deposit_area(state, body);
    m.run_out_normalised = m.run_out_m / std::sqrt(m.deposit_area_m2);
    m.reach_angle_deg = stood ? std::numeric_limits<double>::quiet_NaN()
                              : reach_angle(source.head, {front, bed.elevation(front)});
    m.front_area_m2 = source.front_area;
    m.front_area_ratio = source.front_area / source.area;
    m.drop_height_m = source.drop_height;
    m.drop_height_normalised = source.drop_height / std::sqrt(m.deposit_area_m2);
    for (const auto& bin : profile.bins) m.deposit_height_m = std::max(m.deposit_height_m, bin.by_top);
    m.toe_thickness_m = thickness_at_toe(profile);
    m.peak_front_speed_m_s = stood ? 0.0 : peak_speed;
    m.time_to_rest_s = simulation.motion_ended();
    m.eroded_area_m2 =
        scene.effects.erodible_bed ? simulation.eroded_area() : std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < body.size(); ++i)
        if (body[i] == 0 && state.is_debris(i)) m.stray_particles += 1;
    return m;
}

StageRow stage_at_rest(const Scene& scene, const Simulation& simulation) {
    const StateView state = simulation.state();
    const DepositProfile profile = deposit_profile(state, connected_body(state));
    const double front = contiguous_front(profile, &DepositProfile::Bin::by_top, front_threshold(scene));
    double height = 0.0;
    for (const auto& bin : profile.bins) height = std::max(height, bin.by_top);
    return {simulation.time(), state.discretisation->volume() * static_cast<double>(state.x.size()),
            degrees(surface_angle(profile, front)), height, distance_along_bed(*state.ground, front)};
}

RunWork work_of(const Simulation& simulation) {
    const StateView state = simulation.state();
    const WorkCounts& counts = simulation.work();
    RunWork work;
    work.particles = static_cast<long>(state.x.size());
    work.boundary_particles = simulation.boundary_particles();
    work.particle_spacing_m = state.discretisation->spacing;
    work.steps = counts.steps;
    work.pressure_iterations = counts.pressure_iterations;
    work.bed_guard_activations = counts.bed_guard_activations;
    work.highest_density_ratio = counts.highest_density;
    work.spared_share =
        counts.particle_steps > 0
            ? (counts.flying_particle_steps + counts.sleeping_particle_steps) / counts.particle_steps
            : 0.0;
    work.simulated_s = simulation.time();
    work.threads = simulation.threads();
    return work;
}

std::vector<EffectRow> effects_of(const Scene& scene, const Simulation& simulation) {
    std::vector<EffectRow> rows;
    for (const EffectState& state : effect_states(scene.effects, scene.gauges.size())) {
        EffectRow row{state.name, state.on, state.meaning, std::numeric_limits<double>::quiet_NaN()};
        for (const EffectCost& cost : simulation.effect_costs())
            if (cost.effect == state.effect) row.cost_s = cost.seconds;
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Everything that is read off a run step by step.
class Recorders {
  public:
    Recorders(const Scene& scene, const Simulation& simulation, int frames)
        : series_(simulation.time_scale() / samples_per_time_scale),
          snapshots_(scene.run.snapshot_times),
          frames_(frames, simulation.time_scale() / first_frames_per_time_scale),
          advisor_(scene, simulation.time_scale() / looks_per_time_scale) {
        const double interval = simulation.time_scale() / samples_per_time_scale;
        if (!scene.gauges.empty()) gauges_.emplace(scene.gauges, interval, front_threshold(scene));
        if (scene.effects.barrier) barrier_.emplace(scene, interval, front_threshold(scene));
        series_.sample(simulation, true);
        sample_gauges(simulation, true);
    }

    void sample(const Simulation& simulation) {
        series_.sample(simulation);
        snapshots_.sample(simulation);
        frames_.sample(simulation);
        advisor_.look(simulation);
        sample_gauges(simulation, false);
        if (barrier_) barrier_->sample(simulation);
    }

    void finish(const Simulation& simulation, const Profile& profile, RunResult& result) {
        series_.sample(simulation, true);
        frames_.sample(simulation, true);
        sample_gauges(simulation, true);
        if (barrier_) barrier_->sample(simulation, true);
        result.series = series_.rows();
        result.snapshots = snapshots_.snapshots();
        result.frames = frames_.frames();
        result.advice = advisor_.sentences();
        if (gauges_)
            result.gauges = gauges_->records([&](double x) { return profile.to_section({x, 0}).x(); });
        if (barrier_) result.barriers = {barrier_->record()};
    }

    [[nodiscard]] double peak_front_speed() const { return series_.peak_front_speed(); }
    [[nodiscard]] double gauge_seconds() const { return gauge_seconds_; }

  private:
    void sample_gauges(const Simulation& simulation, bool always) {
        if (!gauges_) return;
        const Stopwatch watch(gauge_seconds_);
        gauges_->sample(simulation.state(), always);
    }

    SeriesRecorder series_;
    SnapshotRecorder snapshots_;
    FrameRecorder frames_;
    Advisor advisor_;
    std::optional<GaugeRecorder> gauges_;
    std::optional<BarrierRecorder> barrier_;
    double gauge_seconds_ = 0;
};

/// Share of the run that lies behind. Nobody knows when a mass will rest; most do within this time, and once
/// one rests the end is known.
double fraction_done(const Simulation& simulation) {
    const double usual_time = 6.0 * simulation.time_scale();
    const double by_time = 1.0 - std::exp(-simulation.time() / usual_time);
    const double by_limit = simulation.time() / simulation.time_limit();
    const double moving = std::max(by_time, by_limit);
    return std::min(1.0, moving + (1.0 - moving) * simulation.rested());
}

}  // namespace

RunResult run_scene(const Scene& scene, const RunControl& control) {
    const auto start = Clock::now();
    const double thread_start = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
    const double program_start = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
    const PeakMemory memory;
    Simulation simulation(make_problem(scene));
    Recorders recorders(scene, simulation, control.frames);
    RunResult result;
    double reported = -1.0;
    bool interrupted = false;
    while (simulation.status() == RunStatus::running && !interrupted) {
        simulation.step();
        recorders.sample(simulation);
        const bool last_stage = scene.effects.release && simulation.status() != RunStatus::running;
        if (simulation.stage_ended() || last_stage) {
            result.stages.push_back(stage_at_rest(scene, simulation));
        }
        const double elapsed = seconds_since(start);
        if (control.on_progress && elapsed - reported > progress_period_s) {
            reported = elapsed;
            control.on_progress({simulation.time(), simulation.time_limit(), fraction_done(simulation),
                                 simulation.work().steps, elapsed});
        }
        interrupted = control.interrupt != nullptr && control.interrupt->load();
    }
    recorders.finish(simulation, scene.profile, result);
    result.status = interrupted ? RunStatus::interrupted : simulation.status();
    result.status_detail = interrupted ? "stopped by the user" : simulation.status_detail();
    const StateView state = simulation.state();
    const std::vector<char> body = connected_body(state);
    const DepositProfile profile = deposit_profile(state, body);
    result.effects = effects_of(scene, simulation);
    if (!scene.gauges.empty()) result.effects.back().cost_s = recorders.gauge_seconds();
    result.measures = measures_at_rest(scene, simulation, profile, body, recorders.peak_front_speed());
    result.work = work_of(simulation);
    result.deposit = rows_of(profile, scene.profile);
    for (int p = 0; p < static_cast<int>(Phase::count); ++p) {
        result.phases.push_back(
            {to_string(static_cast<Phase>(p)), simulation.clock().seconds(static_cast<Phase>(p))});
    }
    for (int k = 0; k < static_cast<int>(Invariant::count); ++k) {
        const InvariantReading& reading = simulation.invariants()[static_cast<std::size_t>(k)];
        result.invariants.push_back(
            {to_string(static_cast<Invariant>(k)), reading.worst, reading.limit, reading.time, reading.x});
    }
    result.work.peak_memory_mb = memory.megabytes();
    result.work.wall_s = seconds_since(start);
    // A run of one thread may have others beside it in the same program.
    result.work.cpu_s = simulation.threads() == 1 ? cpu_seconds(CLOCK_THREAD_CPUTIME_ID) - thread_start
                                                  : cpu_seconds(CLOCK_PROCESS_CPUTIME_ID) - program_start;
    return result;
}

}  // namespace runout
