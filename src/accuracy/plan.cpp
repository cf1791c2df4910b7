#include "accuracy/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "accuracy/price.h"
#include "accuracy/survey_error.h"
#include "core/machine.h"
#include "run/run_scene.h"

namespace runout {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double pilot_share = 0.35;       // of the run: begun while they are expected to stay below this
constexpr double most_pilot_share = 0.5;   // of the run, in the end
constexpr double steps_per_octave = 4;     // of the resolutions that are offered
constexpr double worthwhile_share = 0.95;  // of the error of a coarser run: less is not worth a finer one

struct PilotPlan {
    double resolution;
    int lattice_seed;
};
constexpr std::array<PilotPlan, 6> pilot_plans = {{{8, 0}, {11, 0}, {8, 1}, {11, 1}, {16, 0}, {16, 1}}};

double resolution_of(const Scene& scene) {
    const double root_area = std::sqrt(scene.source.area);
    return scene.run.particle_spacing > 0 ? root_area / scene.run.particle_spacing : scene.run.resolution;
}

PilotRow pilot_row(const PilotPlan& plan, const RunResult& result) {
    const bool valid = is_result(result.status);
    const Measures& m = result.measures;
    return {plan.resolution,
            static_cast<double>(plan.lattice_seed),
            valid ? m.run_out_m : none,
            valid ? m.reach_angle_deg : none,
            valid ? m.deposit_height_m : none,
            static_cast<double>(result.work.particles),
            static_cast<double>(result.work.steps),
            static_cast<double>(result.work.pressure_iterations),
            result.work.cpu_s};
}

/// Pilots that have been run, and what they say.
class Pilots {
  public:
    Pilots(const Scene& scene, const SurveyError& survey, const CostModel& model)
        : scene_(scene), survey_(survey), model_(model), root_area_(std::sqrt(scene.source.area)) {}

    void run(const PilotPlan& plan, const std::atomic<bool>* interrupt) {
        RunControl control;
        control.interrupt = interrupt;
        Scene coarse = with_resolution(scene_, plan.resolution, plan.lattice_seed);
        coarse.run.snapshot_times.clear();
        const RunResult result = run_scene(coarse, control);
        if (result.status == RunStatus::interrupted) return;
        rows_.push_back(pilot_row(plan, result));
        costs_.push_back(cost_sample(plan.resolution, result.work));
    }

    [[nodiscard]] const std::vector<PilotRow>& rows() const { return rows_; }
    [[nodiscard]] bool empty() const { return rows_.empty(); }
    [[nodiscard]] double cpu_seconds() const {
        double sum = 0;
        for (const PilotRow& row : rows_) sum += row.cpu_s;
        return sum;
    }
    [[nodiscard]] CostSample cost(double resolution) const {
        return expected_cost(costs_, model_, resolution);
    }

    /// Mean over the lattices of the finest pilots that have this number; NaN without.
    [[nodiscard]] double finest(double PilotRow::*number) const {
        double resolution = 0;
        for (const PilotRow& row : rows_)
            if (std::isfinite(row.*number)) resolution = std::max(resolution, row.resolution);
        return mean(number, resolution);
    }

    /// What an error is a share of, m.
    [[nodiscard]] double scale() const { return std::max(finest(&PilotRow::run_out_m), root_area_); }

    /// As unrest_of, by the pilots with the two coarsest spacings. Two runs alone may agree by chance, and
    /// one tells nothing: then it is no less than that of other scenes.
    [[nodiscard]] double unrest() const {
        const double change = mean(&PilotRow::run_out_m, coarser) - mean(&PilotRow::run_out_m, finer);
        if (!std::isfinite(change)) return survey_.high_unrest();
        const double scatter = std::hypot(spread(coarser), spread(finer));
        const double own = std::hypot(change, scatter) / scale();
        const bool repeated = results(coarser) > 1 && results(finer) > 1;
        return repeated ? own : std::max(own, survey_.usual_unrest());
    }

