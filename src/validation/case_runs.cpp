#include "validation/case_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace runout {
namespace {

constexpr int lattices = 4;
constexpr double safety_factor = 1.25;  // Roache's, for an order that is known

std::vector<std::string> numbered(const std::string& id) {
    std::vector<std::string> names;
    for (int seed = 1; seed <= lattices; ++seed) names.push_back(fmt::format("{}-lattice{}", id, seed));
    return names;
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviation_of(const std::vector<double>& values) {
    const double mean = mean_of(values);
    double sum = 0.0;
    for (const double value : values) sum += (value - mean) * (value - mean);
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

}  // namespace

std::vector<std::string> lattices_of(const std::string& id) {
    return numbered(id);
}

std::vector<std::string> coarse_lattices_of(const std::string& id) {
    return numbered(id + "-coarse");
}

void plan_lattices(std::vector<PlannedRun>& plan, const std::string& id, const std::string& file,
                   const Settings& set) {
    const std::vector<std::string> names = lattices_of(id);
    for (int k = 0; k < lattices; ++k) {
        PlannedRun run{names[k], file, set};
        run.set.emplace_back("run.lattice_seed", std::to_string(k + 1));
        plan.push_back(run);
    }
}

void plan_ensemble(std::vector<PlannedRun>& plan, const std::string& id, const std::string& file,
                   const Settings& set, const std::string& key, double value) {
    const double coarse = key == "run.resolution" ? 0.5 * value : 2.0 * value;
    const auto with = [&](double number) {
        Settings both = set;
        both.emplace_back(key, fmt::format("{}", number));
        return both;
    };
    plan_lattices(plan, id, file, with(value));
    plan_lattices(plan, id + "-coarse", file, with(coarse));
}

CaseRuns::CaseRuns(const Store& store, std::vector<std::pair<std::string, long>> run_ids)
    : store_(store), run_ids_(std::move(run_ids)) {}

long CaseRuns::id_of(const std::string& id) const {
    const auto found = std::ranges::find(run_ids_, id, &std::pair<std::string, long>::first);
    if (found == run_ids_.end()) throw std::out_of_range("no run " + id + " was planned");
    return found->second;
}

StoredRun CaseRuns::run(const std::string& id) const {
    return store_.run(id_of(id));
}

std::vector<DepositRow> CaseRuns::deposit(const std::string& id) const {
    return store_.deposit(id_of(id));
}

std::vector<SeriesRow> CaseRuns::series(const std::string& id) const {
    return store_.series(id_of(id));
}

std::vector<Snapshot> CaseRuns::snapshots(const std::string& id) const {
    return store_.snapshots(id_of(id));
}

std::vector<StageRow> CaseRuns::stages(const std::string& id) const {
    return store_.stages(id_of(id));
}

bool all_are_results(const CaseRuns& runs, const std::vector<std::string>& ids) {
    return std::ranges::all_of(ids, [&](const std::string& id) { return is_result(runs.run(id).status); });
}

Estimate mean_and_scatter(const std::vector<double>& values) {
    return {mean_of(values), deviation_of(values), ValidationEntry::none};
}

Estimate estimate_of(const std::vector<double>& fine, const std::vector<double>& coarse) {
    Estimate result = mean_and_scatter(fine);
    result.error = std::hypot(safety_factor * (result.mean - mean_of(coarse)), result.scatter);
    return result;
}

Estimate ratio(const Estimate& a, const Estimate& b) {
    const double mean = a.mean / b.mean;
    const auto spread = [&](double of_a, double of_b) {
        return std::abs(mean) * std::hypot(of_a / a.mean, of_b / b.mean);
    };
    return {mean, spread(a.scatter, b.scatter), spread(a.error, b.error)};
}

ValidationEntry entry_of(const Estimate& estimate, std::string quantity, std::string resolution) {
    ValidationEntry entry;
    entry.quantity = std::move(quantity);
    entry.computed = estimate.mean;
    entry.scatter = estimate.scatter;
    entry.error = estimate.error;
    entry.resolution = std::move(resolution);
    return entry;
}

ValidationEntry held(const Estimate& computed, const std::string& quantity, const ReferenceValue& reference,
                     const std::string& resolution, const std::string& remark) {
    ValidationEntry entry = entry_of(computed, quantity, resolution);
    entry.held_to = reference.origin;
    entry.reference = reference.value;
    entry.accepted = reference.accepted;
    entry.remark = remark;
    return entry;
}

ValidationEntry limited(const Estimate& computed, const std::string& quantity,
                        const ReferenceValue& reference, const std::string& resolution,
                        const std::string& remark) {
    ValidationEntry entry = held(computed, quantity, reference, resolution, remark);
    entry.kind = DeviationKind::at_most;
    return entry;
}

}  // namespace runout
