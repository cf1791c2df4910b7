#pragma once

#include <string>
#include <utility>
#include <vector>

#include "store/store.h"
#include "validation/entry.h"

namespace runout {

/// A run that validation needs: an ordinary case with some keys set otherwise, as `runout run CASE --set`.
struct PlannedRun {
    std::string id;    ///< unique in its case
    std::string file;  ///< relative to the folder of cases: "box-45/case.toml"
    /// Key, text. section.file is relative to the folder of the case file, as in the file itself.
    std::vector<std::pair<std::string, std::string>> set;
};

using Settings = std::vector<std::pair<std::string, std::string>>;

/// Adds four runs on jittered lattices, run.lattice_seed 1 to 4.
void plan_lattices(std::vector<PlannedRun>& plan, const std::string& id, const std::string& file,
                   const Settings& set);

/// Adds four such runs with `key` = `value`, and four with twice the spacing, which tell the error bar. `key`
/// is run.resolution or run.particle_spacing_m.
void plan_ensemble(std::vector<PlannedRun>& plan, const std::string& id, const std::string& file,
                   const Settings& set, const std::string& key, double value);

/// Runs of one case as the store holds them.
class CaseRuns {
  public:
    CaseRuns(const Store& store, std::vector<std::pair<std::string, long>> run_ids);

    /// Throws std::out_of_range when nothing of that name was planned.
    [[nodiscard]] StoredRun run(const std::string& id) const;
    [[nodiscard]] std::vector<DepositRow> deposit(const std::string& id) const;
    [[nodiscard]] std::vector<SeriesRow> series(const std::string& id) const;
    [[nodiscard]] std::vector<Snapshot> snapshots(const std::string& id) const;
    [[nodiscard]] std::vector<StageRow> stages(const std::string& id) const;

  private:
    [[nodiscard]] long id_of(const std::string& id) const;

    const Store& store_;
    std::vector<std::pair<std::string, long>> run_ids_;
};

/// A quantity over the lattices of an ensemble.
struct Estimate {
    double mean = ValidationEntry::none;
    double scatter = ValidationEntry::none;  ///< standard deviation
    /// sqrt((1.25 d)^2 + scatter^2), d the difference to the mean with twice the spacing: the grid
    /// convergence index for first order, and what one lattice may miss.
    double error = ValidationEntry::none;
};

/// Names of the ensemble's runs with the spacing asked for, and with twice that.
std::vector<std::string> lattices_of(const std::string& id);
std::vector<std::string> coarse_lattices_of(const std::string& id);

/// `quantity(run id)` over the ensemble. A run that did not end as a result makes the mean NaN.
template <class Quantity>
Estimate estimate(const CaseRuns& runs, const std::string& id, const Quantity& quantity);

/// Without an error bar.
Estimate mean_and_scatter(const std::vector<double>& values);
Estimate estimate_of(const std::vector<double>& fine, const std::vector<double>& coarse);
/// Of a / b of two ensembles; their lattices are independent.
Estimate ratio(const Estimate& a, const Estimate& b);
bool all_are_results(const CaseRuns& runs, const std::vector<std::string>& ids);

/// Entry with the numbers of an estimate filled in.
ValidationEntry entry_of(const Estimate& estimate, std::string quantity, std::string resolution);

/// What a number is held against.
struct ReferenceValue {
    std::string origin = "-";  ///< none: only reported
    double value = ValidationEntry::none;
    double accepted = ValidationEntry::none;
};

/// Relative deviation from a reference; without an accepted one it is only reported.
ValidationEntry held(const Estimate& computed, const std::string& quantity, const ReferenceValue& reference,
                     const std::string& resolution, const std::string& remark = {});
/// A number that must not exceed `reference.accepted`.
ValidationEntry limited(const Estimate& computed, const std::string& quantity,
                        const ReferenceValue& reference, const std::string& resolution,
                        const std::string& remark = {});

template <class Quantity>
Estimate estimate(const CaseRuns& runs, const std::string& id, const Quantity& quantity) {
    const std::vector<std::string> fine = lattices_of(id);
    const std::vector<std::string> coarse = coarse_lattices_of(id);
    if (!all_are_results(runs, fine) || !all_are_results(runs, coarse)) return {};
    std::vector<double> values, coarse_values;
    for (const std::string& name : fine) values.push_back(quantity(name));
    for (const std::string& name : coarse) coarse_values.push_back(quantity(name));
    return estimate_of(values, coarse_values);
}

/// A case of the suite: which runs it needs, and what they say.
struct ValidationCase {
    const char* name;  ///< folder under cases/
    /// `quick`: the part that fits into a test.
    std::vector<PlannedRun> (*plan)(bool quick);
    CaseReport (*evaluate)(const CaseRuns& runs, const std::string& folder, bool quick);
};

}  // namespace runout
