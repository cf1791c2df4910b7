#include "run/run_scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>
#include <optional>

#include "engine/simulation.h"
#include "measures/advice.h"
#include "measures/barrier.h"
#include "measures/deposit.h"
#include "measures/envelope.h"
#include "measures/front_rule.h"
#include "measures/places.h"
#include "measures/reach.h"
#include "run/creep_watch.h"
#include "run/frames.h"
#include "run/peak_memory.h"
#include "run/rest_measures.h"
#include "run/series.h"
#include "run/snapshots.h"
#include "scene/effect_settings.h"
#include "scene/make_problem.h"

namespace runout {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double samples_per_time_scale = 20.0;
constexpr double looks_per_time_scale = 4.0;  // for advice: each costs a sum over pairs
constexpr long steps_per_look = 4;  // at front and places: no particle moves by a spacing between two of them
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

std::vector<DepositRow> rows_of(const DepositProfile& profile, const Profile& section) {
    std::vector<DepositRow> rows;
    for (const auto& bin : profile.bins) {
        const Vec2 at = section.to_section({bin.x, bin.bed});
        rows.push_back({at.x(), at.y(), bin.by_mass, bin.by_top});
    }
    if (!section.descends_with_chainage) std::reverse(rows.begin(), rows.end());
    return rows;
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
    for (const EffectState& state : effect_states(scene.effects, scene.places.size())) {
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
        : reach_(front_rule(scene), simulation.state()),
          envelope_(scene.material.density, reach_),
          series_(simulation.time_scale() / samples_per_time_scale),
          snapshots_(scene.run.snapshot_times),
          frames_(frames, simulation.time_scale() / first_frames_per_time_scale),
          advisor_(scene, simulation.time_scale() / looks_per_time_scale) {
        const double interval = simulation.time_scale() / samples_per_time_scale;
        if (!scene.places.empty()) places_.emplace(scene.places, interval, scene.material.density);
        if (scene.effects.barrier) barrier_.emplace(scene, interval, front_rule(scene).threshold);
        series_.sample(simulation, reach_);
        envelope_.look(reach_, simulation.state());
        sample_places(simulation, true);
    }

    void sample(const Simulation& simulation) {
        const bool is_due = series_.is_due(simulation);
        if (simulation.released() && (is_due || simulation.work().steps % steps_per_look == 0)) {
            reach_.look(simulation.state());
            envelope_.look(reach_, simulation.state());
            sample_places(simulation, false);
        }
        if (simulation.released() && is_due) series_.sample(simulation, reach_);
        snapshots_.sample(simulation);
        frames_.sample(simulation);
        advisor_.look(simulation);
        if (barrier_) barrier_->sample(simulation);
    }

    void finish(const Simulation& simulation, const Profile& profile, RunResult& result) {
        reach_.look(simulation.state());
        envelope_.look(reach_, simulation.state());
        series_.sample(simulation, reach_);
        frames_.sample(simulation, true);
        sample_places(simulation, true);
        if (barrier_) barrier_->sample(simulation, true);
        result.series = series_.rows();
        result.snapshots = snapshots_.snapshots();
        result.frames = frames_.frames();
        result.advice = advisor_.sentences();
        if (places_)
            result.places = places_->records([&](double x) { return profile.to_section({x, 0}).x(); });
        result.envelope = envelope_.envelope();
        if (barrier_) result.barriers = {barrier_->record()};
        if (simulation.status() == RunStatus::stable) forget_arrivals(result);
    }

    [[nodiscard]] const ReachRecorder& reach() const { return reach_; }
    [[nodiscard]] double peak_mass_point_speed() const { return series_.peak_mass_point_speed(); }
    [[nodiscard]] double place_seconds() const { return place_seconds_; }

  private:
    void sample_places(const Simulation& simulation, bool always) {
        if (!places_) return;
        const Stopwatch watch(place_seconds_);
        places_->sample(reach_, simulation.state(), always);
    }

    /// A source that stands reaches nothing, though its window looks a little beyond it.
    static void forget_arrivals(RunResult& result) {
        constexpr double never = std::numeric_limits<double>::quiet_NaN();
        for (PlaceRecord& place : result.places) place.arrival_time_s = never;
        std::ranges::fill(result.envelope.arrival_time_s, never);
    }

    ReachRecorder reach_;
    EnvelopeRecorder envelope_;
    SeriesRecorder series_;
    SnapshotRecorder snapshots_;
    FrameRecorder frames_;
    Advisor advisor_;
    std::optional<PlaceRecorder> places_;
    std::optional<BarrierRecorder> barrier_;
    double place_seconds_ = 0;
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
    CreepWatch creep(scene, simulation);
    RunResult result;
    double reported = -1.0;
    bool interrupted = false;
    while (simulation.status() == RunStatus::running && !interrupted) {
        simulation.step();
        recorders.sample(simulation);
        creep.look(simulation, recorders.reach());
        if (creep.negligible() && simulation.status() == RunStatus::running) simulation.end_at_rest();
        const bool last_stage = scene.effects.release && simulation.status() != RunStatus::running;
        if (simulation.stage_ended() || last_stage) {
            result.stages.push_back(stage_at_rest(scene, simulation));
        }
        const double elapsed = seconds_since(start);
        if (control.on_progress && elapsed - reported > progress_period_s) {
            reported = elapsed;
            control.on_progress({simulation.time(), simulation.time_limit(), fraction_done(simulation),
                                 simulation.work().steps, elapsed,
                                 elapsed * (simulation.time_limit() / simulation.time() - 1)});
        }
        interrupted = control.interrupt != nullptr && control.interrupt->load();
    }
    recorders.finish(simulation, scene.profile, result);
    const StateView state = simulation.state();
    const std::vector<char> body = connected_body(state);
    const DepositProfile profile = deposit_profile(state, body);
    result.effects = effects_of(scene, simulation);
    if (!scene.places.empty()) result.effects.back().cost_s = recorders.place_seconds();
    result.measures = measures_at_rest(
        scene, {simulation, recorders.reach(), profile, body, recorders.peak_mass_point_speed()});
    const Verdict verdict = interrupted ? Verdict{RunStatus::interrupted, "stopped by the user"}
                                        : verdict_on(simulation, recorders.reach(), result.measures);
    result.status = verdict.status;
    result.status_detail = verdict.detail;
    if (const std::string warning = spray_warning(simulation, result.measures); !warning.empty())
        result.advice.insert(result.advice.begin(), warning);
    if (creep.negligible()) result.advice.insert(result.advice.begin(), creep.sentence());
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
