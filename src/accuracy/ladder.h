#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "accuracy/convergence.h"
#include "accuracy/cost_model.h"
#include "scene/accuracy_target.h"
#include "store/store.h"

namespace runout {

/// A quantity that a ladder follows: a measure of the run.
struct LadderQuantity {
    const char* name;   ///< column of measure
    const char* title;  ///< for people, with its unit
    double Measures::*value;
};
constexpr std::array<LadderQuantity, 3> ladder_quantities = {{
    {"run_out_m", "run-out, m", &Measures::run_out_m},
    {"reach_angle_deg", "reach angle, deg", &Measures::reach_angle_deg},
    {"deposit_height_m", "deposit height, m", &Measures::deposit_height_m},
}};

/// The same question with one spacing, from several lattices.
struct Rung {
    double resolution = 0;  ///< sqrt(S) / particle spacing
    std::vector<StoredRun> runs;
};

/// A rung in numbers: means over the runs that ended as results.
struct RungSummary {
    double resolution = 0;
    double spacing_m = 0;
    int results = 0;
    int failed = 0;
    std::string failure;                                     ///< status and detail of the first that failed
    CostSample cost;                                         ///< of one run
    double wall_s = 0;                                       ///< of one run
    std::array<RungValue, ladder_quantities.size()> values;  ///< in the order of ladder_quantities
};
RungSummary summarise(const Rung& rung, double root_area);

/// What a ladder found.
struct Ladder {
    std::vector<RungSummary> rungs;  ///< from the coarsest to the finest; some may have no result
    std::array<Convergence, ladder_quantities.size()> convergence;
    AccuracyTarget target;
    std::string ended;  ///< why it is no longer: a clause, "the target is met"
    std::vector<LadderRun> runs;
};

/// What a ladder's error is measured against: the mean of its finest rung with a result, and the size that
/// makes it a share (the run-out, or sqrt(S) where that is more).
struct Reference {
    double run_out_m = 0;
    double scale_m = 1;
    double resolution = 0;
};
Reference reference_of(const Ladder& ladder);

struct LadderOptions {
    AccuracyTarget target{0.05, 0};
    int lattices = 3;        ///< a rung: the regular one and jittered ones
    double budget_s = 300;   ///< wall time for all
    double at_least_to = 0;  ///< sqrt(S)/dl that is run even if the target is met before
    double finest = std::numeric_limits<double>::infinity();  ///< sqrt(S)/dl that no rung exceeds
    std::function<void(const RungSummary&)> on_rung;          ///< as each rung ends
    const std::atomic<bool>* interrupt = nullptr;
};

/// sqrt(S)/dl of rung 0, 1, ...: 8, 11, 16, 23, 32, 45, ...; each has twice the particles of the one before.
double rung_resolution(int index);

/// `scene` with another spacing and lattice.
Scene with_resolution(const Scene& scene, double resolution, int lattice_seed);

/// Identity of the question: all that determines the result but spacing and lattice.
std::string question_hash(const Scene& scene);

/// Simulates the scene and stores the run, unless it was interrupted. `interrupt` may be null.
StoredRun run_and_store(const Scene& scene, Store& store, const std::atomic<bool>* interrupt);

/// The run of `scene` that `store` holds, or else a new one, stored. `interrupt` may be null.
StoredRun find_or_run(const Scene& scene, Store& store, const std::atomic<bool>* interrupt);

/// Runs the scene on one rung after another until the run-out meets the target, has reached its floor, or the
/// next rung would not fit into the budget or the memory. Runs that the store holds are not repeated; new
/// ones are stored as each ends. At least three rungs are run unless the budget forbids.
Ladder climb(const Scene& scene, Store& store, const LadderOptions& options);

/// A ladder read back from its stored runs.
Ladder read_ladder(const StoredLadder& stored, const Store& store);

/// For Store::add.
StoredLadder describe_ladder(const Scene& scene, const Ladder& ladder);

}  // namespace runout
