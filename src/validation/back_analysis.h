#pragma once

#include <string>
#include <vector>

#include "store/store.h"
#include "validation/case_runs.h"
#include "validation/run_suite.h"

namespace runout {

/// One line of ranges.csv: a key of the case and the values it may have.
struct InputRange {
    std::string key;
    std::vector<std::string> values;
    std::string source;
    std::string firmness;  ///< found, derived, second-hand or assumed
};

/// One line of observed.csv. NaN: not known.
struct Observation {
    std::string quantity;  ///< a column of the table measure, or words for what the model does not compute
    double low = 0, high = 0;
    std::string source;
    std::string firmness;  ///< as of a range; empty where nothing is known
};

/// A documented failure: a folder with case.toml, ranges.csv and observed.csv.
struct BackAnalysis {
    std::string folder;
    std::string name;  ///< of the folder
    std::vector<InputRange> ranges;
    std::vector<Observation> observed;
};

/// Reads both lists. Throws InputError with the line: no such file, wrong columns, unknown firmness, unknown
/// key, a range without values.
BackAnalysis read_back_analysis(const std::string& folder);

/// Every combination of the values. Throws InputError when there are more than 1000.
std::vector<PlannedRun> combinations(const BackAnalysis& analysis);

/// Ids of the stored runs of all combinations; what the store lacks is simulated. Empty when interrupted.
/// Throws InputError when a combination is no valid scene.
std::vector<long> run_back_analysis(const BackAnalysis& analysis, Store& store, const SuiteOptions& options);

/// Least and greatest of a measure over runs that are results; a source that stands has no run-out.
struct ModelRange {
    int runs = 0, stable = 0, failed = 0;
    double low = 0, high = 0;  ///< NaN when no run has the measure
};
ModelRange model_range(const std::vector<StoredRun>& runs, double Measures::*value);

}  // namespace runout
