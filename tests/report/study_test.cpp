// Studies: what their files say, how samples are drawn, and which scenarios they make.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "report/text/sensitivity.h"
#include "study/distribution.h"
#include "study/scenarios.h"
#include "study/study_file.h"
#include "temporary_folder.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

std::vector<std::vector<Setting>> combinations(const Study& study) {
    const Combinations all(study);
    std::vector<std::vector<Setting>> list;
    for (std::size_t k = 0; k < all.size(); ++k) list.push_back(all[k]);
    return list;
}

class StudyTest : public testing::Test {
  protected:
    Study study(const std::string& text) const {
        const std::string path = folder_.file("study.toml");
        std::ofstream(path) << text;
        return read_study(path);
    }
    std::string complaint(const std::string& text) const {
        try {
            combinations(study(text));
        } catch (const InputError& error) {
            return error.what();
        }
        return "none";
    }
    TemporaryFolder folder_;
};

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

Distribution distribution(Distribution::Shape shape, double a, double b) {
    Distribution d;
    d.shape = shape;
    d.mean = a;
    d.deviation = b;
    d.low = -INFINITY;
    d.high = INFINITY;
    return d;
}

// ---- distributions

TEST(Quantile, IsThatOfTheLaw) {
    const Distribution normal = distribution(Distribution::Shape::normal, 35, 2);
    EXPECT_NEAR(quantile(normal, 0.5), 35, 1e-12);
    EXPECT_NEAR(quantile(normal, 0.975), 35 + 2 * 1.959963984540054, 1e-9);
    Distribution uniform = normal;
    uniform.shape = Distribution::Shape::uniform;
    uniform.low = 1;
    uniform.high = 3;
    EXPECT_DOUBLE_EQ(quantile(uniform, 0.25), 1.5);
    Distribution triangular = uniform;
    triangular.shape = Distribution::Shape::triangular;
    triangular.mode = 2;
    EXPECT_NEAR(quantile(triangular, 0.5), 2, 1e-12);
    EXPECT_NEAR(quantile(triangular, 0.125), 1.5, 1e-12);
}

TEST(Quantile, MomentsOfALognormalAreThoseOfTheQuantity) {
    const Distribution d = distribution(Distribution::Shape::lognormal, 10, 3);
    double sum = 0, squares = 0;
    constexpr int n = 200000;
    for (int k = 0; k < n; ++k) {
        const double x = quantile(d, (k + 0.5) / n);
        sum += x;
        squares += x * x;
    }
    EXPECT_NEAR(sum / n, 10, 1e-3);
    EXPECT_NEAR(std::sqrt(squares / n - sum / n * sum / n), 3, 1e-2);
}

TEST(Quantile, CutDistributionsKeepTheirEnds) {
    Distribution d = distribution(Distribution::Shape::normal, 35, 5);
    d.low = 30;
    d.high = 36;
    EXPECT_NEAR(quantile(d, 1e-9), 30, 1e-3);
    EXPECT_NEAR(quantile(d, 1 - 1e-9), 36, 1e-3);
    EXPECT_GT(quantile(d, 0.5), 30);
}

// ---- Latin hypercube

TEST(LatinHypercube, HasOneSampleInEachStratumOfEachColumn) {
    const Eigen::MatrixXd table = latin_hypercube(50, Eigen::MatrixXd::Identity(3, 3), 1);
    for (Eigen::Index j = 0; j < 3; ++j) {
        std::set<int> strata;
        for (Eigen::Index i = 0; i < 50; ++i) strata.insert(static_cast<int>(table(i, j) * 50));
        EXPECT_EQ(strata.size(), 50u);
    }
}

TEST(LatinHypercube, IsTheSameForASeedOnEveryMachine) {
    const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(2, 2);
    EXPECT_EQ(latin_hypercube(20, identity, 5), latin_hypercube(20, identity, 5));
    EXPECT_NE(latin_hypercube(20, identity, 5), latin_hypercube(20, identity, 6));
    // mt19937_64 is defined to the bit by the standard: its 10,000th number is 9981545732273789042.
    EXPECT_NEAR(latin_hypercube(1, Eigen::MatrixXd::Identity(1, 1), 5489)(0, 0),
                14514284786278117030.0 / 0x1p64, 1e-15);
}

