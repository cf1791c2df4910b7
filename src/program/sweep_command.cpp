#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "accuracy/cost_model.h"
#include "accuracy/plan.h"
#include "accuracy/survey.h"
#include "core/input_error.h"
#include "core/printable.h"
#include "program/answer.h"
#include "program/command.h"
#include "program/common_options.h"
#include "program/interrupt.h"
#include "program/log.h"
#include "program/patient_store.h"
#include "program/progress_line.h"
#include "program/refused_sections.h"
#include "program/slurm_job.h"
#include "scene/scene.h"
#include "store/store.h"
#include "store/write_ahead.h"
#include "study/run_queue.h"
#include "study/scenarios.h"
#include "study/study_file.h"
#include "study/study_identity.h"

namespace runout {
namespace {

constexpr double most_scenarios_unasked = 100'000;
constexpr std::size_t rows_at_a_time = 500;
constexpr std::size_t scenes_for_a_price = 20;

struct SweepArguments {
    std::string study;
    std::string database = "sweep.db";
    std::string shard;
    std::string refused;
    OutputRules rules{};
    int jobs = default_jobs();
    bool dry_run = false;
    bool slurm = false;
    bool yes = false;
    bool series = false;
    bool quiet = false;
};

/// "3/8": the third (counted from 0) of eight parts.
struct Shard {
    std::size_t index = 0, count = 1;
};

Shard shard_of(const std::string& text) {
    if (text.empty()) return {};
    const InputPlace place = option_place("--shard", text);
    Shard shard;
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, shard.index);
    const bool has_slash = first.ec == std::errc{} && first.ptr != end && *first.ptr == '/';
    const auto second = has_slash ? std::from_chars(first.ptr + 1, end, shard.count) : first;
    if (!has_slash || second.ec != std::errc{} || second.ptr != end || shard.count == 0)
        throw InputError(place, "is not a part", "give index/count, such as 0/8");
    if (shard.index >= shard.count)
        throw InputError(place, "is out of range",
                         fmt::format("give an index from 0 to {}", shard.count - 1));
    return shard;
}

void check_size(const Study& study, bool yes) {
    const double count = combination_count(study);
    if (count > most_scenarios_unasked && count <= most_combinations_of_a_study && !yes)
        throw InputError({.file = study.file, .line = 0, .key = {}, .value = {}},
                         fmt::format("asks for {:.0f} combinations", count),
                         fmt::format("more than {:.0f} are run with --yes", most_scenarios_unasked));
}

/// CPU seconds that a scene of this fineness takes: by the runs of the database on this machine, or by the
/// shipped ones.
double expected_seconds(const Scene& scene, const std::vector<CostSample>& known) {
    const double spacing = scene.run.particle_spacing;
    const double resolution = spacing > 0 ? std::sqrt(scene.source.area) / spacing : scene.run.resolution;
    constexpr std::size_t enough = 12;
    if (known.size() >= enough) return expected_cost(known, fit_cost_model(known), resolution).cpu_s;
    const std::vector<CostSample> shipped = costs_of(shipped_survey());
    const CostModel model = fit_cost_model(shipped);
    double sum = 0;
    for (const SurveyedScene& surveyed : shipped_survey()) {
        std::vector<CostSample> samples;
        for (const RungSummary& rung : surveyed.rungs) samples.push_back(rung.cost);
        sum += expected_cost(samples, model, resolution).cpu_s;
    }
    return sum / static_cast<double>(shipped_survey().size());
}

/// Scenes spread over the study: what one takes, how many are refused, and why.
struct Price {
    double seconds = 0;  ///< mean of one scenario
    std::size_t looked_at = 0, refused = 0;
    std::string refusal;
};

Price price_of(const ScenarioList& scenarios, const std::vector<CostSample>& known) {
    Price price;
    const std::size_t step = std::max<std::size_t>(1, scenarios.size() / scenes_for_a_price);
    for (std::size_t k = 0; k < scenarios.size(); k += step) {
        ++price.looked_at;
        try {
            price.seconds += expected_seconds(make_scene(scenarios.case_of(k)), known);
        } catch (const InputError& error) {
            if (price.refused++ == 0) price.refusal = error.what();
        }
    }
    const std::size_t good = price.looked_at - price.refused;
    if (good > 0) price.seconds /= static_cast<double>(good);
    return price;
}

std::vector<CostSample> costs_in(const std::string& database) {
    try {
        return costs_on_this_machine(Store(database, Store::Mode::read));
    } catch (const InputError&) {
        return {};  // a study that has not begun
    }
}

int tell_price(const SweepArguments& arguments, const Study& study, const ScenarioList& scenarios) {
    const Price price = price_of(scenarios, costs_in(arguments.database));
    const double all = price.seconds * static_cast<double>(scenarios.size());
    print_text(fmt::format("{}: {} scenarios, about {:.2g} s of CPU time each, {} in all with {} at a time\n",
                           printable(study.name), scenarios.size(), price.seconds,
                           duration_text(all / arguments.jobs), arguments.jobs));
    if (price.refused > 0)
        print_text(fmt::format("{} of {} scenarios looked at are refused, the first because of {}\n",
                               price.refused, price.looked_at, price.refusal));
    return exit_code::success;
}

/// The lines of a layer in a sweep: one counts as refused when all of its scenarios are.
class SweptSections {
  public:
    void take(const Scenario& scenario, const std::string& refusal) {
        if (!scenario.line) return;
        const long id = scenario.line->feature.feature_id;
        RefusedSection row = refused_section(*scenario.line, refusal);
        if (refusal.empty()) {
            good_.insert({row.origin, id});
            return;
        }
        if (told_.insert({id, refusal}).second) tell_refused(row);
        refused_.emplace(std::pair(row.origin, id), std::move(row));
    }

