// Documented failures over the ranges of what is not known of them.

#include "validation/back_analysis.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>

#include "report/text/back_analysis_text.h"
#include "scene/case_file.h"
#include "scene/scene.h"
#include "store_fixture.h"

namespace runout {
namespace {

class BackAnalysisTest : public StoreTest {
  protected:
    void SetUp() override {
        folder = (directory / "slide").string();
        fs::create_directories(folder);
        write("case.toml",
              "[section]\nfile = \"cut.csv\"\n[source]\ntype = \"B\"\nbase_angle_deg = 30\n"
              "[material]\nfriction_angle_deg = 38\n[run]\nresolution = 8\n");
        write("cut.csv", "chainage_m,elevation_m\n0,10\n10,10\n16,0\n80,0\n");
        write("ranges.csv",
              "# comment\nkey,values,source,firmness\nmaterial.friction_angle_deg,25|30,a report,found\n"
              "source.base_angle_deg,20|40,nobody,assumed\n");
        write("observed.csv",
              "quantity,low,high,source,firmness\nrun_out_m,4,9,a report,second-hand\nreach_angle_deg,,,not "
              "found,\n"
              "volume_m3,30,,a report,found\n");
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(fs::path(folder) / name) << text;
    }
    [[nodiscard]] std::string refusal_to_read() const {
        return input_error([this] { static_cast<void>(read_back_analysis(folder)); });
    }

