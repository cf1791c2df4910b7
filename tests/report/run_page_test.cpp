// The report as text: what must stand in it, and that nothing of a user's becomes markup.

#include "report/page/run_page.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <regex>

#include "core/units.h"
#include "report/page/animation_json.h"
#include "report/page/html.h"
#include "report/page/run_page_parts.h"
#include "report/page/section_figure.h"
#include "report/page/study_page.h"
#include "store_fixture.h"

namespace runout {
namespace {

using Json = nlohmann::json;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class RunPageTest : public StoreTest {
  protected:
    RunData stored(const Scene& scene, const RunResult& result) {
        const long run = add(scene, result);  // the file is there only then
        return read_run_data(Store(path, Store::Mode::read), run);
    }
    RunData stored() { return stored(example_scene(), example_result()); }
};

/// The object that the scripts of a page read.
Json data_of(const std::string& page) {
    const std::string mark = "id=\"report-data\">";
    const std::size_t begin = page.find(mark) + mark.size();
    return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST_F(RunPageTest, ShowsEveryMeasureToTheLastBit) {
    const RunData run = stored();
    const std::string page = run_page(run, nan);
    for (const MeasureField& field : measure_fields())
        EXPECT_TRUE(contains(page, fmt::format("data-value=\"{}\"", run.run.measures.*field.value)));
}

TEST_F(RunPageTest, SaysWhereItComesFrom) {
    const RunData run = stored();
    const std::string page = run_page(run, nan);
    for (const std::string& part : {run.run.scenario_hash, run.run.program_version, run.run.program_revision,
                                    run.run.ended_utc, std::string("profiles/cut-60.csv")})
        EXPECT_TRUE(contains(page, part));
}

TEST_F(RunPageTest, NeedsNothingBesideItself) {
    const std::string page = run_page(stored(), nan);
    EXPECT_FALSE(std::regex_search(
        page, std::regex(R"(<(script|link|img|iframe)[^>]*(src|href)="?(https?:|//|[a-z]+\.))")));
    EXPECT_TRUE(contains(page, "Chart.js v3"));
    EXPECT_LT(page.size(), 400'000u);
}

TEST_F(RunPageTest, NamesOfUsersAreTextEverywhere) {
    Scene scene = example_scene();
    scene.name = "</script><script>alert('name')</script>";
    scene.profile.origin = "a \"quoted\" & <b>bold</b> file.csv";
    RunResult result = example_result();
    result.status_detail = "<img src=x onerror=alert(1)>";
    result.status = RunStatus::diverged;
    const std::string page = run_page(stored(scene, result), nan);
    EXPECT_FALSE(contains(page, "<script>alert"));
    EXPECT_FALSE(contains(page, "<b>bold"));
    EXPECT_FALSE(contains(page, "<img"));
    EXPECT_TRUE(contains(page, "&lt;script&gt;alert"));
    EXPECT_NO_THROW(data_of(page));
}

TEST_F(RunPageTest, NamesCannotEndTheDataOfTheScripts) {
    Scene scene = example_scene();
    scene.name = "</script><!--";
    const RunData run = stored(scene, example_result());
    const std::string page = study_page("</script>", {run.run});
    EXPECT_NO_THROW(data_of(page));
    EXPECT_FALSE(contains(page, "</script><!--"));
}

TEST_F(RunPageTest, ARunThatFailedShowsItsStatusAndNoMeasure) {
    RunResult result = example_result();
    result.status = RunStatus::diverged;
    result.status_detail = "density ratio 1.31 at t = 0.2 s";
    const RunData run = stored(example_scene(), result);
    const std::string page = run_page(run, nan);
    EXPECT_TRUE(contains(page, "diverged"));
    EXPECT_TRUE(contains(page, "density ratio 1.31 at t = 0.2 s"));
    EXPECT_TRUE(contains(page, "Last state, not a result"));
    EXPECT_TRUE(contains(page, "not compared with documented landslides"));
    EXPECT_FALSE(contains(page, fmt::format("data-value=\"{}\"", run.run.measures.reach_angle_deg)));
}

TEST_F(RunPageTest, ARunWithoutPicturesSaysSo) {
    RunResult result = example_result();
    result.frames.clear();
    const std::string page = run_page(stored(example_scene(), result), nan);
    EXPECT_TRUE(contains(page, "No pictures of the particles were stored"));
    EXPECT_TRUE(data_of(page).at("animation").is_null());
}

TEST_F(RunPageTest, EffectsAreOnOnlyWhereTheCaseNamesThem) {
    Scene scene = example_scene();
    RunResult result = example_result();
    EXPECT_TRUE(contains(effects_section(stored(scene, result)).body,
                         "base friction</th><td class=\"label\">off</td>"));
    scene.effects.base_friction = BaseFriction{radians(14.5)};
    result.effects = {{"base_friction", true, "the bed slides", 0.25}};
    const std::string on = effects_section(stored(scene, result)).body;
    EXPECT_TRUE(
        contains(on, "base friction</th><td class=\"label\">on</td><td>the bed slides (angle_deg = 14.5)"));
    EXPECT_TRUE(contains(on, "release</th><td class=\"label\">off</td>"));
}

TEST_F(RunPageTest, InputsHaveUnitsAndMeanings) {
    const std::string body = inputs_section(stored()).body;
    EXPECT_TRUE(contains(
        body,
        ">density</th><td class=\"number\" data-value=\"1900\">1900</td><td class=\"label\">kg/m³</td>"));
    EXPECT_TRUE(contains(body, "h / particle spacing"));
}

TEST_F(RunPageTest, WarnsOfWhatAReaderMustKnow) {
    Scene scene = example_scene();
    scene.source.discontinuity_angle = radians(55);
    scene.material.friction_angle = radians(30);
    scene.run.friction = FrictionScheme::explicit_;
    RunResult result = example_result();
    result.work.highest_density_ratio = 1.4;
    const auto warnings = run_warnings(stored(scene, result));
    const auto warned = [&](const std::string& part) {
        return std::ranges::any_of(
            warnings, [&](const std::string& sentence) { return sentence.find(part) != std::string::npos; });
    };
    EXPECT_TRUE(warned("S_front stands above a plane of 55 deg"));
    EXPECT_TRUE(warned("1.4 times as dense"));
    EXPECT_TRUE(warned("explicit"));
    scene.material.friction_angle = radians(38);
    for (const std::string& sentence : run_warnings(stored(scene, result)))
        EXPECT_FALSE(contains(sentence, "S_front"));
}

TEST_F(RunPageTest, TheAnimationHasTheFramesAndNoMoreBytesThanAllowed) {
    RunResult result = example_result();
    result.frames.clear();
    for (int k = 0; k < 100; ++k) {
        Frame frame{{0.1 * k, 0, 1, 0, 1, 0, 1, 0, 1}, {}, {}, {}, {}};
        frame.x.assign(1000, 1);
        frame.y.assign(1000, 2);
        frame.speed.assign(1000, 3);
        frame.pressure.assign(1000, 4);
        result.frames.push_back(frame);
    }
    const RunData run = stored(example_scene(), result);
    EXPECT_EQ(Json::parse(animation_json(run)).at("frames").size(), 100u);
    const std::string small = animation_json(run, 200'000);
    EXPECT_LT(small.size(), 220'000u);
    const Json frames = Json::parse(small).at("frames");
    EXPECT_EQ(frames.front().at("time"), 0.0);
    EXPECT_NEAR(frames.back().at("time").get<double>(), 9.9, 1e-12);
    EXPECT_EQ(frames[0].at("speed").get<std::string>().substr(0, 4), "AwMD");
}

TEST_F(RunPageTest, TheAnimationShowsThePlaces) {
    RunResult result = example_result();
    PlaceRecord house;
    house.name = "house \x1b";
    house.chainage_m = example_scene().profile.toe_chainage_m + 2;
    house.width_m = 3;
    PlaceRecord road = house;
    road.name = "road";
    road.width_m = 0;
    result.places = {house, road};
    const RunData run = stored(example_scene(), result);
    const Json places = Json::parse(animation_json(run)).at("places");
    ASSERT_EQ(places.size(), 2u);
    EXPECT_EQ(places[0].at("name"), "house \\x1b");
    ASSERT_EQ(places[0].at("posts").size(), 4u);
    const double near = run.geometry.profile.to_local({house.chainage_m, 0}).x();
    EXPECT_EQ(places[0].at("posts")[0][0], near);
    EXPECT_EQ(places[0].at("posts")[3][0], near + 3);
    EXPECT_EQ(places[1].at("posts").size(), 2u);
}

TEST_F(RunPageTest, CodesBecomeBase64) {
    RunResult result = example_result();
    result.frames = {{{0, 0, 1, 0, 1, 0, 1, 0, 1}, {0x0201, 0xFFFF}, {0, 0}, {1, 2}, {0, 255}}};
    const Json frame = Json::parse(animation_json(stored(example_scene(), result))).at("frames").at(0);
    EXPECT_EQ(frame.at("x"), "AQL//w==");
    EXPECT_EQ(frame.at("speed"), "AQI=");
}

TEST(SectionFigure, LinesAreCutWhereTheyLeave) {
    const Polyline line = {{0, 0}, {2, 2}, {4, 0}};
    EXPECT_EQ(clipped(line, 1, 3), (Polyline{{1, 1}, {2, 2}, {3, 1}}));
    EXPECT_EQ(clipped(line, -1, 9), line);
    EXPECT_TRUE(clipped(line, 5, 6).empty());
}

TEST(SectionFigure, TheDiscontinuityLineEndsOnTheOutline) {
    SectionGeometry geometry;
    geometry.outline = {{0, 0}, {-2, 0}, {-2, 2}};
    geometry.discontinuity_angle = radians(30);
    const Polyline line = discontinuity_line(geometry);
    ASSERT_EQ(line.size(), 2u);
    EXPECT_NEAR(line[1].x(), -2, 1e-12);
    EXPECT_NEAR(line[1].y(), 2 * std::tan(radians(30)), 1e-12);
    geometry.discontinuity_angle = radians(60);  // steeper than the face: none of the source lies above it
    EXPECT_TRUE(discontinuity_line(geometry).empty());
}

TEST_F(RunPageTest, TheDepositStandsOnItsBedInTheLocalFrame) {
    const RunData run = stored();
    const Polyline surface = deposit_surface(run);
    ASSERT_EQ(surface.size(), 3u);
    EXPECT_NEAR(surface[0].x(), -2, 1e-9);
    EXPECT_NEAR(surface[0].y(), 43.1 + 0.4 - 41.5, 1e-9);
    EXPECT_LT(surface[0].x(), surface[1].x());
}

TEST(Html, ColumnsBecomeWordsAndUnits) {
    const auto words = [](const char* column) {
        const ColumnWords result = column_words(column);
        return result.words + "|" + result.unit;
    };
    EXPECT_EQ(words("run_out_m"), "run-out|m");
    EXPECT_EQ(words("peak_front_speed_m_s"), "peak front speed|m/s");
    EXPECT_EQ(words("gravity_m_s2"), "gravity|m/s²");
    EXPECT_EQ(words("source_area_m2"), "source area|m²");
    EXPECT_EQ(words("density_kg_m3"), "density|kg/m³");
    EXPECT_EQ(words("steps"), "steps|");
}

// ---- what later versions store beside the run

TEST_F(RunPageTest, ShowsErrorBarsAdviceAndPlacesThatAreStored) {
    RunData run = stored();
    EXPECT_EQ(numerical_error_words(run), "not estimated");
    std::erase_if(run.facts,
                  [](const StoredFact& fact) { return fact.column.find("_error") != std::string::npos; });
    std::erase_if(run.facts, [](const StoredFact& fact) { return fact.column == "error_note"; });
    run.facts.push_back({"run", "run_out_error_m", "", 0.42});
    run.facts.push_back({"run", "error_note", "", std::string("from four lattices")});
    run.further = {
        {"advice", "", {"sentence"}, {{std::string("rate may matter")}}},
        {"place", "", {"place_index", "name", "chainage_m"}, {{0L, std::string("house <1>"), 12.5}}},
        {"place_series",
         "",
         {"place_index", "time_s", "thickness_m", "speed_m_s"},
         {{0L, 1.0, 0.25, 3.0}, {0L, 2.0, 0.5, 1.0}}},
        {"pilot", "Coarse runs.", {"resolution"}, {{8.0}}}};
    EXPECT_EQ(numerical_error_words(run), "run-out ± 0.42 m; from four lattices");
    EXPECT_TRUE(contains(answer_section(run).body, "± 0.42"));
    EXPECT_TRUE(contains(warnings_section(run).body, "rate may matter"));
    PlaceRecord house;
    house.name = "house <1>";
    house.chainage_m = run.run.toe_chainage_m + run.run.measures.farthest_front_m + 0.25;
    house.arrival_time_s = std::nan("");
    run.run.places = {house};
    run.run.appraisal.run_out_error_m = 0.42;
    const PageSection places = places_section(run);
    EXPECT_TRUE(
        contains(places.body, "not reached, but 0.25 m beyond the front is within its error of +-0.42 m"));
    EXPECT_TRUE(contains(places.body, "house &lt;1&gt;"));
    ASSERT_EQ(places.charts.size(), 2u);
    EXPECT_EQ(places.charts[0].figure.curves.at(0).points, (Polyline{{1, 0.25}, {2, 0.5}}));
    const std::string further = further_section(run).body;
    EXPECT_TRUE(contains(further, "Coarse runs."));
    EXPECT_FALSE(contains(further, "house"));
}

// ---- many runs

TEST_F(RunPageTest, AStudyTakesTheLatestRunOfEachScenarioAndKeepsFailuresOutOfItsCharts) {
    stored();
    RunResult later = example_result();
    later.measures.run_out_normalised = 77.25;
    stored(example_scene(), later);
    Scene other = example_scene();
    other.material.density = 1800;
    RunResult failed = example_result();
    failed.status = RunStatus::time_limit;
    failed.measures.run_out_normalised = 88.5432;
    stored(other, failed);
    const std::vector<StoredRun> runs = Store(path, Store::Mode::read).runs();
    ASSERT_EQ(runs.size(), 3u);
    EXPECT_EQ(latest_of_each_scenario(runs).size(), 2u);
    const std::string page = study_page("Runs", runs);
    const Json drop = data_of(page).at("charts").at("drop");
    ASSERT_EQ(drop.at("curves").size(), 1u);
    ASSERT_EQ(drop.at("curves")[0].at("points").size(), 1u);
    EXPECT_EQ(drop.at("curves")[0].at("points")[0][1], 77.25);
    EXPECT_TRUE(contains(page, "still moving at the time limit"));
    EXPECT_FALSE(contains(page, "88.54"));
}

TEST(Exceedance, FallsFromOneToNone) {
    const auto points = exceedance({3, 1, 2, nan, 2});
    ASSERT_EQ(points.size(), 8u);
    EXPECT_EQ(points.front(), Vec2(1, 1));
    EXPECT_EQ(points[1], Vec2(1, 0.75));
    EXPECT_EQ(points.back(), Vec2(3, 0));
    for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_LE(points[i].y(), points[i - 1].y());
        EXPECT_GE(points[i].x(), points[i - 1].x());
    }
    EXPECT_TRUE(exceedance({}).empty());
}

}  // namespace
}  // namespace runout
