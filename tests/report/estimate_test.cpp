// Run-out estimates from stored runs: the surface, its errors, and where it is refused.

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "estimate/convex_hull.h"
#include "report/text/estimate_text.h"
#include "scene/effect_settings.h"
#include "store_fixture.h"

namespace runout {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// ---- the hull

MatrixXd simplex() {
    MatrixXd corners(4, 3);
    corners << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    return corners;
}

TEST(ConvexHull, OfASimplexIsKnownExactly) {
    const auto inside = [](double x, double y, double z) {
        return in_convex_hull(simplex(), Eigen::Vector3d(x, y, z), 1e-9);
    };
    EXPECT_TRUE(inside(0.2, 0.3, 0.4));
    EXPECT_TRUE(inside(0.5, 0.5, 0));
    EXPECT_TRUE(inside(1, 0, 0));
    EXPECT_FALSE(inside(0.5, 0.5, 1e-6));
    EXPECT_FALSE(inside(0.4, 0.4, 0.4)) << "in the box of the corners, beyond their plane";
    EXPECT_FALSE(inside(-1e-6, 0.1, 0.1));
}

TEST(ConvexHull, HoldsEveryMeanOfItsPointsAndNothingBeyondItsFarthest) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    MatrixXd points(500, 4);
    for (double& x : points.reshaped()) x = uniform(random);
    for (int trial = 0; trial < 50; ++trial) {
        VectorXd weights(500);
        for (double& w : weights) w = std::pow(std::abs(uniform(random)), 8);
        const VectorXd mean = points.transpose() * (weights / weights.sum());
        EXPECT_TRUE(in_convex_hull(points, mean, 1e-6)) << trial;
        const VectorXd direction = VectorXd::NullaryExpr(4, [&] { return uniform(random); }).normalized();
        Index farthest = 0;
        const double reach = (points * direction).maxCoeff(&farthest);
        const VectorXd corner = points.row(farthest).transpose();
        EXPECT_TRUE(in_convex_hull(points, corner, 1e-6));
        EXPECT_FALSE(in_convex_hull(points, corner + 1e-4 * direction, 1e-6)) << reach;
    }
}

// ---- the polynomial

SurfaceData sampled(Index count, unsigned seed, const std::function<double(const VectorXd&)>& surface) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    SurfaceData data{MatrixXd(count, 3), VectorXd(count)};
    for (double& x : data.at.reshaped()) x = uniform(random);
    for (Index i = 0; i < count; ++i) data.values[i] = surface(data.at.row(i).transpose());
    return data;
}

double cubic(const VectorXd& x) {
    return 2 + x[0] - 3 * x[1] * x[2] + x[0] * x[0] * x[2] - 0.5 * x[1] * x[1] * x[1];
}

TEST(PolynomialFit, RecoversACubicAndSaysItsDegree) {
    const PolynomialFit fit = best_polynomial(sampled(100, 1, cubic), {3, 3, 3});
    EXPECT_EQ(fit.degree(), 3);
    EXPECT_EQ(fit.terms(), 20);
    for (const VectorXd& place :
         {VectorXd(Eigen::Vector3d(0.1, -0.7, 0.9)), VectorXd(Eigen::Vector3d(1, 1, -1))})
        EXPECT_NEAR(fit.value(place), cubic(place), 1e-11);
    EXPECT_LT(fit.left_out_errors().lpNorm<Eigen::Infinity>(), 1e-11);
}

TEST(PolynomialFit, LeftOutErrorsAreThoseOfFittingWithoutTheDatum) {
    const auto wavy = [](const VectorXd& x) { return std::sin(3 * x[0]) + std::exp(x[1]) * x[2]; };
    const SurfaceData data = sampled(40, 2, wavy);
    const PolynomialFit whole(data, 2, {3, 3, 3});
    for (const Index i : {Index{0}, Index{17}, Index{39}}) {
        std::vector<Index> others;
        for (Index k = 0; k < 40; ++k)
            if (k != i) others.push_back(k);
        const PolynomialFit without({data.at(others, Eigen::all), data.values(others)}, 2, {3, 3, 3});
        EXPECT_NEAR(whole.left_out_errors()[i], data.values[i] - without.value(data.at.row(i).transpose()),
                    1e-10);
        EXPECT_NEAR(whole.leverage(data.at.row(i).transpose()), whole.leverages()[i], 1e-12);
    }
}

TEST(PolynomialFit, LeavesOutWhatTheDataCannotTell) {
    SurfaceData data = sampled(60, 3, [](const VectorXd& x) { return x[0]; });
    data.at.col(2) = data.at.col(1);  // one variable said twice
    data.values = 3 * data.at.col(1) + data.at.col(0);
    const PolynomialFit fit(data, 1, {1, 1, 1});
    EXPECT_EQ(fit.terms(), 3);
    EXPECT_NEAR(fit.value(Eigen::Vector3d(0.5, 0.25, 0.25)), 1.25, 1e-12);
}