TEST(LatinHypercube, ReachesTheRankCorrelationAndKeepsTheColumns) {
    Eigen::MatrixXd wanted = Eigen::MatrixXd::Identity(2, 2);
    wanted(0, 1) = wanted(1, 0) = -0.7;
    const Eigen::MatrixXd table = latin_hypercube(500, wanted, 3);
    const std::vector<double> a(table.col(0).begin(), table.col(0).end()),
        b(table.col(1).begin(), table.col(1).end());
    EXPECT_NEAR(rank_correlation(a, b), -0.7, 0.03);
    std::set<int> strata;
    for (const double x : b) strata.insert(static_cast<int>(x * 500));
    EXPECT_EQ(strata.size(), 500u);
}

TEST(LatinHypercube, RefusesCorrelationsThatCannotHold) {
    Eigen::MatrixXd wanted = Eigen::MatrixXd::Identity(3, 3);
    wanted(0, 1) = wanted(1, 0) = wanted(0, 2) = wanted(2, 0) = 0.9;
    wanted(1, 2) = wanted(2, 1) = -0.9;
    EXPECT_THROW(latin_hypercube(10, wanted, 1), std::invalid_argument);
}

// ---- sensitivity

TEST(Sensitivity, FindsTheInputThatMatters) {
    const Eigen::MatrixXd table = latin_hypercube(1000, Eigen::MatrixXd::Identity(2, 2), 9);
    const std::vector<double> a(table.col(0).begin(), table.col(0).end()),
        b(table.col(1).begin(), table.col(1).end());
    std::vector<double> y;
    for (std::size_t i = 0; i < a.size(); ++i)
        y.push_back(3 * a[i] + b[i]);  // shares of the variance 0.9 and 0.1
    const auto found = sensitivities({{"a", a}, {"b", b}}, y);
    EXPECT_NEAR(found[0].first_order, 0.9, 0.03);
    EXPECT_NEAR(found[1].first_order, 0.1, 0.03);
    EXPECT_GT(found[0].rank_correlation, 0.9);
    EXPECT_TRUE(std::isnan(sensitivities({{"a", {1, 2, 3}}}, {1, 2, 3})[0].first_order)) << "too few samples";
    EXPECT_NEAR(rank_correlation({1, 2, 3, 4}, {10, 20, 20, 40}), 0.9486832980505138, 1e-12) << "ties";
}

// ---- files

TEST_F(StudyTest, ListsAndRangesAreCrossed) {
    const Study s = study(
        "[vary]\nsource.type = [\"B\", \"C\"]\nmaterial.friction_angle_deg = { from = 30, to = 36, step = 2 "
        "}\n");
    const auto all = combinations(s);
    ASSERT_EQ(all.size(), 8u);
    EXPECT_EQ(combination_count(s), 8);
    std::set<std::string> distinct;
    for (const auto& settings : all) distinct.insert(settings_json(settings));
    EXPECT_EQ(distinct.size(), 8u);
    EXPECT_TRUE(distinct.contains("{\"material.friction_angle_deg\": 36, \"source.type\": \"C\"}"))
        << *distinct.begin();
}

TEST_F(StudyTest, OneAtATimeVariesEachAlone) {
    const Study s = study(
        "[study]\ndesign = \"one-at-a-time\"\n[vary]\na.b = [1, 2, 3]\n"
        "c.d = { distribution = \"normal\", mean = 10, deviation = 1 }\n");
    const auto all = combinations(s);
    ASSERT_EQ(all.size(), 5u);
    EXPECT_EQ(combination_count(s), 5);
    for (const auto& settings : all) EXPECT_TRUE(settings[0].second == "1" || settings[1].second == "10");
}

TEST_F(StudyTest, SamplesAreDrawnForEachCombination) {
    const std::string text =
        "[study]\nsamples = 7\nseed = 3\n[vary]\na.b = [1, 2]\n"
        "c.d = { distribution = \"uniform\", low = 0, high = 1 }\n";
    EXPECT_EQ(combinations(study(text)).size(), 14u);
    EXPECT_EQ(combinations(study(text)), combinations(study(text)));
}