    [[nodiscard]] double run_out_share(double resolution) const {
        return survey_.run_out_share(resolution, unrest());
    }
    [[nodiscard]] double reach_angle_share(double resolution) const {
        return survey_.reach_angle_share(resolution, unrest());
    }

  private:
    static constexpr double coarser = pilot_plans[0].resolution, finer = pilot_plans[1].resolution;

    [[nodiscard]] int results(double resolution) const {
        return static_cast<int>(std::ranges::count_if(rows_, [=](const PilotRow& row) {
            return row.resolution == resolution && std::isfinite(row.run_out_m);
        }));
    }
    /// Standard deviation of the run-outs with one spacing, m; 0 of one.
    [[nodiscard]] double spread(double resolution) const {
        const double middle = mean(&PilotRow::run_out_m, resolution);
        double squares = 0;
        for (const PilotRow& row : rows_)
            if (row.resolution == resolution && std::isfinite(row.run_out_m))
                squares += (row.run_out_m - middle) * (row.run_out_m - middle);
        return std::sqrt(squares / std::max(1, results(resolution) - 1));
    }
    [[nodiscard]] double mean(double PilotRow::*number, double resolution) const {
        double sum = 0, count = 0;
        for (const PilotRow& row : rows_) {
            if (row.resolution != resolution || !std::isfinite(row.*number)) continue;
            sum += row.*number;
            ++count;
        }
        return count > 0 ? sum / count : none;
    }