TEST(ErrorQuantile, IsTheConformalRank) {
    EXPECT_EQ(error_quantile({-4, 1, 3, -2, 5, 6, 7, 8, 9}, 0.5), 5);  // ceil(0.5 * 10) = fifth
    EXPECT_EQ(error_quantile(std::vector<double>(19, 2.0), 0.95), 2);
    EXPECT_TRUE(std::isinf(error_quantile(std::vector<double>(18, 2.0), 0.95)));
}

// ---- the chart

/// Something like a run-out: rises with the drop at a falling rate, falls with friction.
double law(const ChartPlace& at) {
    return 1 + 1.2 * std::sqrt(at[1]) + 0.8 * at[2] - 0.05 * (at[3] - 30) + 0.01 * (at[0] - 60);
}

ChartPoint point(std::mt19937& random, double noise) {
    std::uniform_real_distribution<double> uniform(0, 1);
    std::normal_distribution<double> normal(0, 1);
    ChartPoint made;
    made.place = {45 + 30 * uniform(random), 0.5 + 5.5 * uniform(random), uniform(random),
                  25 + 15 * uniform(random)};
    made.run_out = law(made.place) + noise * normal(random);
    made.resolution = 12;
    return made;
}

ChartPoints chart_of(int count, unsigned seed, double noise) {
    std::mt19937 random(seed);
    ChartPoints points;
    for (int i = 0; i < count; ++i) {
        points.points.push_back(point(random, noise));
        points.points.back().run_id = i + 1;
    }
    return points;
}

ChartQuestion at(double slope, double drop, double front, double friction) {
    ChartQuestion question;
    question.place = {slope, drop, front, friction};
    return question;
}

TEST(RunOutChart, RecoversASurfaceWithinWhatItSays) {
    const RunOutChart chart(chart_of(200, 1, 0), "x.db");
    const Estimate estimate = chart.estimate(at(60, 3, 0.4, 32));
    EXPECT_NEAR(estimate.run_out, law({60, 3, 0.4, 32}), 0.02);
    EXPECT_LT(std::abs(estimate.run_out - law({60, 3, 0.4, 32})), estimate.half_width_95);
    EXPECT_LT(estimate.half_width_95, 0.1);
}

TEST(RunOutChart, IntervalsHoldTheirShareOfRunsThatItHasNotSeen) {
    int asked = 0, in_68 = 0, in_95 = 0;
    double squares = 0, said = 0;
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const RunOutChart chart(chart_of(150, seed, 0.2), "x.db");
        std::mt19937 random(1000 + seed);
        for (int i = 0; i < 200; ++i) {
            const ChartPoint held_out = point(random, 0.2);
            Estimate estimate;
            try {
                estimate = chart.estimate({held_out.place, "", ChartQuestion::not_given});
            } catch (const InputError&) {
                continue;  // outside
            }
            const double error = std::abs(estimate.run_out - held_out.run_out);
            ++asked;
            in_68 += error <= estimate.half_width_68 ? 1 : 0;
            in_95 += error <= estimate.half_width_95 ? 1 : 0;
            squares += error * error;
            said += chart.left_out_error() * chart.left_out_error();
        }
    }
    ASSERT_GT(asked, 800);
    EXPECT_NEAR(static_cast<double>(in_68) / asked, 0.68, 0.05);
    EXPECT_NEAR(static_cast<double>(in_95) / asked, 0.95, 0.02);
    EXPECT_NEAR(std::sqrt(squares / said), 1, 0.1) << "error at new runs against the cross-validated one";
}

TEST(HeldOutCheck, CountsEveryRunOnceAndFindsTheNoise) {
    const HeldOutCheck check = check_held_out(chart_of(300, 11, 0.2), "x.db");
    EXPECT_EQ(check.estimated + check.refused, 300u);
    EXPECT_GT(check.estimated, 150u);
    EXPECT_NEAR(check.error_rms, 0.2, 0.03);
    EXPECT_NEAR(check.left_out_error_rms, check.error_rms, 0.03);
    EXPECT_LT(check.within_68, check.within_95);
    EXPECT_TRUE(contains(held_out_text(check), "Every fifth run held out"));
    EXPECT_TRUE(contains(input_error([] { (void)check_held_out(chart_of(24, 1, 0.1), "x.db"); }),
                         "x.db: holds 24 settled runs that may be used; holding out runs needs 25"));
}

