#include "accuracy/ladder.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "core/machine.h"
#include "run/run_scene.h"

namespace runout {
namespace {

constexpr double coarsest_resolution = 8;
constexpr int most_rungs = 14;  // 8 to 724: beyond, a run takes days
constexpr std::size_t rungs_for_a_verdict = 3;

double mean_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

double deviation_of(const std::vector<double>& values) {
    if (values.size() < 2) return 0;
    const double mean = mean_of(values);
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

/// A source that stands has no reach angle: no number over such runs.
RungValue value_of(const std::vector<StoredRun>& results, double spacing, double Measures::*quantity) {
    std::vector<double> values;
    for (const StoredRun& run : results) values.push_back(run.measures.*quantity);
    return {spacing, mean_of(values), deviation_of(values), static_cast<int>(values.size())};
}

CostSample mean_cost(const std::vector<StoredRun>& results, double resolution) {
    CostSample mean;
    const double count = static_cast<double>(results.size());
    for (const StoredRun& run : results) {
        const CostSample sample = cost_sample(resolution, run.work);
        mean.particles += sample.particles / count;
        mean.steps += sample.steps / count;
        mean.pressure_iterations += sample.pressure_iterations / count;
        mean.cpu_s += sample.cpu_s / count;
        mean.peak_memory_mb = std::max(mean.peak_memory_mb, sample.peak_memory_mb);
    }
    mean.resolution = resolution;
    return mean;
}

bool interrupted(const std::atomic<bool>* interrupt) {
    return interrupt != nullptr && interrupt->load();
}

/// Rungs that have numbers of this quantity.
std::vector<RungValue> values_of(const std::vector<RungSummary>& rungs, std::size_t quantity) {
    std::vector<RungValue> values;
    for (const RungSummary& rung : rungs) {
        const RungValue& value = rung.values[quantity];
        if (rung.results > 0 && std::isfinite(value.mean)) values.push_back(value);
    }
    return values;
}

/// Error allowed for each quantity. Angle and height follow from the run-out's share; a target in metres
/// says nothing of them, and they are then held to the share that it is of the run-out.
double allowed(const AccuracyTarget& target, std::size_t quantity, double finest, double run_out,
               double root_area) {
    const double metres = target.metres_of(run_out, root_area);
    if (quantity == 0) return metres;
    return metres / std::max(run_out, root_area) * std::abs(finest);
}

void judge(Ladder& ladder, double root_area) {
    const std::vector<RungValue> run_outs = values_of(ladder.rungs, 0);
    const double run_out = run_outs.empty() ? 0.0 : run_outs.back().mean;
    for (std::size_t q = 0; q < ladder_quantities.size(); ++q) {
        const std::vector<RungValue> values = values_of(ladder.rungs, q);
        const double finest = values.empty() ? 0.0 : values.back().mean;
        ladder.convergence[q] =
            judge_convergence(values, allowed(ladder.target, q, finest, run_out, root_area));
    }
}

/// Why the ladder should not go on, or nothing.
class Limits {
  public:
    Limits(const LadderOptions& options, const std::vector<CostSample>& samples)
        : options_(options), samples_(samples), start_(std::chrono::steady_clock::now()) {}

    [[nodiscard]] std::string against(double resolution) const {
        if (samples_.empty()) return {};
        const CostSample next = expected_cost(samples_, fit_cost_model(samples_), resolution);
        const double seconds = next.cpu_s * options_.lattices;
        if (elapsed() + seconds > options_.budget_s)
            return fmt::format("the next rung would take about {:.3g} s more, beyond the budget of {:.3g} s",
                               seconds, options_.budget_s);
        const double free = available_memory_mb();
        if (free > 0 && next.peak_memory_mb > free)
            return fmt::format("the next rung would need about {:.3g} MB of memory, and {:.3g} MB are free",
                               next.peak_memory_mb, free);
        return {};
    }

  private:
    [[nodiscard]] double elapsed() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

    const LadderOptions& options_;
    const std::vector<CostSample>& samples_;
    std::chrono::steady_clock::time_point start_;
};

std::string reason_to_end(const Ladder& ladder) {
    switch (ladder.convergence[0].verdict) {
        case Verdict::converged:
            return "the target is met";
        case Verdict::floor_reached:
            return "the lattice scatter is reached";
        case Verdict::oscillating:
        case Verdict::not_converging:
        case Verdict::refining:
        case Verdict::too_few_rungs:
            break;
    }
    return {};
}

}  // namespace

double rung_resolution(int index) {
    return std::round(coarsest_resolution * std::pow(2.0, 0.5 * index));
}

Scene with_resolution(const Scene& scene, double resolution, int lattice_seed) {
    Scene other = scene;
    other.run.particle_spacing = 0;
    other.run.resolution = resolution;
    other.run.lattice_seed = lattice_seed;
    return other;
}

std::string question_hash(const Scene& scene) {
    Scene plain = with_resolution(scene, 0, 0);
    plain.run.snapshot_times.clear();
    return scenario_hash(plain);
}

StoredRun run_and_store(const Scene& scene, Store& store, const std::atomic<bool>* interrupt) {
    RunControl control;
    control.interrupt = interrupt;
    const RunResult result = run_scene(scene, control);
    StoredRun run = describe_run(scene, result);
    if (result.status != RunStatus::interrupted) run.run_id = store.add({scene, result, run, {}});
    return run;
}

StoredRun find_or_run(const Scene& scene, Store& store, const std::atomic<bool>* interrupt) {
    if (const auto known = store.find_run(scenario_hash(scene))) return store.run(*known);
    return run_and_store(scene, store, interrupt);
}

RungSummary summarise(const Rung& rung, double root_area) {
    RungSummary summary;
    summary.resolution = rung.resolution;
    summary.spacing_m = root_area / rung.resolution;
    std::vector<StoredRun> results;
    for (const StoredRun& run : rung.runs) {
        if (is_result(run.status)) {
            results.push_back(run);
            continue;
        }
        if (summary.failed++ > 0) continue;
        summary.failure = fmt::format("{}{}{}", to_string(run.status), run.status_detail.empty() ? "" : ": ",
                                      run.status_detail);
    }
    summary.results = static_cast<int>(results.size());
    const std::vector<StoredRun>& counted = results.empty() ? rung.runs : results;
    summary.cost = mean_cost(counted, rung.resolution);
    for (const StoredRun& run : counted)
        summary.wall_s += run.work.wall_s / static_cast<double>(counted.size());
    if (results.empty()) return summary;
    for (std::size_t q = 0; q < ladder_quantities.size(); ++q)
        summary.values[q] = value_of(results, summary.spacing_m, ladder_quantities[q].value);
    return summary;
}

Reference reference_of(const Ladder& ladder) {
    Reference reference;
    for (const RungSummary& rung : ladder.rungs) {
        if (rung.results == 0) continue;
        reference.run_out_m = rung.values[0].mean;
        reference.resolution = rung.resolution;
        reference.scale_m = std::max(reference.run_out_m, rung.spacing_m * rung.resolution);
    }
    return reference;
}

Ladder climb(const Scene& scene, Store& store, const LadderOptions& options) {
    const double root_area = std::sqrt(scene.source.area);
    Ladder ladder;
    ladder.target = options.target;
    std::vector<CostSample> samples;
    const Limits limits(options, samples);
    for (int index = 0; index < most_rungs && ladder.ended.empty(); ++index) {
        const double resolution = rung_resolution(index);
        if (resolution > options.finest) break;
        ladder.ended = limits.against(resolution);
        if (!ladder.ended.empty()) break;
        Rung rung{resolution, {}};
        for (int lattice = 0; lattice < options.lattices && !interrupted(options.interrupt); ++lattice) {
            const StoredRun run =
                find_or_run(with_resolution(scene, resolution, lattice), store, options.interrupt);
            if (run.status == RunStatus::interrupted) break;
            rung.runs.push_back(run);
            samples.push_back(cost_sample(resolution, run.work));
            ladder.runs.push_back({"spacing", fmt::format("{:g}", resolution), resolution, run.run_id});
        }
        if (!rung.runs.empty()) {
            ladder.rungs.push_back(summarise(rung, root_area));
            judge(ladder, root_area);
            if (options.on_rung) options.on_rung(ladder.rungs.back());
        }
        if (interrupted(options.interrupt)) ladder.ended = "it was stopped";
        const bool enough = ladder.rungs.size() > rungs_for_a_verdict && resolution >= options.at_least_to;
        if (ladder.ended.empty() && enough) ladder.ended = reason_to_end(ladder);
    }
    if (ladder.ended.empty()) ladder.ended = "there is no finer rung";
    return ladder;
}

Ladder read_ladder(const StoredLadder& stored, const Store& store) {
    std::vector<Rung> rungs;
    Ladder ladder;
    ladder.target = accuracy_target(stored.target, {.file = {}, .line = 0, .key = "target", .value = {}});
    double root_area = 1;
    for (const LadderRun& entry : stored.runs) {
        if (entry.series != "spacing") continue;
        const StoredRun run = store.run(entry.run_id);
        root_area = std::sqrt(run.measures.source_area_m2);
        if (rungs.empty() || rungs.back().resolution != entry.resolution)
            rungs.push_back({entry.resolution, {}});
        rungs.back().runs.push_back(run);
        ladder.runs.push_back(entry);
    }
    for (const Rung& rung : rungs) ladder.rungs.push_back(summarise(rung, root_area));
    judge(ladder, root_area);
    return ladder;
}

StoredLadder describe_ladder(const Scene& scene, const Ladder& ladder) {
    StoredLadder stored;
    stored.question_hash = question_hash(scene);
    stored.name = scene.name;
    stored.target = ladder.target.text();
    stored.machine = machine_description();
    stored.runs = ladder.runs;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t q = 0; q < ladder_quantities.size(); ++q) {
        const Convergence& c = ladder.convergence[q];
        stored.verdicts.push_back({ladder_quantities[q].name, std::string(to_string(c.verdict)),
                                   c.finest_value, c.uncertainty, c.scatter,
                                   c.finest_three ? c.finest_three->order : none,
                                   c.finest_three ? c.finest_three->extrapolated : none,
                                   c.finest_three ? c.finest_three->gci : none,
                                   c.fit ? c.fit->observed_order : none, c.fit ? c.fit->value : none});
    }
    return stored;
}

}  // namespace runout