    /// A row for each line that has no scenario but refused ones.
    [[nodiscard]] std::vector<RefusedSection> refused() const {
        std::vector<RefusedSection> rows;
        for (const auto& [key, row] : refused_)
            if (!good_.contains(key)) rows.push_back(row);
        return rows;
    }

    void store_in(Store& store) const {
        std::map<std::string, SectionsTaken> by_origin;
        for (const auto& [origin, id] : good_) by_origin[origin].taken.push_back(id);
        for (RefusedSection& row : refused()) by_origin[row.origin].refused.push_back(std::move(row));
        for (auto& [origin, sections] : by_origin) {
            sections.origin = origin;
            store.set_sections(sections);
        }
    }

    [[nodiscard]] std::size_t good() const { return good_.size(); }

  private:
    using Key = std::pair<std::string, long>;  // origin and feature
    std::set<Key> good_;
    std::map<Key, RefusedSection> refused_;
    std::set<std::pair<long, std::string>> told_;
};

/// Tells how far a sweep is, and writes what has become of its scenarios into the database.
class SweepLog {
  public:
    SweepLog(const ScenarioList& scenarios, Store& store, long study_id, std::size_t total, bool quiet)
        : scenarios_(scenarios), store_(store), study_id_(study_id), total_(total), quiet_(quiet) {}

    void take(const QueueEvent& event) {
        rows_.push_back({static_cast<long>(event.job), event.scenario_hash,
                         settings_json(settings_of(event.job)), event.refusal});
        sections_.take(scenarios_[event.job], event.refusal);
        ++done_;
        if (event.simulated) ++simulated_;
        if (!event.refusal.empty()) ++refused_;
        if (event.run_id && !is_result(event.status)) ++failed_;
        if (rows_.size() >= rows_at_a_time) flush();
        tell();
    }

    void flush() {
        store_.set_study_scenarios(study_id_, rows_);
        rows_.clear();
    }

    [[nodiscard]] std::string summary() const {
        return fmt::format(
            "{} of {} scenarios: {} simulated, {} known before, {} refused, {} without a result", done_,
            total_, simulated_, done_ - simulated_ - refused_, refused_, failed_);
    }
    [[nodiscard]] bool complete() const { return done_ == total_; }
    [[nodiscard]] bool has_failures() const { return failed_ + refused_ > 0; }
    [[nodiscard]] const SweptSections& sections() const { return sections_; }

  private:
    using Clock = std::chrono::steady_clock;

    /// A line of a layer is part of what was varied.
    [[nodiscard]] std::vector<Setting> settings_of(std::size_t job) const {
        Scenario scenario = scenarios_[job];
        if (scenario.line)
            scenario.settings.emplace_back("section.feature_id",
                                           fmt::format("{}", scenario.line->feature.feature_id));
        return scenario.settings;
    }

    void tell() {
        const auto now = Clock::now();
        if (quiet_ || (done_ < total_ && now < next_line_)) return;
        next_line_ = now + std::chrono::seconds(5);
        const double passed = std::chrono::duration<double>(now - begin_).count();
        const double left = passed / static_cast<double>(done_) * static_cast<double>(total_ - done_);
        log_info("{}; {} left", summary(), duration_text(left));
    }