TEST(RunOutChart, RefusesOutsideTheRunsAndNamesTheVariable) {
    const RunOutChart chart(chart_of(200, 1, 0.1), "x.db");
    const auto no = [&](const ChartQuestion& question) {
        return input_error([&] { (void)chart.estimate(question); });
    };
    EXPECT_EQ(no(at(60, 3, 0.4, 32)), "");
    EXPECT_TRUE(contains(no(at(80, 3, 0.4, 32)), "slope angle = 80: lies outside the runs, which have 45"));
    EXPECT_TRUE(contains(no(at(60, 7, 0.4, 32)), "H_d/sqrt(S) = 7"));
    EXPECT_TRUE(
        contains(no(at(60, 3, 0.4, chart.highest(ChartVariable::friction_angle) + 0.01)), "friction angle"));
    EXPECT_EQ(no(at(60, 3, 0.4, chart.highest(ChartVariable::friction_angle) - 1)), "");
    const std::string corner = no(at(45.5, 0.6, 0.01, 25.2));
    EXPECT_TRUE(contains(corner, "has no runs around slope angle 45.5 deg, H_d/sqrt(S) 0.6"));
    EXPECT_TRUE(contains(corner, "the nearest, run "));
    EXPECT_TRUE(contains(no(at(60, 3, ChartQuestion::not_given, 32)), "S_front/S: is not given, and varies"));
}

TEST(RunOutChart, WhatDoesNotVaryIsNoVariable) {
    ChartPoints points = chart_of(60, 4, 0.1);
    for (ChartPoint& one : points.points) one.place[0] = 60;
    const RunOutChart chart(points, "x.db");
    EXPECT_FALSE(chart.varies(ChartVariable::slope_angle));
    EXPECT_NEAR(chart.estimate(at(ChartQuestion::not_given, 3, 0.4, 32)).place[0], 60, 1e-12);
    EXPECT_EQ(chart.estimate(at(60, 3, 0.4, 32)).run_out, chart.estimate(at(60.001, 3, 0.4, 32)).run_out);
    const std::string sentence = input_error([&] { (void)chart.estimate(at(61, 3, 0.4, 32)); });
    EXPECT_TRUE(contains(sentence, "slope angle = 61: cannot be estimated: all 60 runs have 60 deg"));
}

TEST(RunOutChart, BetweenTheValuesOfAGridTheIntervalIsThatOfLeavingAValueOut) {
    ChartPoints points = chart_of(200, 5, 0.01);
    const auto bent = [](double slope) { return std::abs(slope - 60) / 5; };
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        ChartPoint& one = points.points[i];
        one.place[0] = std::array{45.0, 52.0, 60.0, 68.0, 75.0}[i % 5];
        one.run_out = law(one.place) + bent(one.place[0]);
    }
    const RunOutChart chart(points, "x.db");
    const Estimate on = chart.estimate(at(60, 3, 0.4, 32)), between = chart.estimate(at(64, 3, 0.4, 32));
    EXPECT_TRUE(on.between_values_of.empty());
    ASSERT_EQ(between.between_values_of, std::vector{ChartVariable::slope_angle});
    EXPECT_GT(between.half_width_95, 1.5 * on.half_width_95);
    EXPECT_LT(std::abs(between.run_out - law({64, 3, 0.4, 32}) - bent(64)), between.half_width_95);
    for (ChartPoint& one : points.points) one.place[0] = one.place[0] < 60 ? 45 : 75;
    const RunOutChart two(points, "x.db");
    EXPECT_EQ(input_error([&] { (void)two.estimate(at(45, 3, 0.4, 32)); }), "");
    EXPECT_TRUE(
        contains(input_error([&] { (void)two.estimate(at(50, 3, 0.4, 32)); }),
                 "slope angle = 50: lies between 45 deg and 75 deg, and the runs have no other value"));
}

TEST(RunOutChart, TooFewRunsAreSaid) {
    EXPECT_TRUE(contains(input_error([] { const RunOutChart chart(chart_of(19, 1, 0.1), "x.db"); }),
                         "x.db: holds 19 settled runs that may be used; a chart needs 20"));
    EXPECT_EQ(input_error([] { const RunOutChart chart(chart_of(20, 1, 0.1), "x.db"); }), "");
}

// ---- which runs

ChartRow row(long run_id, const std::string& status = "settled") {
    return {run_id, run_id, 60, 12, 16, 8, 55, 35, 0.5, 10, status, ""};
}