    const Scene& scene_;
    const SurveyError& survey_;
    const CostModel& model_;
    double root_area_;
    std::vector<PilotRow> rows_;
    std::vector<CostSample> costs_;
};

/// Resolutions on offer, rising.
std::vector<double> offers(double finest) {
    std::vector<double> resolutions;
    for (int k = 0;; ++k) {
        const double resolution = std::round(rung_resolution(0) * std::pow(2.0, k / steps_per_octave));
        if (resolution > finest) return resolutions;
        resolutions.push_back(resolution);
    }
}

/// A spacing and what is known of it.
struct Offer {
    double resolution = 0;
    double error_share = 0;
    bool met = false;
    std::string limit;  ///< why nothing finer was offered; empty when the target is met
};

/// The cheapest that meets `allowed` (a share); the best that can be had when none does.
Offer best_offer(const Pilots& pilots, const SurveyError& survey, double allowed,
                 const PlanOptions& options) {
    Offer best;
    const double free_mb = available_memory_mb();
    for (const double resolution : offers(survey.finest())) {
        const CostSample cost = pilots.cost(resolution);
        if (cost.cpu_s > options.longest_run_s && best.resolution > 0) {
            best.limit = fmt::format("a finer run would take longer than {:.0f} s", options.longest_run_s);
            return best;
        }
        if (free_mb > 0 && cost.peak_memory_mb > free_mb && best.resolution > 0) {
            best.limit =
                fmt::format("a finer run would need more than the {:.0f} MB of free memory", free_mb);
            return best;
        }
        const double share = pilots.run_out_share(resolution);
        const bool met = share <= allowed;
        if (met || best.resolution == 0 || share < worthwhile_share * best.error_share)
            best = {resolution, share, met, {}};
        if (met) return best;
    }
    best.limit = "the lattice scatter and the finest ladders allow no better";
    return best;
}

[[noreturn]] void refuse(const InputPlace& place, double best_share, double scale, double cpu_s,
                         const std::string& limit) {
    // Rounded up, so that asking for what is named is granted.
    const double percent = std::ceil(1000.0 * best_share) / 10.0;
    throw InputError(place, fmt::format("cannot be met on this scene ({})", limit),
                     fmt::format("valid: {:.1f} % ({:.3g} m) or more, which costs about {:.2g} s of CPU time",
                                 percent, 0.01 * percent * scale, cpu_s));
}

std::string pilots_text(const std::vector<PilotRow>& rows) {
    std::string text;
    for (const PilotRow& row : rows) text += fmt::format("{}{:g}", text.empty() ? "" : ", ", row.resolution);
    return fmt::format("{} pilot run{} at sqrt(S)/dl = {}", rows.size(), rows.size() == 1 ? "" : "s", text);
}

/// Error bars from pilots and survey, where the pilots have numbers.
void appraise(const Pilots& pilots, const SurveyError& survey, double resolution, Appraisal& appraisal) {
    const double run_out = pilots.finest(&PilotRow::run_out_m);
    if (!std::isfinite(run_out)) {
        appraisal.error_note = "the pilot runs did not end as results, so no error bar is known";
        return;
    }
    appraisal.error_origin = "pilot";
    appraisal.run_out_error_m = pilots.run_out_share(resolution) * pilots.scale();
    const double angle = pilots.finest(&PilotRow::reach_angle_deg);
    if (std::isfinite(angle)) appraisal.reach_angle_error_deg = pilots.reach_angle_share(resolution) * angle;
    appraisal.error_note =
        fmt::format("{}, held against the ladders of {} slopes", pilots_text(pilots.rows()), survey.scenes());
}

RunPlan plan_from_ladder(const Scene& scene, const PlanOptions& options) {
    const Ladder& ladder = *options.ladder;
    const double root_area = std::sqrt(scene.source.area);
    RunPlan plan{scene, {}, {}, {}};
    double resolution = resolution_of(scene);
    if (options.target) {
        const Price price = *price_of(ladder, *options.target, options.longest_run_s);
        if (!price.met && options.asked)
            refuse(*options.asked, price.error_m / reference_of(ladder).scale_m, reference_of(ladder).scale_m,
                   price.cost.cpu_s, "its ladder scatters more, or would have to be longer");
        resolution = price.resolution;
        plan.scene = with_resolution(scene, resolution, scene.run.lattice_seed);
        plan.appraisal.accuracy_asked = options.target->text();
        plan.reason = fmt::format("sqrt(S)/dl = {:g} {} {} by the scene's own ladder", resolution,
                                  price.met ? "meets" : "comes nearest to", options.target->text());
    }
    plan.appraisal.run_out_error_m = error_bar(ladder.convergence[0], root_area / resolution);
    plan.appraisal.reach_angle_error_deg = error_bar(ladder.convergence[1], root_area / resolution);
    plan.appraisal.error_origin = "ladder";
    plan.appraisal.error_note = fmt::format("its own ladder from sqrt(S)/dl = {:g} to {:g}",
                                            ladder.rungs.front().resolution, reference_of(ladder).resolution);
    std::vector<CostSample> costs;
    for (const RungSummary& rung : ladder.rungs) costs.push_back(rung.cost);
    plan.appraisal.expected_cpu_s = expected_cost(costs, fit_cost_model(costs), resolution).cpu_s;
    return plan;
}

/// Runs pilots as long as they stay cheap beside the run that they lead to.
template <class ChosenResolution>
void run_pilots(Pilots& pilots, const ChosenResolution& chosen, const PlanOptions& options) {
    for (const PilotPlan& next : pilot_plans) {
        if (options.interrupt != nullptr && options.interrupt->load()) return;
        if (!pilots.empty()) {
            const double spent = pilots.cpu_seconds() + pilots.cost(next.resolution).cpu_s;
            if (spent > pilot_share * pilots.cost(chosen()).cpu_s) return;
        }
        pilots.run(next, options.interrupt);
        if (pilots.empty()) return;  // interrupted
    }
}

/// The first resolution from `resolution` on beside which the pilots were cheap.
double worth_its_pilots(const Pilots& pilots, double resolution, double finest) {
    for (const double offer : offers(finest))
        if (offer >= resolution && pilots.cpu_seconds() <= most_pilot_share * pilots.cost(offer).cpu_s)
            return offer;
    return resolution;
}

RunPlan plan_for_target(const Scene& scene, const PlanOptions& options, Pilots& pilots,
                        const SurveyError& survey) {
    const double root_area = std::sqrt(scene.source.area);
    const auto offer = [&] {
        const double run_out = pilots.finest(&PilotRow::run_out_m);
        const double allowed =
            options.target->metres_of(std::isfinite(run_out) ? run_out : 0.0, root_area) / pilots.scale();
        return best_offer(pilots, survey, allowed, options);
    };
    run_pilots(
        pilots, [&] { return offer().resolution; }, options);
    RunPlan plan{scene, {}, pilots.rows(), {}};
    plan.appraisal.accuracy_asked = options.target->text();
    if (pilots.empty()) return plan;
    const Offer best = offer();
    if (!best.met && options.asked)
        refuse(*options.asked, best.error_share, pilots.scale(), pilots.cost(best.resolution).cpu_s,
               best.limit);
    const double resolution = worth_its_pilots(pilots, best.resolution, survey.finest());
    plan.scene = with_resolution(scene, resolution, scene.run.lattice_seed);
    plan.reason = fmt::format("sqrt(S)/dl = {:g} {} {}{}", resolution,
                              best.met ? "is expected to meet" : "comes nearest to", options.target->text(),
                              best.met ? "" : fmt::format(" ({})", best.limit));
    return plan;
}

RunPlan plan_for_spacing(const Scene& scene, const PlanOptions& options, Pilots& pilots) {
    const double resolution = resolution_of(scene);
    // A run of which a pilot would be half is not worth one.
    const double coarsest_with_pilots = 2.0 * rung_resolution(0);
    if (options.pilots && resolution >= coarsest_with_pilots)
        run_pilots(
            pilots, [&] { return resolution; }, options);
    RunPlan plan{scene, {}, pilots.rows(), {}};
    if (pilots.empty())
        plan.appraisal.error_note = options.pilots ? "no pilot runs were made beside a run as coarse as this"
                                                   : "no pilot runs were asked for";
    return plan;
}

/// Coefficients from a handful of runs would be chance.
constexpr std::size_t enough_runs_for_costs = 12;

CostModel cost_model_for(const PlanOptions& options, const std::vector<SurveyedScene>& surveyed) {
    return fit_cost_model(options.costs.size() >= enough_runs_for_costs ? options.costs : costs_of(surveyed));
}

}  // namespace

