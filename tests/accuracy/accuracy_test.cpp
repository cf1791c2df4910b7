// Targets, costs, ladders and the choice of a spacing.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "accuracy/cost_model.h"
#include "accuracy/ladder.h"
#include "accuracy/methods.h"
#include "accuracy/plan.h"
#include "accuracy/price.h"
#include "accuracy/study.h"
#include "accuracy/survey.h"
#include "accuracy/survey_error.h"
#include "core/machine.h"
#include "run/run_scene.h"
#include "scene/case_file.h"
#include "scenes.h"
#include "store_fixture.h"

namespace runout {
namespace {

const InputPlace place{.file = "case.toml", .line = 7, .key = "run.accuracy", .value = "?"};

// ---- targets

TEST(AccuracyTarget, ReadsSharesAndLengths) {
    EXPECT_DOUBLE_EQ(accuracy_target("5%", place).share, 0.05);
    EXPECT_DOUBLE_EQ(accuracy_target("2.5 %", place).share, 0.025);
    EXPECT_DOUBLE_EQ(accuracy_target("0.25m", place).metres, 0.25);
    EXPECT_DOUBLE_EQ(accuracy_target("0.25 m", place).metres, 0.25);
    EXPECT_EQ(accuracy_target("5%", place).text(), "5 %");
    EXPECT_EQ(accuracy_target(accuracy_target("0.5 m", place).text(), place).metres, 0.5);
}

TEST(AccuracyTarget, RefusesWhatIsNeither) {
    for (const char* text : {"", "five", "5", "5 mm", "0%", "-1%", "100%", "nan%", "inf m", "0 m", "5 % m"})
        EXPECT_TRUE(contains(input_error([&] { accuracy_target(text, place); }), "case.toml, line 7"))
            << text;
    EXPECT_TRUE(contains(input_error([] { accuracy_target("5", place); }), "has no unit"));
}

TEST(AccuracyTarget, AShareIsOfTheSizeWhereNothingRunsOut) {
    const AccuracyTarget share{0.1, 0};
    EXPECT_DOUBLE_EQ(share.metres_of(20, 6), 2.0);
    EXPECT_DOUBLE_EQ(share.metres_of(0, 6), 0.6);
    EXPECT_DOUBLE_EQ((AccuracyTarget{0, 0.3}).metres_of(20, 6), 0.3);
}

// ---- cost

CostSample run_of(double resolution, double steps, double iterations_per_step, const CostModel& model) {
    CostSample sample{resolution, resolution * resolution, steps, steps * iterations_per_step, 0, 0};
    sample.cpu_s = model.cpu_seconds(sample);
    return sample;
}

TEST(CostModel, FindsTheCoefficientsThatMadeTheData) {
    const CostModel truth{2e-5, 3e-7, 4e-8};
    std::vector<CostSample> samples;
    for (const double resolution : {8, 11, 16, 23, 32, 45})
        for (const double iterations : {4, 6, 9})
            samples.push_back(run_of(resolution, 30 * resolution, iterations, truth));
    const CostModel found = fit_cost_model(samples);
    EXPECT_NEAR(found.per_step_s, truth.per_step_s, 1e-9);
    EXPECT_NEAR(found.per_particle_step_s, truth.per_particle_step_s, 1e-11);
    EXPECT_NEAR(found.per_particle_iteration_s, truth.per_particle_iteration_s, 1e-12);
}

TEST(CostModel, HasNoNegativeCost) {
    // Cheaper with more iterations: the honest coefficient is zero.
    const std::vector<CostSample> samples = {
        {8, 64, 100, 400, 1.0, 0}, {8, 64, 100, 900, 0.9, 0}, {11, 128, 140, 700, 2.5, 0}};
    const CostModel found = fit_cost_model(samples);
    EXPECT_GE(found.per_step_s, 0);
    EXPECT_GE(found.per_particle_step_s, 0);
    EXPECT_GE(found.per_particle_iteration_s, 0);
    EXPECT_THROW(fit_cost_model({}), std::invalid_argument);
}

TEST(CostModel, ForetellsAFinerRunAndScalesToTheMachine) {
    const CostModel model{0, 1e-6, 0};
    std::vector<CostSample> samples;
    for (const double resolution : {8.0, 16.0}) {
        samples.push_back(run_of(resolution, 50 * resolution, 5, model));
        samples.back().cpu_s *= 3;  // a machine that is three times slower
    }
    const CostSample expected = expected_cost(samples, model, 32);
    EXPECT_NEAR(expected.particles, 1024, 1e-6);
    EXPECT_NEAR(expected.steps, 1600, 1e-6);
    EXPECT_NEAR(expected.cpu_s, 3 * 1e-6 * 1600 * 1024, 1e-9);
    EXPECT_THROW(expected_counts({}, 10), std::invalid_argument);
}

TEST(Machine, IsNamed) {
    EXPECT_TRUE(contains(machine_description(), "threads"));
    EXPECT_GE(available_memory_mb(), 0);
}

// ---- the survey that comes with the program

TEST(Survey, TheShippedOneIsWhole) {
    const std::vector<SurveyedScene>& survey = shipped_survey();
    ASSERT_GE(survey.size(), 3u);
    for (const SurveyedScene& scene : survey) {
        ASSERT_GE(scene.rungs.size(), 3u) << scene.name;
        for (std::size_t i = 0; i < scene.rungs.size(); ++i) {
            EXPECT_GE(scene.rungs[i].results, 2) << scene.name;
            EXPECT_GT(scene.rungs[i].cost.cpu_s, 0) << scene.name;
            if (i == 0) continue;
            EXPECT_GT(scene.rungs[i].resolution, scene.rungs[i - 1].resolution) << scene.name;
        }
    }
    EXPECT_EQ(without(survey, survey.front().name).size(), survey.size() - 1);
}

/// Results of the engine that differ from those that the bars were learned from make the bars worth nothing.
TEST(Survey, IsOfTheEngineAsItIs) {
    const Scene scene = make_scene(read_case(RUNOUT_SOURCE_DIR "/cases/box-70/case.toml"));
    const auto surveyed = std::ranges::find(shipped_survey(), "box-70", &SurveyedScene::name);
    ASSERT_NE(surveyed, shipped_survey().end());
    for (const RungSummary& rung : {surveyed->rungs[0], surveyed->rungs[1]}) {
        double sum = 0;
        for (int lattice = 0; lattice < rung.results; ++lattice)
            sum += run_scene(with_resolution(scene, rung.resolution, lattice)).measures.run_out_m;
        EXPECT_NEAR(sum / rung.results, rung.values[0].mean, 1e-5 * rung.values[0].mean)
            << "results have changed: make src/accuracy/ladders.csv anew, as its head says";
    }
}

TEST(Survey, RefusesWhatIsNotOne) {
    EXPECT_TRUE(
        contains(input_error([] { parse_survey("scene,lattices\na,b\n", "x.csv"); }), "x.csv, line 2"));
    EXPECT_TRUE(parse_survey("# nothing\n", "x.csv").empty());
}

TEST(SurveyError, FallsWithTheSpacingAndGrowsWithTheUnrest) {
    const SurveyError error(shipped_survey());
    EXPECT_LT(error.usual_unrest(), error.high_unrest());
    double before = 10;
    for (double resolution = 8; resolution <= 256; resolution *= 1.2) {
        const double here = error.run_out_share(resolution, error.usual_unrest());
        EXPECT_GT(here, 0);
        EXPECT_LE(here, before * (1 + 1e-12));
        EXPECT_LT(here, error.run_out_share(resolution, error.high_unrest()));
        before = here;
    }
}

/// How many of a scene's runs with this spacing lie within the bar that the other scenes give it, out of
/// three whose mean and scatter are those of the rung.
int runs_within(const SurveyedScene& scene, const RungSummary& rung) {
    const SurveyError others(without(shipped_survey(), scene.name));
    const RungSummary& finest = scene.rungs.back();
    const double scale = std::max(finest.values[0].mean, finest.spacing_m * finest.resolution);
    const double bar = scale * others.run_out_share(rung.resolution, unrest_of(scene));
    const double off = rung.values[0].mean - finest.values[0].mean;
    int within = 0;
    for (const double lattice : {-1.0, 0.0, 1.0})
        within += std::abs(off + lattice * rung.values[0].scatter) <= bar ? 1 : 0;
    return within;
}

TEST(SurveyError, BarsHoldOnEachSceneThatWasLeftOut) {
    ASSERT_GE(shipped_survey().size(), 30u);
    int within = 0, runs = 0;
    for (const SurveyedScene& scene : shipped_survey()) {
        for (const RungSummary& rung : scene.rungs) {
            if (rung.resolution == scene.rungs.back().resolution) continue;
            within += runs_within(scene, rung);
            runs += 3;
        }
    }
    RecordProperty("coverage", std::to_string(static_cast<double>(within) / runs));
    EXPECT_GE(within, 0.92 * runs) << within << " of " << runs;
}

/// A ladder of three rungs whose run-out has the given means, m, and scatters by one hundredth of a metre.
SurveyedScene three_rungs(const std::string& name, const std::array<double, 3>& means) {
    SurveyedScene scene{name, {}};
    for (std::size_t k = 0; k < means.size(); ++k) {
        RungSummary rung;
        rung.resolution = rung_resolution(static_cast<int>(2 * k));
        rung.spacing_m = 0.1 / rung.resolution;
        rung.results = 8;
        for (RungValue& value : rung.values) value = {rung.spacing_m, means[k], 0.01, 8};
        scene.rungs.push_back(rung);
    }
    return scene;
}

/// Of a survey that knows nothing but this scene.
double own_share(const SurveyedScene& scene, double resolution) {
    return SurveyError({scene}).run_out_share(resolution, unrest_of(scene));
}

// The finest run is not the limit: while refinement still changes the run-out, more of it would too.
TEST(SurveyError, TheFinestRungMayBeOffItself) {
    const double finest = rung_resolution(4);
    EXPECT_NEAR(own_share(three_rungs("still", {1.0, 1.0, 1.0}), finest), 0.02, 1e-12);
    const SurveyedScene rising = three_rungs("rising", {0.8, 0.9, 1.0});
    EXPECT_GT(own_share(rising, finest), 0.1);
    EXPECT_GT(own_share(rising, rung_resolution(2)), own_share(rising, finest));
}

TEST(SurveyError, NothingIsGainedBeyondTheFinestRung) {
    const SurveyedScene rising = three_rungs("rising", {0.8, 0.9, 1.0});
    EXPECT_EQ(own_share(rising, 1e9), own_share(rising, rung_resolution(4)));
}

TEST(SurveyError, UnrestIsChangeAndScatterOfTheTwoCoarsestRungs) {
    EXPECT_NEAR(unrest_of(three_rungs("still", {1.0, 1.0, 1.0})), std::hypot(0.01, 0.01), 1e-12);
    EXPECT_NEAR(unrest_of(three_rungs("rising", {0.8, 0.9, 1.0})), std::hypot(0.1, 0.01, 0.01), 1e-12);
}

// Of eight scenes it is the worst; nine leave one out.
TEST(SurveyError, IsWhatEightScenesInTenStayWithin) {
    std::vector<SurveyedScene> scenes;
    for (int k = 0; k < 8; ++k) scenes.push_back(three_rungs("same", {0.9, 1.0, 1.0}));
    const double all_alike = SurveyError(scenes).run_out_share(8, 0.1);
    for (RungValue& value : scenes[0].rungs.back().values) value.scatter = 0.2;
    EXPECT_GT(SurveyError(scenes).run_out_share(8, 0.1), 2 * all_alike);
    scenes.push_back(scenes[1]);
    EXPECT_EQ(SurveyError(scenes).run_out_share(8, 0.1), all_alike);
}

TEST(SurveyError, RefusesASurveyThatTellsNothing) {
    EXPECT_THROW(SurveyError({}), std::invalid_argument);
    SurveyedScene two = three_rungs("two", {0.8, 0.9, 1.0});
    two.rungs.pop_back();
    EXPECT_THROW(SurveyError({two}), std::invalid_argument);
}

// ---- ladders and plans on a small scene

Scene small_column() {
    Scene scene = scenes::aluminium_column(21.9, 0);
    scene.name = "column";
    scene.run.particle_spacing = 0;
    return scene;
}

class LadderTest : public StoreTest {
  protected:
    static LadderOptions two_rungs() {
        LadderOptions options;
        options.lattices = 2;
        options.target = {0.001, 0};
        return options;
    }
};

TEST(Rungs, HaveTwiceTheParticlesOfTheOneBefore) {
    EXPECT_EQ(rung_resolution(0), 8);
    EXPECT_EQ(rung_resolution(1), 11);
    EXPECT_EQ(rung_resolution(2), 16);
    EXPECT_EQ(rung_resolution(3), 23);
    EXPECT_EQ(rung_resolution(5), 45);
}

TEST(Question, IsTheSameForEverySpacingAndLattice) {
    const Scene scene = small_column();
    EXPECT_EQ(question_hash(scene), question_hash(with_resolution(scene, 23, 4)));
    Scene other = scene;
    other.material.friction_angle += 0.01;
    EXPECT_NE(question_hash(scene), question_hash(other));
    other = scene;
    other.run.courant = 0.1;
    EXPECT_NE(question_hash(scene), question_hash(other));
}

/// One of those that ladders have, at any fineness: no spacing between two of them is offered.
bool is_rung(double resolution) {
    int index = 0;
    while (rung_resolution(index) < resolution) ++index;
    return rung_resolution(index) == resolution;
}

TEST_F(LadderTest, ClimbsStoresAndRepeatsNothing) {
    Store store(path, Store::Mode::write);
    LadderOptions options = two_rungs();
    options.budget_s = 600;
    int told = 0;
    options.on_rung = [&](const RungSummary& rung) {
        EXPECT_EQ(rung.resolution, rung_resolution(told++));
        EXPECT_EQ(rung.results, 2);
        EXPECT_GT(rung.cost.cpu_s, 0);
    };
    std::atomic<bool> stop = false;
    options.interrupt = &stop;
    const auto watch = options.on_rung;
    options.on_rung = [&](const RungSummary& rung) {
        watch(rung);
        if (told == 3) stop = true;
    };
    const Ladder ladder = climb(small_column(), store, options);
    ASSERT_EQ(ladder.rungs.size(), 3u);
    EXPECT_EQ(store.runs().size(), 6u);
    EXPECT_TRUE(ladder.convergence[0].fit);
    EXPECT_EQ(ladder.ended, "it was stopped");
    ASSERT_FALSE(price_list(ladder).empty());
    for (const Price& price : price_list(ladder)) EXPECT_TRUE(is_rung(price.resolution)) << price.resolution;

    stop = false;
    told = 0;
    climb(small_column(), store, options);
    EXPECT_EQ(store.runs().size(), 6u) << "the same runs again";

    store.add(describe_ladder(small_column(), ladder));
    const auto found = store.find_ladder(question_hash(small_column()));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->runs.size(), 6u);
    EXPECT_EQ(found->verdicts.size(), ladder_quantities.size());
    const Ladder again = read_ladder(*found, store);
    ASSERT_EQ(again.rungs.size(), ladder.rungs.size());
    EXPECT_EQ(again.rungs[1].values[0].mean, ladder.rungs[1].values[0].mean);
    EXPECT_EQ(again.convergence[0].uncertainty, ladder.convergence[0].uncertainty);
    EXPECT_EQ(read_studies(store).size(), 1u);
}

TEST_F(LadderTest, EndsWhereTheBudgetEnds) {
    Store store(path, Store::Mode::write);
    LadderOptions options = two_rungs();
    options.budget_s = 1e-3;  // the first rung alone takes longer
    const Ladder ladder = climb(small_column(), store, options);
    EXPECT_EQ(ladder.rungs.size(), 1u);
    EXPECT_TRUE(contains(ladder.ended, "beyond the budget")) << ladder.ended;
    EXPECT_FALSE(price_of(ladder, {0.05, 0})) << "one rung has no error bar";
}

TEST_F(LadderTest, ARungWhoseRunsFailSaysWhy) {
    Store store(path, Store::Mode::write);
    Scene scene = small_column();
    scene.run.time_limit = 0.01;
    LadderOptions options = two_rungs();
    options.budget_s = 1e-3;
    const Ladder ladder = climb(scene, store, options);
    ASSERT_EQ(ladder.rungs.size(), 1u);
    EXPECT_EQ(ladder.rungs[0].results, 0);
    EXPECT_EQ(ladder.rungs[0].failed, 2);
    EXPECT_TRUE(contains(ladder.rungs[0].failure, "time_limit"));
}

TEST(Plan, ChoosesACoarserRunForACoarserTarget) {
    PlanOptions options;
    options.target = AccuracyTarget{0.3, 0};
    const RunPlan coarse = plan_run(small_column(), options);
    options.target = AccuracyTarget{0.04, 0};
    const RunPlan fine = plan_run(small_column(), options);
    EXPECT_LT(coarse.scene.run.resolution, fine.scene.run.resolution);
    EXPECT_GT(coarse.appraisal.run_out_error_m, fine.appraisal.run_out_error_m);
    EXPECT_EQ(fine.appraisal.error_origin, "pilot");
    EXPECT_EQ(fine.appraisal.accuracy_asked, "4 %");
    EXPECT_GT(fine.appraisal.expected_cpu_s, 0);
    EXPECT_FALSE(fine.pilots.empty());
    EXPECT_FALSE(fine.reason.empty());
}

TEST(Plan, KeepsASpacingThatIsGivenAndAppraisesIt) {
    const Scene scene = with_resolution(small_column(), 32, 0);
    const RunPlan plan = plan_run(scene, {});
    EXPECT_EQ(plan.scene.run.resolution, 32);
    EXPECT_EQ(plan.appraisal.error_origin, "pilot");
    EXPECT_GT(plan.appraisal.run_out_error_m, 0);
    EXPECT_EQ(plan.appraisal.accuracy_asked, "");
    PlanOptions silent;
    silent.pilots = false;
    const RunPlan bare = plan_run(scene, silent);
    EXPECT_EQ(bare.appraisal.error_origin, "none");
    EXPECT_TRUE(std::isnan(bare.appraisal.run_out_error_m));
    EXPECT_TRUE(bare.pilots.empty());
}

TEST(Plan, MakesNoPilotsBesideARunAsCoarseAsThey) {
    const RunPlan plan = plan_run(with_resolution(small_column(), 10, 0), {});
    EXPECT_TRUE(plan.pilots.empty());
    EXPECT_EQ(plan.appraisal.error_origin, "none");
    EXPECT_FALSE(plan.appraisal.error_note.empty());
}

TEST(Plan, RefusesATargetThatCannotBeMetAndNamesTheBest) {
    PlanOptions options;
    options.target = AccuracyTarget{1e-6, 0};
    options.asked = place;
    const std::string sentence = input_error([&] { plan_run(small_column(), options); });
    EXPECT_TRUE(contains(sentence, "case.toml, line 7")) << sentence;
    EXPECT_TRUE(contains(sentence, "cannot be met")) << sentence;
    EXPECT_TRUE(contains(sentence, "% (")) << sentence;
    EXPECT_TRUE(contains(sentence, "CPU time")) << sentence;
    options.asked.reset();
    const RunPlan plan = plan_run(small_column(), options);
    EXPECT_TRUE(contains(plan.reason, "comes nearest to")) << plan.reason;
}

TEST(Plan, StaysWithinItsBudget) {
    PlanOptions options;
    options.target = AccuracyTarget{0.001, 0};
    options.longest_run_s = 0.5;
    const RunPlan plan = plan_run(small_column(), options);
    EXPECT_LE(plan.appraisal.expected_cpu_s, 0.5);
    EXPECT_TRUE(contains(plan.reason, "longer than")) << plan.reason;
}

TEST(Plan, SaysSoWhereThePilotsHaveNoResult) {
    Scene scene = small_column();
    scene.run.time_limit = 0.01;
    PlanOptions options;
    options.target = AccuracyTarget{0.1, 0};
    const RunPlan plan = plan_run(scene, options);
    EXPECT_EQ(plan.appraisal.error_origin, "none");
    EXPECT_TRUE(contains(plan.appraisal.error_note, "did not end as results")) << plan.appraisal.error_note;
    EXPECT_GT(plan.scene.run.resolution, 8);
}

TEST(Methods, TurnEachKnobAwayFromTheDefault) {
    const RunSettings fresh;
    std::set<std::string> series;
    for (const MethodSetting& setting : method_settings(16)) {
        RunSettings run;
        setting.apply(run);
        series.insert(setting.series);
        const bool turned = run.courant != fresh.courant ||
                            run.friction_iterations != fresh.friction_iterations ||
                            run.pressure_tolerance != fresh.pressure_tolerance ||
                            run.smoothing_ratio != fresh.smoothing_ratio || run.friction != fresh.friction ||
                            run.threads != fresh.threads;
        EXPECT_TRUE(turned) << setting.series << " " << setting.setting;
    }
    EXPECT_EQ(series.size(), 6u);
}

}  // namespace
}  // namespace runout
