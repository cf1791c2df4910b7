// Order, extrapolation, index and verdicts, from numbers whose convergence is known.

#include "accuracy/convergence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace runout {
namespace {

/// f0 + c h^p at the given spacings.
std::vector<GridValue> power_law(double f0, double c, double p, const std::vector<double>& spacings) {
    std::vector<GridValue> values;
    for (const double h : spacings) values.push_back({h, f0 + c * std::pow(h, p)});
    return values;
}

std::vector<RungValue> rungs(const std::vector<double>& means, double scatter, int lattices = 3) {
    std::vector<RungValue> values;
    double spacing = 1.0;
    for (const double mean : means) {
        values.push_back({spacing, mean, scatter, lattices});
        spacing /= std::sqrt(2.0);
    }
    return values;
}

// ---- Richardson and the grid convergence index

TEST(Richardson, TheTutorialOfNasa) {
    const auto found = richardson({{{1, 0.97050}, {2, 0.96854}, {4, 0.96178}}});
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->order, 1.786170, 5e-7);
    EXPECT_NEAR(found->extrapolated, 0.9713003, 5e-8);
    EXPECT_NEAR(100 * found->gci, 0.103083, 5e-7);
}

TEST(Richardson, IsExactForAPowerLawWhateverTheRatios) {
    for (const double order : {0.5, 1.0, 1.7, 3.0}) {
        const auto v = power_law(2.0, -0.3, order, {0.1, 0.13, 0.22});
        const auto found = richardson({v[0], v[1], v[2]});
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->order, order, 1e-8);
        EXPECT_NEAR(found->extrapolated, 2.0, 1e-10);
        EXPECT_NEAR(found->gci, 1.25 * 0.3 * std::pow(0.1, order) / v[0].value, 1e-9);
    }
}

TEST(Richardson, SaysNothingOfNumbersWithoutAnOrder) {
    EXPECT_FALSE(richardson({{{1, 1.0}, {2, 1.1}, {4, 1.0}}})) << "to and fro";
    EXPECT_FALSE(richardson({{{1, 1.0}, {2, 1.0}, {4, 1.3}}})) << "no change";
    EXPECT_FALSE(richardson({{{1, 1.0}, {2, 1.3}, {4, 1.5}}})) << "changes grow on refinement";
}

// ---- Least squares

TEST(RefinementFit, FindsOrderAndLimitOfAPowerLaw) {
    for (const double order : {0.6, 1.0, 2.0}) {
        const RefinementFit fit = fit_refinement(power_law(5.0, 0.8, order, {1, 0.7, 0.5, 0.35, 0.25}));
        EXPECT_NEAR(fit.observed_order, order, 1e-4);
        EXPECT_NEAR(fit.value, 5.0, 1e-4);
        EXPECT_EQ(fit.safety_factor, 1.25);
        EXPECT_NEAR(refinement_uncertainty(fit, 0.25, fit.at(0.25)), 1.25 * 0.8 * std::pow(0.25, order),
                    1e-3);
    }
}

TEST(RefinementFit, DoesNotBelieveAnUnusualOrder) {
    const RefinementFit steep = fit_refinement(power_law(5.0, 0.8, 4.0, {1, 0.7, 0.5, 0.35}));
    EXPECT_EQ(steep.safety_factor, 3.0);
    EXPECT_TRUE(steep.first_order == 1.0 || steep.first_order == 2.0);
    const RefinementFit flat = fit_refinement(power_law(5.0, 0.8, 0.1, {1, 0.7, 0.5, 0.35}));
    EXPECT_EQ(flat.safety_factor, 3.0);
}

TEST(RefinementFit, DataThatOnlyScatterHaveAWideUncertainty) {
    std::vector<GridValue> values;
    double sign = 1;
    for (const double spacing : {1.0, 0.7, 0.5, 0.35, 0.25}) {
        values.push_back({spacing, 5.0 + 0.1 * sign});
        sign = -sign;
    }
    const RefinementFit fit = fit_refinement(values);
    EXPECT_GT(fit.deviation, fit.range_per_step);
    EXPECT_GT(refinement_uncertainty(fit, 0.25, fit.at(0.25)), 3 * fit.deviation);
}

TEST(RefinementFit, AValueOffTheFitIsLessCertain) {
    const RefinementFit fit = fit_refinement(power_law(5.0, 0.8, 1.0, {1, 0.7, 0.5, 0.35, 0.25}));
    EXPECT_NEAR(refinement_uncertainty(fit, 0.25, fit.at(0.25) + 0.3) -
                    refinement_uncertainty(fit, 0.25, fit.at(0.25)),
                0.3, 1e-6);
}

TEST(RefinementFit, DoesNotDependOnTheOrderOfTheData) {
    std::vector<GridValue> values = power_law(5.0, 0.8, 1.3, {1, 0.7, 0.5, 0.35});
    const RefinementFit one = fit_refinement(values);
    std::swap(values[0], values[3]);
    EXPECT_NEAR(fit_refinement(values).value, one.value, 1e-9);
}

// ---- Verdicts

TEST(Verdict, ConvergedWhenOneRunIsWithinTheTarget) {
    const auto ladder = rungs({0.90, 0.95, 0.975, 0.9875, 0.99375}, 0.001);
    const Convergence found = judge_convergence(ladder, 0.05);
    EXPECT_EQ(found.verdict, Verdict::converged);
    EXPECT_LE(found.uncertainty, 0.05);
    EXPECT_EQ(judge_convergence(ladder, 0.001).verdict, Verdict::refining);
}