std::vector<CostSample> costs_on_this_machine(const Store& store) {
    std::vector<CostSample> samples;
    const std::string machine = machine_description();
    for (const StoredRun& run : store.runs())
        if (run.machine == machine && run.work.threads == 1 && run.work.particle_spacing_m > 0)
            samples.push_back(
                cost_sample(std::sqrt(run.measures.source_area_m2) / run.work.particle_spacing_m, run.work));
    return samples;
}

RunPlan plan_run(const Scene& scene, const PlanOptions& options) {
    if (options.ladder && options.ladder->convergence[0].fit) return plan_from_ladder(scene, options);
    const std::vector<SurveyedScene>& surveyed =
        options.survey != nullptr ? *options.survey : shipped_survey();
    const SurveyError survey(surveyed);
    const CostModel model = cost_model_for(options, surveyed);
    Pilots pilots(scene, survey, model);
    RunPlan plan = options.target ? plan_for_target(scene, options, pilots, survey)
                                  : plan_for_spacing(scene, options, pilots);
    plan.appraisal.choosing_cpu_s = pilots.cpu_seconds();
    if (pilots.empty()) return plan;
    const double resolution = resolution_of(plan.scene);
    plan.appraisal.expected_cpu_s = pilots.cost(resolution).cpu_s;
    appraise(pilots, survey, resolution, plan.appraisal);
    return plan;
}

}  // namespace runout