TEST_F(StudyTest, BadStudiesGetOneSentence) {
    EXPECT_TRUE(has(complaint(""), "names nothing to vary"));
    EXPECT_TRUE(has(complaint("[vary]\na = []\n"), "line 2")) << complaint("[vary]\na = []\n");
    EXPECT_TRUE(has(complaint("[vary]\na = []\n"), "empty list"));
    EXPECT_TRUE(has(complaint("[vray]\na = [1]\n"), "vray"));
    EXPECT_TRUE(has(complaint("[vary]\na = { from = 1, to = 0, step = 1 }\n"), "does not lead from 1 to 0"));
    EXPECT_TRUE(has(complaint("[vary]\na = { from = 0, to = 1, step = 0 }\n"), "does not lead"));
    EXPECT_TRUE(
        has(complaint(
                "[study]\nsamples = 5\n[vary]\na = { distribution = \"normal\", mean = 1, deviation = 0 }\n"),
            "without spread"));
    EXPECT_TRUE(has(
        complaint("[study]\nsamples = 5\n[vary]\na = { distribution = \"uniform\", low = 2, high = 2 }\n"),
        "without spread"));
    EXPECT_TRUE(
        has(complaint("[study]\nsamples = 5\n[vary]\na = { distribution = \"cauchy\" }\n"), "valid: normal"));
    EXPECT_TRUE(has(complaint("[vary]\na = { distribution = \"uniform\", low = 1, high = 2 }\n"), "samples"));
    EXPECT_TRUE(has(complaint("[study]\nsamples = 5\n[vary]\na = [1]\n"), "nothing to draw from"));
    EXPECT_TRUE(has(complaint("[study]\nseed = -1\n[vary]\na = [1]\n"), "study.seed = -1"));
    EXPECT_TRUE(has(complaint("[study\n"), "not valid TOML"));
    const std::string two =
        "[study]\nsamples = 9\n[vary]\na = { distribution = \"uniform\", low = 1, high = 2 }\n"
        "b = { distribution = \"uniform\", low = 1, high = 2 }\n[[correlation]]\n";
    EXPECT_TRUE(has(complaint(two + "between = [\"a\", \"c\"]\nrank = 0.5\n"), "\"c\"") ||
                has(complaint(two + "between = [\"a\", \"c\"]\nrank = 0.5\n"), "= c"));
    EXPECT_TRUE(has(complaint(two + "between = [\"a\", \"b\"]\nrank = 1.5\n"), "between -1 and 1"));
    EXPECT_EQ(complaint(two + "between = [\"a\", \"b\"]\nrank = 0.5\n"), "none");
}

TEST_F(StudyTest, ScenariosAreCasesWithTheirSettings) {
    const std::string root = RUNOUT_SOURCE_DIR;
    const Study s = study("[study]\ncase = \"" + root +
                          "/cases/soil-cut-60/case.toml\"\n[vary]\n"
                          "material.friction_angle_deg = [31, 33]\n");
    const ScenarioList list(s);
    ASSERT_EQ(list.size(), 2u);
    EXPECT_NEAR(list.case_of(1).material.friction_angle, 33 * 3.14159265358979 / 180, 1e-12);
    const Study map = study("[study]\ncase = \"" + root +
                            "/cases/terrain/case.toml\"\n[vary]\nsource.base_angle_deg = [28, 30]\n");
    const ScenarioList sections(map);
    EXPECT_EQ(sections.size(), 20u) << "ten lines of the layer";
    EXPECT_NE(sections.case_of(0).name, sections.case_of(1).name);
    const Study unknown =
        study("[study]\ncase = \"" + root + "/cases/terrain/case.toml\"\n[vary]\nsource.bse = [28]\n");
    EXPECT_THROW(ScenarioList{unknown}, InputError);
}

TEST(ShippedStudies, AllMakeScenes) {
    for (const char* name : {"wedges", "boxes"}) {
        const ScenarioList list(
            read_study(std::string(RUNOUT_SOURCE_DIR) + "/cases/run-out-chart/" + name + ".toml"));
        EXPECT_GT(list.size(), 100U) << name;
        int scenes = 0;
        for (std::size_t i = 0; i < list.size(); i += 10) {
            try {
                scenes += make_scene(list.case_of(i)).source.area > 0 ? 1 : 0;
            } catch (const InputError&) {  // does not fit its slope: refused, as the study says of a few
            }
        }
        EXPECT_GT(scenes, 8) << name;
    }
}

}  // namespace
}  // namespace runout
