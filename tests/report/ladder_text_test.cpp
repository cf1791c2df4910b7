// What is printed and drawn of ladders.

#include "report/text/ladder_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "accuracy/study.h"
#include "report/chart/svg_chart.h"
#include "report/page/accuracy_page.h"

namespace runout {
namespace {

using Json = nlohmann::json;

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

RungSummary rung(double resolution, double run_out, double scatter) {
    RungSummary r;
    r.resolution = resolution;
    r.spacing_m = 1.0 / resolution;
    r.results = 3;
    r.cost = {resolution,       resolution * resolution,        40 * resolution,
              200 * resolution, 1e-5 * std::pow(resolution, 3), 40};
    r.wall_s = r.cost.cpu_s;
    for (std::size_t q = 0; q < r.values.size(); ++q)
        r.values[q] = {r.spacing_m, q == 0 ? run_out : 30.0 + run_out, scatter, 3};
    return r;
}

Ladder example_ladder() {
    Ladder ladder;
    ladder.target = {0.05, 0};
    ladder.ended = "the target is met";
    ladder.rungs = {rung(8, 1.80, 0.02), rung(11, 1.85, 0.02), rung(16, 1.90, 0.01), rung(23, 1.93, 0.01)};
    for (std::size_t q = 0; q < ladder_quantities.size(); ++q) {
        std::vector<RungValue> values;
        for (const RungSummary& r : ladder.rungs) values.push_back(r.values[q]);
        ladder.convergence[q] = judge_convergence(values, 0.1);
    }
    return ladder;
}

std::vector<MethodPoint> example_points() {
    return {{"spacing", "8", 8, 0.01, 0.01, 1.80, 0.07, ""},
            {"spacing", "16", 16, 0.04, 0.04, 1.90, 0.02, ""},
            {"spacing", "23", 23, 0.12, 0.12, 1.93, 0.005, ""},
            {"run.courant", "0.05", 16, 0.08, 0.08, 1.90, 0.018, ""},
            {"run.courant", "0.4", 16, 0.01, 0.01, 0, std::numeric_limits<double>::quiet_NaN(),
             "diverged: too dense"}};
}

TEST(LadderText, PrintsARungAsItEnds) {
    const RungSummary before = rung(11, 1.85, 0.02);
    const std::string line = rung_table_line(rung(16, 1.90, 0.01), &before);
    for (const char* part : {"16", "0.0625", "256", "640", "5.0", "1.9 +-0.01", "+2.6 %"})
        EXPECT_TRUE(has(line, part)) << part << " in " << line;
    RungSummary failed = rung(16, 1, 0);
    failed.results = 0;
    failed.failure = "diverged: too dense";
    EXPECT_TRUE(has(rung_table_line(failed, &before), "failed: diverged: too dense"));
    EXPECT_EQ(rung_table_head().find('\n') + 1, rung_table_head().size() / 2)
        << "titles and units are as wide";
}

TEST(LadderText, SumsUpWhatTheLadderSaysAndCosts) {
    const Ladder ladder = example_ladder();
    const std::vector<Price> prices = price_list(ladder);
    ASSERT_EQ(prices.size(), 4u);
    const std::string text = ladder_summary(ladder, prices);
    for (const char* part : {"The ladder ended because the target is met.", "run-out, m: ",
                             "Richardson value", "GCI", "least squares", "10 % costs", "95 %"})
        EXPECT_TRUE(has(text, part)) << part << " in\n" << text;
    EXPECT_FALSE(has(text, "nan")) << text;
}

TEST(LadderText, PricesRiseWithTheAccuracy) {
    const std::vector<Price> prices = price_list(example_ladder());
    for (std::size_t i = 1; i < prices.size(); ++i) {
        EXPECT_LE(prices[i].error_m, prices[i - 1].error_m);
        EXPECT_GE(prices[i].cost.cpu_s, prices[i - 1].cost.cpu_s);
    }
    EXPECT_TRUE(prices[0].met);
    EXPECT_FALSE(prices[3].met) << "1 % lies below two standard deviations of a lattice";
}

TEST(LadderText, JsonHoldsEveryNumber) {
    const Ladder ladder = example_ladder();
    const Json json = Json::parse(ladder_json("cut", ladder, price_list(ladder), example_points()));
    EXPECT_EQ(json.at("name"), "cut");
    EXPECT_EQ(json.at("rungs").size(), 4u);
    EXPECT_EQ(json.at("rungs")[1].at("resolution"), 11);
    EXPECT_EQ(json.at("rungs")[1].at("run_out_m"), 1.85);
    EXPECT_EQ(json.at("quantities").size(), 3u);
    EXPECT_EQ(json.at("prices").size(), 4u);
    EXPECT_EQ(json.at("methods").size(), 5u);
    EXPECT_TRUE(json.at("methods")[4].at("error_share").is_null());
    EXPECT_EQ(json.at("methods")[4].at("failure"), "diverged: too dense");
}

TEST(WorkPrecision, OneLineForEachKnobThroughTheOwnSetting) {
    const Figure figure = work_precision_figure("cut", "title", example_points());
    EXPECT_TRUE(figure.logarithmic_x && figure.logarithmic_y);
    ASSERT_EQ(figure.curves.size(), 2u);
    EXPECT_EQ(figure.curves[0].label, "spacing");
    EXPECT_EQ(figure.curves[0].points.size(), 2u) << "without the finest, which is the reference";
    ASSERT_EQ(figure.curves[1].points.size(), 2u)
        << "its own point and that of the ladder; none for a failure";
    EXPECT_DOUBLE_EQ(figure.curves[1].points[0].x(), 0.04);
    EXPECT_DOUBLE_EQ(figure.curves[1].points[1].y(), 1.8);
    EXPECT_TRUE(has(svg_chart(figure), "run.courant"));
}

AccuracyStudy example_study() {
    AccuracyStudy study;
    study.name = "cut";
    study.machine = "a processor, 2 threads";
    study.ladder = example_ladder();
    study.prices = price_list(study.ladder);
    study.points = example_points();
    ChoiceCheck check{"5 %", {}, 16, 0.02, true};
    check.run.status = RunStatus::settled;
    check.run.work.cpu_s = 0.05;
    check.run.appraisal.run_out_error_m = 0.09;
    check.run.appraisal.error_origin = "pilot";
    check.run.appraisal.expected_cpu_s = 0.04;
    check.run.appraisal.choosing_cpu_s = 0.01;
    study.choices = {check};
    return study;
}

TEST(AccuracyPage, TellsPricesPromisesAndFailures) {
    const AccuracyStudy study = example_study();
    const std::string page = accuracy_page(std::vector<AccuracyStudy>{study}, "accuracy");
    for (const char* part :
         {"# What accuracy costs in time", "a processor, 2 threads", "| cut |", "(accuracy/cut.svg)",
          "in 1 of 1 runs", "run.courant = 0.4: diverged: too dense", "| 16 |"})
        EXPECT_TRUE(has(page, part)) << part;
    EXPECT_FALSE(has(page, "nan"));
}

TEST(Durations, AreForPeople) {
    EXPECT_EQ(short_duration(0.0512), "0.051 s");
    EXPECT_EQ(short_duration(12.3), "12 s");
    EXPECT_EQ(short_duration(600), "10 min");
    EXPECT_EQ(short_duration(7200), "2 h");
}

}  // namespace
}  // namespace runout
