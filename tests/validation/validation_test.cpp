// The validation room itself: arithmetic of entries and ensembles, and that runs are made once and stored.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "core/input_error.h"
#include "temporary_folder.h"
#include "validation/data_file.h"
#include "validation/run_suite.h"
#include "validation/suite.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

TEST(ValidationEntry, DeviationIsRelativeAbsoluteOrTheNumberItself) {
    ValidationEntry entry{.reference = 2.0, .computed = 2.1, .accepted = 0.06};
    EXPECT_NEAR(deviation(entry), 0.05, 1e-12);
    EXPECT_TRUE(within_band(entry));
    entry.computed = 1.87;
    EXPECT_FALSE(within_band(entry));
    entry.kind = DeviationKind::absolute;
    EXPECT_NEAR(deviation(entry), -0.13, 1e-12);
    entry.kind = DeviationKind::at_most;
    EXPECT_EQ(deviation(entry), 1.87);
    EXPECT_FALSE(within_band(entry));
    entry.computed = -5.0;
    EXPECT_TRUE(within_band(entry));
}

TEST(ValidationEntry, ANumberThatDoesNotExistIsOutsideUnlessNothingIsAsked) {
    ValidationEntry entry{.reference = 1.0, .accepted = 0.5};
    EXPECT_FALSE(within_band(entry));
    entry.accepted = ValidationEntry::none;
    EXPECT_TRUE(within_band(entry));
}

TEST(Ensemble, ErrorHoldsTheDifferenceOfSpacingsAndTheScatter) {
    const Estimate e = estimate_of({1.0, 1.2, 0.8, 1.0}, {1.4, 1.4, 1.4, 1.4});
    EXPECT_NEAR(e.mean, 1.0, 1e-12);
    EXPECT_NEAR(e.scatter, std::sqrt(0.08 / 3), 1e-12);
    EXPECT_NEAR(e.error, std::hypot(1.25 * 0.4, e.scatter), 1e-12);
}

TEST(Ensemble, PlansFourLatticesAndFourWithTwiceTheSpacing) {
    std::vector<PlannedRun> plan;
    plan_ensemble(plan, "a", "x/case.toml", {{"run.courant", "0.1"}}, "run.resolution", 30);
    plan_ensemble(plan, "b", "x/case.toml", {}, "run.particle_spacing_m", 0.002);
    ASSERT_EQ(plan.size(), 16U);
    EXPECT_EQ(plan[3].set,
              (Settings{{"run.courant", "0.1"}, {"run.resolution", "30"}, {"run.lattice_seed", "4"}}));
    EXPECT_EQ(plan[4].set[1].second, "15");
    EXPECT_EQ(plan[12].set[0].second, "0.004");
    std::set<std::string> ids;
    for (const PlannedRun& run : plan) ids.insert(run.id);
    EXPECT_EQ(ids.size(), 16U);
}

TEST(DataFile, ReadsLabelledAndPlainPoints) {
    const TemporaryFolder folder;
    const std::string path = folder.file("points.csv");
    std::ofstream(path) << "# origin\nline,x,y\na,1,2\nb,3,4\na,5,6\n";
    EXPECT_EQ(read_points(path, "a"), (std::vector<Vec2>{{1, 2}, {5, 6}}));
    EXPECT_THROW(read_points(path), InputError);
    EXPECT_THROW(read_points("no-such-file.csv"), InputError);
}

TEST(DataFile, CrossingIsInterpolated) {
    EXPECT_DOUBLE_EQ(crossing({{0, 1}, {2, 3}}, 2.5), 1.5);
    EXPECT_TRUE(std::isnan(crossing({{0, 1}, {2, 3}}, 4)));
}

TEST(Suite, EveryCaseHasItsFolderWithAReadme) {
    for (const ValidationCase& item : validation_cases()) {
        EXPECT_TRUE(fs::exists(fs::path(RUNOUT_SOURCE_DIR) / "cases" / item.name / "README.md")) << item.name;
    }
}

TEST(Suite, QuickPlansAndFullPlansNameEachRunOnce) {
    for (const ValidationCase& item : validation_cases()) {
        for (const bool quick : {true, false}) {
            std::set<std::string> ids;
            for (const PlannedRun& run : item.plan(quick)) {
                EXPECT_TRUE(ids.insert(run.id).second) << item.name << ": " << run.id;
            }
        }
    }
}

std::vector<PlannedRun> two_small_runs(bool) {
    const Settings small = {{"run.resolution", "6"}};
    return {{"one", "similarity/case.toml", small}, {"same", "similarity/case.toml", small}};
}

CaseReport read_both(const CaseRuns& runs, const std::string&, bool) {
    CaseReport report{.name = "small"};
    report.entries.push_back({.quantity = "run-out", .computed = runs.run("one").measures.run_out_m});
    report.entries.push_back({.quantity = "run-out", .computed = runs.run("same").measures.run_out_m});
    return report;
}

class SuiteRunner : public testing::Test {
  protected:
    void SetUp() override {
        options_.cases_folder = RUNOUT_SOURCE_DIR "/cases";
        options_.jobs = 2;
        options_.on_run = [this](int, int, const std::string&) { ++simulated_; };
    }
    std::vector<CaseReport> run() {
        const ValidationCase small{"small", two_small_runs, read_both};
        Store store(path_, Store::Mode::write);
        return run_suite({&small, 1}, store, options_);
    }
    TemporaryFolder folder_;
    std::string path_ = folder_.file("suite.db");
    SuiteOptions options_;
    int simulated_ = 0;
};

TEST_F(SuiteRunner, MakesEachScenarioOnceAndReadsTheStore) {
    const auto first = run();
    EXPECT_EQ(simulated_, 1);
    ASSERT_EQ(first.size(), 1U);
    EXPECT_GT(first[0].entries[0].computed, 0.0);
    EXPECT_EQ(first[0].entries[0].computed, first[0].entries[1].computed);
    const auto second = run();
    EXPECT_EQ(simulated_, 1);
    EXPECT_EQ(second[0].entries[0].computed, first[0].entries[0].computed);
}

TEST_F(SuiteRunner, AnInterruptLeavesNoReportAndNoHalfRun) {
    const std::atomic<bool> stop{true};
    options_.interrupt = &stop;
    EXPECT_TRUE(run().empty());
    EXPECT_EQ(simulated_, 0);
    EXPECT_TRUE(Store(path_, Store::Mode::read).runs().empty());
}

}  // namespace
}  // namespace runout
