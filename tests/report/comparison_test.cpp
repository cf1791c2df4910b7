// A run beside empirical relations: their numbers, their ranges, and where their lines meet the ground.

#include "report/compare/comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "store_fixture.h"

namespace runout {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const TravelEstimate& estimate_of(const std::vector<TravelEstimate>& all, const std::string& relation) {
    const auto found = std::ranges::find(all, relation, &TravelEstimate::relation);
    if (found == all.end()) throw std::out_of_range(relation);
    return *found;
}

TravelEstimate estimate(const TravelCase& slide, const std::string& relation) {
    return estimate_of(travel_estimates(slide), relation);
}

constexpr const char* hunter_fell = "Hunter & Fell, cut slopes";
constexpr const char* finlay = "Finlay et al., Hong Kong cuts";

TravelCase cut(double volume) {
    return {.drop = 20, .slope_angle = radians(60), .volume = volume, .apron_angle = 0};
}

TEST(TravelRelations, HunterAndFellIsItsFormula) {
    const TravelEstimate line = estimate(cut(200), hunter_fell);
    ASSERT_EQ(line.lines.size(), 1u);
    EXPECT_NEAR(line.lines[0].ratio, 0.78 * std::sqrt(std::tan(radians(60))), 1e-15);
    EXPECT_TRUE(line.caution.empty());
    EXPECT_FALSE(line.second_hand);
}

TEST(TravelRelations, FinlayAgreesWithHunterAndFellAndIsMarkedSecondHand) {
    for (const double angle : {45.0, 60.0, 70.0}) {
        TravelCase slide = cut(200);
        slide.slope_angle = radians(angle);
        const TravelEstimate line = estimate(slide, finlay);
        EXPECT_TRUE(line.second_hand);
        EXPECT_NEAR(line.lines.at(0).ratio / estimate(slide, hunter_fell).lines.at(0).ratio, 1.0, 0.05)
            << angle;
    }
}

TEST(TravelRelations, RefuseOutsideTheirRange) {
    EXPECT_TRUE(contains(estimate(cut(500), hunter_fell).refusal, "500 m3"));
    EXPECT_TRUE(estimate(cut(500), hunter_fell).lines.empty());
    EXPECT_TRUE(contains(estimate(cut(nan), hunter_fell).caution, "--width"));
    TravelCase steep = cut(200);
    steep.apron_angle = radians(12);
    EXPECT_TRUE(contains(estimate(steep, hunter_fell).refusal, "12.0 deg"));
    EXPECT_TRUE(contains(estimate(steep, finlay).refusal, "12.0 deg"));
    TravelCase wall = cut(200);
    wall.slope_angle = radians(90);
    EXPECT_FALSE(estimate(wall, hunter_fell).refusal.empty());
    EXPECT_TRUE(contains(estimate(cut(2e5), "H/L = c V^k, dry landslides").refusal, "beyond its range"));
    EXPECT_TRUE(estimate(cut(2e5), "H/L = c V^k, rock avalanches").refusal.empty());
    EXPECT_FALSE(estimate(cut(200), "H/L = c V^k, rock avalanches").refusal.empty());
}

TEST(TravelRelations, AskForTheVolumeAndNeverInventIt) {
    for (const TravelEstimate& line : travel_estimates(cut(nan))) {
        if (line.relation == hunter_fell || line.relation == finlay) continue;
        EXPECT_TRUE(line.lines.empty()) << line.relation;
        EXPECT_TRUE(contains(line.refusal, "--width")) << line.relation;
    }
}

TEST(TravelRelations, CorominasAtAThousandCubicMetres) {
    const TravelEstimate debris = estimate(cut(1000), "Corominas, debris flows (all)");
    ASSERT_EQ(debris.lines.size(), 3u);
    EXPECT_NEAR(std::log10(debris.lines[0].ratio), -0.012 - 0.105 * 3, 1e-12);
    EXPECT_NEAR(std::log10(debris.lines[1].ratio), -0.012 - 0.105 * 3 - 0.386, 1e-12);
    EXPECT_NEAR(std::log10(debris.lines[2].ratio), -0.012 - 0.105 * 3 + 0.386, 1e-12);
    const TravelEstimate all = estimate(cut(1000), "Corominas, all landslides (all)");
    EXPECT_TRUE(all.second_hand);
    EXPECT_EQ(all.lines.size(), 1u) << "its limits are not known";
}

TEST(TravelRelations, LowerOddsGoFurther) {
    for (const char* kind : {"dry landslides", "wet landslides", "debris flows"}) {
        const auto lines = estimate(cut(1000), std::string("H/L = c V^k, ") + kind).lines;
        ASSERT_EQ(lines.size(), 3u);
        EXPECT_GT(lines[0].ratio, lines[1].ratio);
        EXPECT_GT(lines[1].ratio, lines[2].ratio);
    }
    EXPECT_NEAR(estimate(cut(1000), "H/L = c V^k, wet landslides").lines[0].ratio,
                0.8467 * std::pow(1000, -0.070562), 1e-12);
}

TEST(TravelPairs, AreThoseOfTheFile) {
    EXPECT_EQ(travel_pairs().size(), 316u);
    const PairStatistics pairs = pair_statistics("Hong Kong");
    EXPECT_EQ(pairs.count, 70);
    EXPECT_NEAR(pairs.mean_angle_deg, 34.0, 0.05);
    EXPECT_EQ(pairs.least_angle_deg, 24);
    EXPECT_EQ(pairs.greatest_angle_deg, 45);
    EXPECT_EQ(pair_statistics("wet, elsewhere").count + pair_statistics("dry").count, 246);
}

// ---- on a section

SectionGeometry cut_of_ten_metres() {
    SectionGeometry geometry;
    geometry.profile.ground = {{-30, 10}, {-10, 10}, {0, 0}, {20, 0}, {40, -2}};
    geometry.profile.crest = 1;
    geometry.profile.toe = 2;
    geometry.head = {-15, 10};
    return geometry;
}

TEST(RunOutAt, IsWhereTheLineFromTheHeadMeetsTheGround) {
    const SectionGeometry geometry = cut_of_ten_metres();
    EXPECT_NEAR(run_out_at(geometry, 0.5), 5.0, 1e-12) << "10 m down in 20 m";
    EXPECT_EQ(run_out_at(geometry, 10.0 / 15.0 + 1e-9), 0.0) << "meets the cut itself";
    // Beyond the bend at 20 m the ground falls at 1 in 10: 10 - r (x + 15) = -(x - 20)/10.
    const double ratio = 0.27, x = (10 - 15 * ratio - 2) / (ratio - 0.1);
    EXPECT_NEAR(run_out_at(geometry, ratio), x, 1e-9) << "horizontally";
    EXPECT_TRUE(std::isnan(run_out_at(geometry, 0.01))) << "beyond the section";
}

TEST(RunOutAt, CountsAVerticalFaceFromItsFoot) {
    SectionGeometry geometry = cut_of_ten_metres();
    geometry.profile.ground = {{-30, 10}, {0, 10}, {0, 0}, {40, 0}};
    geometry.profile.toe = 2;
    EXPECT_NEAR(run_out_at(geometry, 0.5), 5.0, 1e-12);
}

class ComparisonTest : public StoreTest {
  protected:
    RunData settled() {
        Scene scene = example_scene();
        scene.profile.ground = {{-30, 10}, {-10, 10}, {0, 0}, {60, 0}};
        scene.profile.crest = 1;
        scene.profile.toe = 2;
        scene.profile.slope_angle = radians(45);
        scene.source.bed = scene.profile.ground;
        scene.source.head = {-15, 10};
        RunResult result = example_result();
        result.measures.run_out_m = 12;
        result.measures.reach_angle_deg = degrees(std::atan(10.0 / 27.0));
        result.measures.source_area_m2 = 30;
        const long run = add(scene, result);  // the file is there only then
        return read_run_data(Store(path, Store::Mode::read), run);
    }
};

TEST_F(ComparisonTest, TakesHeightAndLengthFromTheHeadToTheMargin) {
    const Comparison comparison = compare_run(settled(), 8);
    EXPECT_NEAR(comparison.slide.drop, 10, 1e-9);
    EXPECT_NEAR(comparison.travel_length, 27, 1e-9);
    EXPECT_NEAR(comparison.slide.volume, 240, 1e-12);
    EXPECT_NEAR(degrees(comparison.slide.slope_angle), 45, 1e-9);
    EXPECT_EQ(comparison.slide.apron_angle, 0);
}

TEST_F(ComparisonTest, TellsWithoutAWidthWhatItNeeds) {
    const RunData run = settled();
    const std::string text = comparison_text(run, compare_run(run, nan));
    EXPECT_TRUE(contains(text, "volume not known: give the width"));
    EXPECT_TRUE(contains(text, "numerical error of this run") ||
                contains(text, "Numerical error of this run"));
    EXPECT_TRUE(contains(text, "Scatter of nature"));
    EXPECT_TRUE(contains(text, "second-hand"));
    EXPECT_TRUE(contains(comparison_page(run, compare_run(run, 8)), "chart-travel-angle"));
}

TEST_F(ComparisonTest, RefusesRunsThatWentNowhere) {
    RunData run = settled();
    EXPECT_TRUE(comparison_refusal(run).empty());
    run.run.measures.run_out_m = 0;
    EXPECT_TRUE(contains(comparison_refusal(run), "does not pass the toe"));
    run.run.status = RunStatus::stable;
    EXPECT_TRUE(contains(comparison_refusal(run), "stands"));
    run.run.status = RunStatus::diverged;
    EXPECT_TRUE(contains(comparison_refusal(run), "diverged"));
}

}  // namespace
}  // namespace runout