TEST(ChartPoints, AreTheFinestSettledRunsWithTheEffectsOfTheQuestion) {
    std::vector<ChartRow> rows = {row(1), row(2, "stable"), row(3, "diverged"), row(4), row(5), row(6),
                                  row(7)};
    rows[3].effects = "cohesion.cohesion_kpa = 5";
    rows[4].discontinuity_angle_deg = 50;
    rows[5].source_id = rows[6].source_id = 6;
    rows[6].particle_spacing_m = 0.25;
    const ChartPoints found = chart_points(rows, {});
    ASSERT_EQ(found.points.size(), 2u);
    EXPECT_EQ(found.points[0].place, (ChartPlace{60, 3, 0.5, 35}));
    EXPECT_EQ(found.points[0].run_out, 2.5);
    EXPECT_EQ(found.points[1].run_id, 7);
    EXPECT_EQ(found.points[1].resolution, 16);
    EXPECT_EQ(found.standing, 1u);
    EXPECT_EQ(found.without_result, 1u);
    EXPECT_EQ(found.other_effects, 1u);
    EXPECT_EQ(found.other_planes, 1u);
    EXPECT_EQ(found.coarser, 1u);
    ChartQuestion with_cohesion;
    with_cohesion.effects = rows[3].effects;
    EXPECT_EQ(chart_points(rows, with_cohesion).points.at(0).run_id, 4);
}

TEST_F(StoreTest, AStoredRunAsksTheQuestionOfItsScene) {
    Scene scene = example_scene();
    scene.effects.cohesion = Cohesion{};
    scene.effects.cohesion->strength = 5000;
    const long run_id = add(scene, example_result());
    add(example_scene(), example_result());
    const std::vector<ChartRow> rows = Store(path, Store::Mode::read).chart_rows(std::nullopt);
    ASSERT_EQ(rows.size(), 2u);
    const ChartQuestion question = chart_question(scene);
    EXPECT_FALSE(question.effects.empty());
    const ChartPoints found = chart_points(rows, question);
    ASSERT_EQ(found.points.size(), 1u);
    EXPECT_EQ(found.points[0].run_id, run_id);
    for (std::size_t k = 0; k < chart_variables; ++k)
        EXPECT_NEAR(found.points[0].place[k], question.place[k], 1e-9) << k;
}

/// Fills the database with a study of this many runs of `law`, and one run that is not of the study.
void fill(Store& store, int count) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0, 1);
    const long study = store.begin_study("synthetic", "[vary]");
    std::vector<StudyScenario> scenarios;
    for (int i = 0; i < count; ++i) {
        Scene scene = example_scene();
        scene.source.head = {-7, 3 + 15 * uniform(random)};
        scene.source.front_area = scene.source.area * uniform(random);
        scene.material.friction_angle = 0.45 + 0.25 * uniform(random);
        RunResult result = example_result();
        result.measures.run_out_m = law(chart_question(scene).place) * std::sqrt(scene.source.area);
        store.add(scene, result);
        scenarios.push_back({i, scenario_hash(scene), "{}", ""});
    }
    store.set_study_scenarios(study, scenarios);
    store.add(example_scene(), example_result());
}

TEST_F(StoreTest, TwoHundredStoredRunsAnswerWithBoundedWork) {
    Store store(path, Store::Mode::write);
    fill(store, 200);
    const std::vector<ChartRow> rows = store.chart_rows(store.studies().at(0).study_id);
    EXPECT_EQ(rows.size(), 200u);
    EXPECT_EQ(store.chart_rows(std::nullopt).size(), 201u);
    const RunOutChart chart(chart_points(rows, {}), path);
    // Least squares takes runs x terms^2 multiplications, and that for three degrees.
    EXPECT_LE(chart.surface().terms(), 20);
    EXPECT_EQ(chart.varying().size(), 3u);
    const Estimate estimate = chart.estimate(at(ChartQuestion::not_given, 3, 0.5, 33));
    EXPECT_NEAR(estimate.run_out, law({chart.lowest(ChartVariable::slope_angle), 3, 0.5, 33}), 0.02);
    const nlohmann::json json = nlohmann::json::parse(estimate_json(chart, estimate, EstimateScale{16, {}}));
    EXPECT_EQ(json["run_out_m"], estimate.run_out * 4);
    EXPECT_EQ(json["runs"], 200);
    EXPECT_TRUE(contains(estimate_text(chart, estimate, std::nullopt), "From 200 settled runs"));
}

TEST_F(StoreTest, TheChartOfAStudyLooksNothingThrough) {
    add(example_scene(), example_result());
    SQLite::Database database = raw();
    SQLite::Statement plan(database, "EXPLAIN QUERY PLAN " + chart_rows_sql(true));
    while (plan.executeStep()) {
        const std::string step = plan.getColumn(3).getString();
        EXPECT_FALSE(step.starts_with("SCAN ")) << step;
    }
}

}  // namespace
}  // namespace runout