TEST(Verdict, FloorReachedWhenTheLatticesScatterMoreThanRefinementChanges) {
    const Convergence found = judge_convergence(rungs({1.00, 1.003, 0.999, 1.001}, 0.02), 0.01);
    EXPECT_EQ(found.verdict, Verdict::floor_reached);
    EXPECT_GE(found.uncertainty, 0.04) << "two standard deviations of one lattice at least";
}

TEST(Verdict, OscillatingWhenItGoesToAndFroBeyondTheScatter) {
    EXPECT_EQ(judge_convergence(rungs({1.0, 1.2, 0.9, 1.15}, 0.01), 0.01).verdict, Verdict::oscillating);
}

TEST(Verdict, NotConvergingWhenChangesGrow) {
    EXPECT_EQ(judge_convergence(rungs({1.0, 1.05, 1.12, 1.22}, 0.005), 0.01).verdict,
              Verdict::not_converging);
}

TEST(Verdict, TwoRungsSayNothing) {
    const Convergence found = judge_convergence(rungs({1.0, 1.1}, 0.01), 1.0);
    EXPECT_EQ(found.verdict, Verdict::too_few_rungs);
    EXPECT_TRUE(std::isnan(found.uncertainty));
    EXPECT_TRUE(std::isnan(error_bar(found, 0.1)));
    EXPECT_EQ(judge_convergence({}, 1.0).verdict, Verdict::too_few_rungs);
}

TEST(Verdict, EachHasItsOwnWords) {
    for (const Verdict verdict : {Verdict::converged, Verdict::floor_reached, Verdict::oscillating,
                                  Verdict::not_converging, Verdict::refining, Verdict::too_few_rungs}) {
        EXPECT_NE(to_string(verdict), "unknown");
        EXPECT_FALSE(meaning(verdict).empty());
    }
}

// ---- Error bars

TEST(ErrorBar, HoldsTheLimitOfAPowerLawAtEverySpacing) {
    const auto ladder = rungs({0.80, 0.86, 0.90, 0.93, 0.95}, 0.0);
    const Convergence found = judge_convergence(ladder, 0.01);
    for (const RungValue& rung : ladder)
        EXPECT_GE(error_bar(found, rung.spacing), std::abs(rung.mean - found.fit->value));
}

TEST(ErrorBar, IsNeverSmallerForACoarserRun) {
    const Convergence found = judge_convergence(rungs({1.3, 0.9, 0.98, 1.0, 1.01}, 0.005), 0.01);
    double before = 0;
    for (double spacing = 0.1; spacing <= 1.0; spacing *= 1.1) {
        const double bar = error_bar(found, spacing);
        EXPECT_GE(bar, before * (1 - 1e-9));
        before = bar;
    }
}

TEST(ErrorBar, OnAPlateauIsTheScatterAndTheRangeOfTheRungs) {
    // Far off at first, then the same within chance: the coarse rungs must not make the fine ones doubtful.
    const auto ladder = rungs({5, 8, 10.1, 10, 10.1}, 0.1);
    const Convergence c = judge_convergence(ladder, 0.01);
    EXPECT_EQ(c.verdict, Verdict::floor_reached);
    EXPECT_NEAR(c.uncertainty, std::hypot(0.1, 0.2), 1e-12);
    EXPECT_GT(error_bar(c, ladder.front().spacing), 5);
}

TEST(ErrorBar, ScatterIsThatOfTheLatticesNearby) {
    auto ladder = rungs({10, 10, 10, 10, 10, 10}, 0.1);
    for (std::size_t k = 0; k < 3; ++k) ladder[k].scatter = 1;
    const Convergence c = judge_convergence(ladder, 0.01);
    EXPECT_NEAR(c.scatter, 0.1, 1e-12);
    EXPECT_NEAR(c.uncertainty, 0.2, 1e-12);
    EXPECT_NEAR(error_bar(c, ladder[0].spacing), 2, 1e-12);
}

TEST(ErrorBar, ScatterIsTheGreatestOfTheRungsNearby) {
    auto ladder = rungs({10, 10, 10, 10, 10, 10}, 0.1);
    ladder[1].scatter = 0.3;
    const Convergence c = judge_convergence(ladder, 0.01);
    EXPECT_NEAR(error_bar(c, ladder[2].spacing), 0.6, 1e-12);
    EXPECT_NEAR(error_bar(c, ladder[3].spacing), 0.2, 1e-12);
}

TEST(ErrorBar, WithoutAnOrderIsThatOfFirstOrderOverAnOctave) {
    // To and fro by more than the scatter, so neither plateau nor order.
    const auto ladder = rungs({9, 10.2, 9.6, 10.1, 9.8, 10}, 0.01);
    const Convergence c = judge_convergence(ladder, 0.001);
    ASSERT_FALSE(c.fit->believed);
    // The rung twice as coarse as the finest is 10.1 at spacing 1/sqrt(2)^3.
    EXPECT_NEAR(c.uncertainty, std::hypot(1.25 * 0.1, 0.02), 1e-9);
    EXPECT_GT(error_bar(c, ladder[0].spacing), 1);
    EXPECT_LT(error_bar(c, ladder[0].spacing), 1.5);
}

}  // namespace
}  // namespace runout