    std::string folder;
};

TEST_F(BackAnalysisTest, ReadsRangesAndObservations) {
    const BackAnalysis analysis = read_back_analysis(folder);
    EXPECT_EQ(analysis.name, "slide");
    ASSERT_EQ(analysis.ranges.size(), 2u);
    EXPECT_EQ(analysis.ranges[0].values, (std::vector<std::string>{"25", "30"}));
    ASSERT_EQ(analysis.observed.size(), 3u);
    EXPECT_EQ(analysis.observed[0].high, 9);
    EXPECT_TRUE(std::isnan(analysis.observed[1].low));
    EXPECT_EQ(read_back_analysis(folder + "/").name, "slide");
}

TEST_F(BackAnalysisTest, CombinesEveryValueWithEveryOther) {
    const auto runs = combinations(read_back_analysis(folder));
    ASSERT_EQ(runs.size(), 4u);
    std::set<std::string> ids;
    for (const PlannedRun& run : runs) {
        ids.insert(run.id);
        EXPECT_EQ(run.set.size(), 2u);
    }
    EXPECT_EQ(ids.size(), 4u);
    EXPECT_EQ(*ids.begin(), "friction_angle_deg=25 base_angle_deg=20");
}

TEST_F(BackAnalysisTest, RefusesWhatItCannotUse) {
    write("ranges.csv", "key,values,source,firmness\nmaterial.friction,25,x,found\n");
    EXPECT_TRUE(contains(refusal_to_read(), "material.friction"));
    EXPECT_TRUE(contains(refusal_to_read(), "ranges.csv, line 2"));
    write("ranges.csv", "key,values,source,firmness\nmaterial.friction_angle_deg,25||30,x,found\n");
    EXPECT_TRUE(contains(refusal_to_read(), "empty value"));
    write("ranges.csv", "key,values,source,firmness\nmaterial.friction_angle_deg,25,x,certain\n");
    EXPECT_TRUE(contains(refusal_to_read(), "found, derived, second-hand, assumed"));
    write("ranges.csv", "key,values\n");
    EXPECT_TRUE(contains(refusal_to_read(), "key,values,source,firmness"));
    write("ranges.csv", "key,values,source,firmness\nrun.courant,0.1\n");
    EXPECT_TRUE(contains(refusal_to_read(), "2 fields"));
    write("ranges.csv", "");
    EXPECT_TRUE(contains(refusal_to_read(), "is empty"));
    fs::remove(fs::path(folder) / "ranges.csv");
    EXPECT_TRUE(contains(refusal_to_read(), "ranges.csv: does not exist"));
    folder += "-that-is-not-there";
    EXPECT_TRUE(contains(refusal_to_read(), "is not a folder"));
}

TEST_F(BackAnalysisTest, RefusesNumbersThatAreNoneAndTooManyCombinations) {
    write("observed.csv", "quantity,low,high,source,firmness\nrun_out_m,about 4,,x,found\n");
    EXPECT_TRUE(contains(refusal_to_read(), "about 4"));
    write("observed.csv", "quantity,low,high,source,firmness\nrun_out_m,4,,x,\n");
    EXPECT_TRUE(contains(refusal_to_read(), "firmness")) << "a number needs one";
    write("observed.csv", "quantity,low,high,source,firmness\n");
    std::string many = "0";
    for (int i = 1; i < 40; ++i) many += fmt::format("|{}", i);
    write("ranges.csv", "key,values,source,firmness\nmaterial.friction_angle_deg," + many +
                            ",x,found\nsource.base_angle_deg," + many + ",x,found\n");
    const BackAnalysis analysis = read_back_analysis(folder);
    EXPECT_TRUE(contains(input_error([&] { static_cast<void>(combinations(analysis)); }), "1000"));
}

TEST_F(BackAnalysisTest, RunsWhatIsMissingOnceAndTellsTheRange) {
    const BackAnalysis analysis = read_back_analysis(folder);
    Store store(path, Store::Mode::write);
    SuiteOptions options;
    int simulated = 0;
    options.on_run = [&](int, int, const std::string&) { ++simulated; };
    const std::vector<long> ids = run_back_analysis(analysis, store, options);
    ASSERT_EQ(ids.size(), 4u);
    EXPECT_EQ(simulated, 4);
    EXPECT_EQ(run_back_analysis(analysis, store, options), ids);
    EXPECT_EQ(simulated, 4) << "nothing is simulated twice";

    ASSERT_EQ(store.studies().size(), 1u) << "a back-analysis is a study";
    const std::vector<StudyRow> rows = store.study_rows(store.studies()[0].study_id);
    ASSERT_EQ(rows.size(), 4u);
    for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(rows[i].run_id, ids[i]);
    std::vector<StoredRun> runs;
    for (const long id : ids) runs.push_back(store.run(id));
    const ModelRange range = model_range(runs, &Measures::run_out_m);
    EXPECT_EQ(range.runs, 4);
    EXPECT_EQ(range.failed, 0);
    EXPECT_LE(range.low, range.high);
    for (const StoredRun& run : runs) EXPECT_LE(run.measures.run_out_m, range.high);
    const std::string text = back_analysis_text(analysis, runs);
    EXPECT_TRUE(contains(text, "| run-out, m |"));
    EXPECT_TRUE(contains(text, "4 to 9 | a report (second-hand)"));
    EXPECT_TRUE(contains(text, "not known | not found"));
    EXPECT_TRUE(contains(text, "dry, plane-strain"));
}

TEST(ModelRange, LeavesFailedRunsOut) {
    StoredRun good, stands, failed;
    good.status = RunStatus::settled;
    good.measures.run_out_m = 5;
    good.measures.reach_angle_deg = 30;
    stands.status = RunStatus::stable;
    stands.measures.reach_angle_deg = std::numeric_limits<double>::quiet_NaN();
    failed.status = RunStatus::diverged;
    failed.measures.run_out_m = 900;
    const ModelRange run_out = model_range({good, stands, failed}, &Measures::run_out_m);
    EXPECT_EQ(run_out.stable, 1);
    EXPECT_EQ(run_out.failed, 1);
    EXPECT_EQ(run_out.low, 0);
    EXPECT_EQ(run_out.high, 5);
    const ModelRange angle = model_range({good, stands, failed}, &Measures::reach_angle_deg);
    EXPECT_EQ(angle.low, 30);
    EXPECT_EQ(angle.high, 30);
}

// The shipped cases: every number with where it comes from.

TEST(HongKong, CasesAreWellFormed) {
    const fs::path root = fs::path(RUNOUT_SOURCE_DIR) / "cases/hong-kong";
    int cases = 0;
    for (const auto& entry : fs::directory_iterator(root)) {
        if (!entry.is_directory()) continue;
        ++cases;
        const BackAnalysis analysis = read_back_analysis(entry.path().string());
        EXPECT_FALSE(analysis.ranges.empty()) << entry.path();
        for (const InputRange& range : analysis.ranges) EXPECT_FALSE(range.source.empty()) << range.key;
        for (const Observation& seen : analysis.observed) EXPECT_FALSE(seen.source.empty()) << seen.quantity;
        EXPECT_LE(combinations(analysis).size(), 64u);
    }
    EXPECT_EQ(cases, 3);
}

TEST(ShippedBackAnalyses, EveryCombinationMakesAScene) {
    const std::string cases = std::string(RUNOUT_SOURCE_DIR) + "/cases";
    int count = 0;
    for (const auto& folder : std::filesystem::directory_iterator(cases + "/hong-kong")) {
        if (!folder.is_directory()) continue;
        for (const PlannedRun& run : combinations(read_back_analysis(folder.path().string()))) {
            CaseSpec spec = read_case((folder.path() / "case.toml").string());
            for (const auto& [key, value] : run.set)
                override_value(spec, key, key == "section.file" ? (folder.path() / value).string() : value,
                               run.id);
            EXPECT_NO_THROW(make_scene(spec)) << run.id;
            ++count;
        }
    }
    EXPECT_GT(count, 50);
}

}  // namespace
}  // namespace runout