    const ScenarioList& scenarios_;
    Store& store_;
    long study_id_;
    std::size_t total_;
    bool quiet_;
    std::vector<StudyScenario> rows_;
    SweptSections sections_;
    std::size_t done_ = 0, simulated_ = 0, refused_ = 0, failed_ = 0;
    Clock::time_point begin_ = Clock::now(), next_line_ = Clock::now() + std::chrono::seconds(5);
};

int run_sweep(const SweepArguments& arguments, const Study& study, const ScenarioList& scenarios,
              const Shard& shard) {
    WriteAheadLog log_of_writes(arguments.database);
    Store store(arguments.database, Store::Mode::write);
    const InterruptWatch interrupt;
    wait_for_others(store, arguments.database, interrupt.requested());
    const long study_id = store.begin_study(study.name, study_identity(study));
    RunQueue queue;
    queue.first = shard.index;
    queue.stride = shard.count;
    queue.count = scenarios.size();
    queue.scene = [&](std::size_t job) { return make_scene(scenarios.case_of(job)); };
    queue.refuses = true;
    queue.series = arguments.series;
    queue.workers = arguments.jobs;
    queue.interrupt = &interrupt.requested();
    const std::size_t total =
        scenarios.size() > shard.index ? (scenarios.size() - shard.index - 1) / shard.count + 1 : 0;
    SweepLog log(scenarios, store, study_id, total, arguments.quiet);
    queue.on_event = [&](const QueueEvent& event) {
        log.take(event);
        log_of_writes.checkpoint_now_and_then();
    };
    run_queue(queue, store);
    log.flush();
    log.sections().store_in(store);
    fmt::print("{}\n", log.summary());
    const std::vector<RefusedSection> refused = log.sections().refused();
    write_refused(arguments.refused, refused, arguments.rules);
    if (!refused.empty())
        print_text(fmt::format("sections: {}\n", good_and_refused(log.sections().good(), refused.size())));
    if (!log.complete()) {
        log_warning("stopped; what has ended is in {}, and the same command goes on", arguments.database);
        return exit_code::interrupted;
    }
    return log.has_failures() ? exit_code::not_a_result : exit_code::success;
}

int sweep(SweepArguments arguments) {
    if (arguments.quiet) log_errors_only();
    const Shard shard = shard_of(arguments.shard);
    const Study study = read_study(arguments.study);
    arguments.rules.taken = database_files(arguments.database);
    for (const std::string& file : study_files(study)) arguments.rules.taken.push_back(file);
    if (!arguments.refused.empty())
        check_output_place(arguments.refused, "--refused", Folder::exists, arguments.rules);
    check_size(study, arguments.yes || arguments.dry_run);
    const ScenarioList scenarios(study);
    if (arguments.dry_run) return tell_price(arguments, study, scenarios);
    if (arguments.slurm) {
        const Price price = price_of(scenarios, costs_in(arguments.database));
        fmt::print("{}", slurm_job({study.file, study.name, scenarios.size(), price.seconds, shard.count}));
        return exit_code::success;
    }
    return run_sweep(arguments, study, scenarios, shard);
}

}  // namespace

void add_sweep_command(CommandLine& program) {
    const auto arguments = std::make_shared<SweepArguments>();
    Command command =
        program.add_command("sweep", "Run the scenarios of a study; what is there already is not repeated");
    command
        .add_option("STUDY", &arguments->study, "Study (.toml): a case, and what is varied (docs/sweeps.md)")
        .required()
        .value_name("");
    command.add_option("--db", &arguments->database, "Database that takes the runs")
        .value_name("PATH")
        .show_default();
    add_jobs_option(command, arguments->jobs);
    command
        .add_option("--shard", &arguments->shard,
                    "Only a part: index/count, counted from 0, for many machines")
        .value_name("i/n");
    command.add_flag("--dry-run", &arguments->dry_run,
                     "Say how many scenarios there are and what they will take");
    command.add_flag("--slurm", &arguments->slurm,
                     "Print a Slurm job array in as many parts as --shard 0/n says; give it to sbatch");
    command.add_flag("--series", &arguments->series,
                     "Store the series of each run too, as `runout run` does");
    add_refused_option(command, arguments->refused);
    add_overwrite_option(command, arguments->rules);
    command.add_flag("--yes", &arguments->yes, "Run more than 100,000 combinations");
    command.add_flag("--quiet", &arguments->quiet, "No progress, no log but errors");
    command.set_work([arguments] { return sweep(*arguments); });
}

}  // namespace runout
