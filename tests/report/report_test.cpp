#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "example_run.h"
#include "report/text/place_doubt.h"
#include "report/text/reach_text.h"
#include "report/text/run_out_table.h"
#include "report/text/table.h"
#include "store/columns.h"

namespace runout {
namespace {

using Json = nlohmann::json;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

StoredRun settled_run() {
    StoredRun run = describe_run(example_scene(), example_result());
    run.run_id = 12;
    return run;
}

/// A settled run with the numbers of a slope, for texts that people read.
StoredRun slope_run() {
    StoredRun run = settled_run();
    run.measures = {.run_out_m = 12.3456,
                    .run_out_normalised = 1.4571,
                    .front_thickness_m = 0.5,
                    .front_window_m = 2.5,
                    .reach_angle_deg = 33.14,
                    .source_area_m2 = 71.8,
                    .deposit_area_m2 = 71.8,
                    .front_area_m2 = 52,
                    .front_area_ratio = 0.7242,
                    .drop_height_m = 15.21,
                    .deposit_height_m = 2.134,
                    .toe_thickness_m = 1.871,
                    .peak_front_speed_m_s = 8.26,
                    .time_to_rest_s = 4.13};
    run.work.particles = 1600;
    run.work.particle_spacing_m = 0.2118;
    return run;
}

StoredRun failed_run() {
    StoredRun run = settled_run();
    run.run_id = 13;
    run.status = RunStatus::diverged;
    run.status_detail = "density ratio 1.31 at t = 0.2 s";
    return run;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (const char letter : line) {
        if (letter == '"')
            quoted = !quoted;
        else if (letter == ',' && !quoted)
            fields.emplace_back();
        else
            fields.back() += letter;
    }
    return fields;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// ---- JSON

TEST(RunJson, IsOneObjectWithEveryNumberToTheBit) {
    const StoredRun run = settled_run();
    const Json json = Json::parse(run_json(run));
    ASSERT_TRUE(json.is_object());
    for (const MeasureField& field : measure_fields())
        EXPECT_EQ(json.at(field.name).get<double>(), run.measures.*field.value) << field.name;
    for (const WorkColumn& column : work_columns())
        std::visit(
            [&](auto member) {
                EXPECT_EQ(json.at(column.name).get<double>(), run.work.*member) << column.name;
            },
            column.member);
    EXPECT_EQ(json.at("run_id"), 12);
    EXPECT_EQ(json.at("name"), "cut-60");
    EXPECT_EQ(json.at("status"), "settled");
    EXPECT_EQ(json.at("status_detail"), "");
    EXPECT_EQ(json.at("section_origin"), "profiles/cut-60.csv");
    EXPECT_EQ(json.at("source_type"), "C");
    EXPECT_EQ(json.at("discontinuity_angle_deg"), run.discontinuity_angle_deg);
    EXPECT_EQ(json.at("drop_height_datum"), "head");
    EXPECT_EQ(json.at("slope_angle_deg"), run.slope_angle_deg);
    EXPECT_EQ(json.at("friction_angle_deg"), run.friction_angle_deg);
    EXPECT_EQ(json.at("scenario_hash"), run.scenario_hash);
    EXPECT_EQ(json.at("program_version"), run.program_version);
    EXPECT_EQ(json.at("program_revision"), run.program_revision);
    EXPECT_EQ(json.at("compiler"), run.compiler);
    EXPECT_EQ(json.at("host_threads"), run.host_threads);
    EXPECT_EQ(json.at("started_utc"), run.started_utc);
    EXPECT_EQ(json.at("ended_utc"), run.ended_utc);
}

TEST(RunJson, HasTheKeysThatOtherProgramsRelyOn) {
    const Json json = Json::parse(run_json(settled_run()));
    for (const char* key : {"run_out_m", "run_out_normalised", "reach_angle_deg", "source_area_m2",
                            "deposit_area_m2", "front_area_ratio", "drop_height_m", "status", "particles",
                            "steps", "particle_spacing_m", "wall_s", "cpu_s"})
        EXPECT_TRUE(json.contains(key)) << key;
}

TEST(RunJson, WhatDoesNotExistIsNull) {
    StoredRun run = settled_run();
    run.run_id = 0;
    run.measures.reach_angle_deg = nan;
    run.work.highest_density_ratio = std::numeric_limits<double>::infinity();
    const Json json = Json::parse(run_json(run));
    EXPECT_TRUE(json.at("reach_angle_deg").is_null());
    EXPECT_TRUE(json.at("highest_density_ratio").is_null());
    EXPECT_TRUE(json.at("run_id").is_null());
    EXPECT_FALSE(json.at("run_out_m").is_null());
}

TEST(RunJson, AFailedRunHasNoMeasures) {
    const Json json = Json::parse(run_json(failed_run()));
    for (const MeasureField& field : measure_fields())
        EXPECT_TRUE(json.at(field.name).is_null()) << field.name;
    EXPECT_EQ(json.at("status"), "diverged");
    EXPECT_EQ(json.at("status_detail"), "density ratio 1.31 at t = 0.2 s");
    EXPECT_EQ(json.at("particles"), 1601);
}

TEST(RunJson, TextThatIsNotUtf8IsStillJson) {
    StoredRun run = settled_run();
    run.name = "b\xF6schung \"north\"\n";
    const Json json = Json::parse(run_json(run));
    EXPECT_TRUE(has(json.at("name"), "schung \"north\"\n"));
}

// ---- tables for programs

/// A run that is looked at by itself has more: what its effects did.
Json without_effects(const std::string& text) {
    Json json = Json::parse(text);
    for (const char* key : {"effects", "advice", "places", "barrier"}) EXPECT_EQ(json.erase(key), 1U) << key;
    return json;
}

TEST(RunTable, JsonIsAnArrayOfTheSameObjects) {
    const StoredRun settled = settled_run();  // a second one would have another time of its end
    const StoredRun failed = failed_run();
    Json json = Json::parse(run_table({settled, failed}, TableFormat::json));
    ASSERT_EQ(json.size(), 2U);
    for (Json& run : json) EXPECT_EQ(run.erase("places"), 1U);
    EXPECT_EQ(json[0], without_effects(run_json(settled)));
    EXPECT_EQ(json[1], without_effects(run_json(failed)));
    EXPECT_EQ(Json::parse(run_table({}, TableFormat::json)), Json::array());
}

TEST(RunTable, CsvHasTheColumnsOfTheJsonAndNumbersToTheBit) {
    StoredRun run = settled_run();
    run.status_detail = "";
    const auto lines = lines_of(run_table({run}, TableFormat::csv));
    ASSERT_EQ(lines.size(), 2U);
    const auto names = fields_of(lines[0]);
    const auto values = fields_of(lines[1]);
    const Json json = without_effects(run_json(run));
    ASSERT_EQ(names.size(), json.size());
    ASSERT_EQ(values.size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Json& expected = json.at(names[i]);
        if (expected.is_number()) {
            EXPECT_EQ(std::stod(values[i]), expected.get<double>()) << names[i];
        } else if (expected.is_null()) {
            EXPECT_EQ(values[i], "") << names[i];
        } else {
            EXPECT_EQ(values[i], expected.get<std::string>()) << names[i];
        }
    }
}

TEST(RunTable, CsvOfAFailedRunHasItsStatusAndEmptyCells) {
    const auto lines = lines_of(run_table({failed_run()}, TableFormat::csv));
    const auto names = fields_of(lines.at(0));
    const auto values = fields_of(lines.at(1));
    ASSERT_EQ(values.size(), names.size());
    const auto value = [&](const std::string& name) {
        return values[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
    };
    EXPECT_EQ(value("status"), "diverged");
    for (const MeasureField& field : measure_fields()) EXPECT_EQ(value(field.name), "") << field.name;
}

TEST(RunTable, CsvLeavesOutWhatDoesNotExist) {
    StoredRun run = settled_run();
    run.measures.reach_angle_deg = nan;
    EXPECT_FALSE(has(run_table({run}, TableFormat::csv), "nan"));
}

TEST(RunTable, CsvQuotesWhatWouldBreakALine) {
    StoredRun run = settled_run();
    run.name = "a \"steep\", wet\ncut";
    EXPECT_TRUE(has(run_table({run}, TableFormat::csv), "12,\"a \"\"steep\"\", wet\\x0acut\",settled,"));
}

TEST(RunTable, CsvOfNothingIsItsHeader) {
    EXPECT_EQ(lines_of(run_table({}, TableFormat::csv)).size(), 1U);
}

// ---- tables for people

TEST(RunTable, TextHasTitlesUnitsAndAlignedColumns) {
    StoredRun longer = slope_run();
    longer.run_id = 1234;
    longer.name = "a longer name";
    longer.measures.run_out_m = 123.456;
    const auto lines = lines_of(run_table({slope_run(), longer}, TableFormat::text));
    ASSERT_EQ(lines.size(), 4U);
    const std::size_t end_of_title = lines[0].find("run-out") + std::string("run-out").size();
    EXPECT_EQ(lines[1].substr(end_of_title - 2, 2), " m");
    EXPECT_EQ(lines[2].substr(end_of_title - 6, 6), " 12.35");
    EXPECT_EQ(lines[3].substr(end_of_title - 6, 6), " 123.5");
    EXPECT_EQ(lines[2].find("cut-60"), lines[0].find("name"));
    EXPECT_EQ(lines[3].find("settled"), lines[0].find("status"));
    EXPECT_TRUE(has(lines[2], "33.1"));
}

TEST(RunTable, TextStaysAlignedBesideNamesBeyondAscii) {
    StoredRun accented = slope_run();
    accented.name = "B\u00F6schung";  // 8 columns, 9 bytes
    StoredRun chinese = slope_run();
    chinese.name = "\u5C71\u5761";  // 4 columns, 6 bytes
    const auto lines = lines_of(run_table({accented, chinese}, TableFormat::text));
    const std::size_t status = lines[0].find("status");
    EXPECT_EQ(lines[2].find("settled"), status + 1);
    EXPECT_EQ(lines[3].find("settled"), status + 2);
}

TEST(RunTable, AFailedRunShowsItsStatusAndNoNumberOfTheResult) {
    StoredRun failed = failed_run();
    failed.measures = slope_run().measures;
    const auto lines = lines_of(run_table({slope_run(), failed}, TableFormat::text));
    ASSERT_EQ(lines.size(), 6U);
    EXPECT_TRUE(has(lines[3], "diverged"));
    for (const char* number : {"12.35", "1.457", "33.1", "71.8", "15.21"}) {
        EXPECT_TRUE(has(lines[2], number)) << number;
        EXPECT_FALSE(has(lines[3], number)) << number;
    }
    EXPECT_EQ(lines[5], "run 13: no result: diverged, density ratio 1.31 at t = 0.2 s");
}

TEST(RunTable, TextOfNothingSaysSo) {
    EXPECT_EQ(run_table({}, TableFormat::text), "no runs stored\n");
}

// ---- summary

TEST(RunSummary, SaysHowFarHowThickHowFast) {
    const std::string text = run_summary(slope_run());
    for (const char* part : {"cut-60", "12.35 m past the toe", "1.46 times", "33.1 deg", "2.13 m thick",
                             "1.87 m at the toe", "8.26 m/s", "at rest after 4.13 s", "71.8 m2", "15.21 m",
                             "0.724", "1600 particles", "2503 steps", "2.3 s"})
        EXPECT_TRUE(has(text, part)) << part << " in\n" << text;
    EXPECT_FALSE(has(text, "Coarse")) << text;
    EXPECT_FALSE(has(text, "stray")) << text;
    EXPECT_FALSE(has(text, "nan")) << text;
}

TEST(RunSummary, SaysHowSureTheNumbersAreAndHowMuchNatureScatters) {
    StoredRun run = slope_run();
    run.appraisal = example_appraisal();
    const std::string text = run_summary(run);
    for (const char* part : {"+-0.61 m (4.9 %) of the run-out", "+-0.9 deg of the reach angle", "95 %",
                             "pilot", "Empirical relations", "4.1 s expected"})
        EXPECT_TRUE(has(text, part)) << part << " in\n" << text;
    EXPECT_TRUE(has(run_summary(slope_run()), "Numerical error not known"));

    run.measures.run_out_m = 3.0;  // less than the source is wide: a share of that says nothing
    EXPECT_TRUE(has(run_summary(run), "+-0.61 m (7.2 % of sqrt(S)) of the run-out")) << run_summary(run);
    EXPECT_FALSE(has(run_summary(slope_run()), "expected"));
}

TEST(RunTable, ShowsErrorBarsAndWhereTheyCameFrom) {
    StoredRun run = slope_run();
    run.appraisal = example_appraisal();
    const auto lines = lines_of(run_table({run, slope_run()}, TableFormat::text));
    EXPECT_TRUE(has(lines[0], "+-") && has(lines[0], "error from"));
    EXPECT_TRUE(has(lines[2], "0.61") && has(lines[2], "0.9") && has(lines[2], "pilot"));
    EXPECT_TRUE(has(lines[3], "none"));
    const Json json = Json::parse(run_json(run));
    EXPECT_EQ(json.at("run_out_error_m"), 0.61);
    EXPECT_EQ(json.at("reach_angle_error_deg"), 0.87);
    EXPECT_EQ(json.at("error_origin"), "pilot");
    EXPECT_EQ(json.at("expected_cpu_s"), 4.1);
    EXPECT_TRUE(Json::parse(run_json(slope_run())).at("run_out_error_m").is_null());
    run.status = RunStatus::diverged;
    EXPECT_TRUE(Json::parse(run_json(run)).at("run_out_error_m").is_null()) << "an error bar of nothing";
}

TEST(RunSummary, CountsStrayParticles) {
    StoredRun run = slope_run();
    run.measures.stray_particles = 1;
    EXPECT_TRUE(has(run_summary(run), "1 stray particle apart from the deposit"));
    run.measures.stray_particles = 2;
    EXPECT_TRUE(has(run_summary(run), "2 stray particles apart"));
}

TEST(RunSummary, SaysWhenTheFrontIsCoarse) {
    StoredRun few = slope_run();
    few.work.particle_spacing_m = 0.8;
    few.measures.front_thickness_m = 1;
    EXPECT_TRUE(has(run_summary(few), "Coarse: only 11 particles along sqrt(S)"));
    StoredRun thin = slope_run();
    thin.measures.front_thickness_m = 0.015;
    EXPECT_TRUE(has(run_summary(thin), "Coarse: one particle alone is as thick as the front, 0.015 m"));
}

TEST(RunSummary, SaysWhatTheFrontIsAndWhatIsBeyondIt) {
    StoredRun run = slope_run();
    EXPECT_TRUE(
        has(run_summary(run), "all soil is 0.5 m thick in a window of +-2.5 m; distances are horizontal"));
    run.measures.farthest_front_m = 13.2;
    run.measures.farthest_soil_m = 16.1;
    run.measures.beyond_front_speed_m_s = 6.5;
    run.measures.beyond_front_area_m2 = 0.25;
    EXPECT_TRUE(has(run_summary(run), "On the way it was 13.2 m past the toe."));
    EXPECT_TRUE(
        has(run_summary(run), "single grains come 16.1 m past the toe, at up to 6.5 m/s; 0.25 m2 lie"));
}

// A run of before database 10 is never mixed with others unsaid.
TEST(RunTable, MarksTheFormerDefinitionOfTheFront) {
    StoredRun old = slope_run();
    old.front_definition = "top";
    const std::string table = run_table({slope_run(), old}, TableFormat::text);
    EXPECT_TRUE(has(table, "12.35*"));
    EXPECT_TRUE(has(table, "\n* This front has the former definition"));
    EXPECT_FALSE(has(run_table({slope_run()}, TableFormat::text), "former"));
    EXPECT_TRUE(has(run_summary(old), "former definition"));
    EXPECT_EQ(Json::parse(run_json(old)).at("front_definition"), "top");
}

// ---- tables of studies

// Labels of all scenarios were gathered anew for each row: half a minute of CPU for 10,000 rows, and 50 times
// that for these, which the time limit of a test (600 s) would end.
TEST(RunOutTable, TellsFiftyThousandRowsByNumberThenByColumn) {
    constexpr long count = 100000;
    std::vector<StudyRow> rows;
    for (long i = 0; i < count; ++i) {
        StudyRow row;
        row.scenario.index = i;
        row.scenario.inputs = fmt::format(R"({{"run.lattice_seed": "{}"}})", count / 2 - i / 2 - 1);
        row.run_id = i + 1;
        row.is_result = true;
        row.status = "settled";
        row.source_type = i % 2 == 0 ? "box" : "B";
        row.run_out_m = static_cast<double>(i);
        rows.push_back(row);
    }
    const RunOutTableOptions layout{.rows = "run.lattice_seed", .columns = "source_type", .distances = {}};
    const auto lines = lines_of(run_out_table("many", rows, layout, RunOutTableFormat::csv));
    ASSERT_EQ(lines.size(), count + 1);
    EXPECT_TRUE(lines[1].starts_with("0,B,1,99999"));
    EXPECT_TRUE(lines[2].starts_with("0,box,1,99998"));
    EXPECT_TRUE(lines[3].starts_with("1,B,1,99997"));
    EXPECT_TRUE(lines[21].starts_with("10,B,")) << "after 9, not after 1";
    EXPECT_EQ(Json::parse(run_out_table("many", rows, layout, RunOutTableFormat::json)).at("cells").size(),
              count);
}

// ---- places

StoredRun run_with_places() {
    StoredRun run = slope_run();
    PlaceRecord house;
    house.name = "house";
    house.kind = "building";
    house.chainage_m = 60;
    house.arrival_time_s = 2.5;
    house.greatest_thickness_m = 0.75;
    house.greatest_speed_m_s = 3.25;
    PlaceRecord road;
    road.name = "road";
    road.chainage_m = 70;
    road.arrival_time_s = std::nan("");
    run.places = {house, road};
    return run;
}

TEST(RunTable, HasAColumnForEachPlace) {
    const std::string text = run_table({slope_run(), run_with_places()}, TableFormat::text);
    EXPECT_TRUE(has(text, "at house"));
    EXPECT_TRUE(has(text, "0.75 m, 3.25 m/s"));
    EXPECT_TRUE(has(text, "not reached"));
    const auto lines = lines_of(run_table({slope_run(), run_with_places()}, TableFormat::csv));
    EXPECT_TRUE(
        lines[0].ends_with("place road reached,place road arrival_time_s,place road greatest_thickness_m,"
                           "place road greatest_speed_m_s"));
    EXPECT_TRUE(lines[1].ends_with(",,,,,,,,"));
    EXPECT_TRUE(lines[2].ends_with(",1,2.5,0.75,3.25,0,,0,0"));
    const Json json = Json::parse(run_table({run_with_places()}, TableFormat::json));
    EXPECT_EQ(json[0].at("places").at(0).at("reached"), true);
    EXPECT_EQ(json[0].at("places").at(1).at("reached"), false);
}

TEST(RunSummary, SaysWhatArrivesAtAPlace) {
    const std::string text = run_summary(run_with_places());
    EXPECT_TRUE(
        has(text, "Place house (building) at chainage 60 m: reached after 2.5 s, up to 0.75 m thick"));
    EXPECT_TRUE(has(text, "Place road at chainage 70 m: not reached."));
}

// A place 0.04 m beyond the front, with an error of half a metre, was told as not reached and no more.
TEST(RunSummary, SaysWhenAPlaceIsReachedWithinTheError) {
    StoredRun run = run_with_places();
    run.crest_chainage_m = 40;
    run.toe_chainage_m = 50;
    run.measures.farthest_front_m = 19.9;
    run.appraisal.run_out_error_m = 0.5;
    EXPECT_TRUE(
        has(run_summary(run), "Place road at chainage 70 m: not reached, but 0.1 m beyond the front is"));
    EXPECT_TRUE(has(run_table({run}, TableFormat::text), "not reached, within error"));
    run.appraisal.run_out_error_m = 0.05;
    EXPECT_TRUE(has(run_summary(run), "Place road at chainage 70 m: not reached."));
    EXPECT_FALSE(has(run_table({run}, TableFormat::text), "within error"));
    run.measures.farthest_front_m = 10.02;  // the house is at 10 m
    EXPECT_TRUE(
        has(run_summary(run), "reached, but 0.02 m behind the front is within its error of +-0.05 m; after"));
    EXPECT_TRUE(has(run_table({run}, TableFormat::text), "0.75 m, 3.25 m/s, within error"));
    EXPECT_EQ(Json::parse(run_json(run)).at("places").at(0).at("within_error"), true);
    EXPECT_EQ(Json::parse(run_json(run)).at("places").at(1).at("within_error"), false);
    run.appraisal.run_out_error_m = nan;
    EXPECT_FALSE(has(run_summary(run), "within its error")) << "an error that nobody knows is no doubt";
}

// The toe is at 50 m on a section that descends with chainage, and at 70 m on one that ascends.
TEST(PlaceDoubt, IsSignedUphillOfTheToeAndOnMirroredSections) {
    StoredRun run = run_with_places();
    run.measures.farthest_front_m = 5;
    run.appraisal.run_out_error_m = 0.5;
    run.crest_chainage_m = 30;
    run.toe_chainage_m = 50;
    run.places[0].chainage_m = 45;
    EXPECT_EQ(place_doubt(run, run.places[0]).beyond_front_m, -10);
    run.crest_chainage_m = 90;
    run.toe_chainage_m = 70;
    EXPECT_EQ(place_doubt(run, run.places[0]).beyond_front_m, 20);
}

TEST(ReachText, SaysWhenThePlaceIsWithinTheError) {
    ReachRow row;
    row.run_id = 1;
    row.status = "settled";
    row.is_result = true;
    row.from_toe_m = 20;
    row.farthest_front_m = 19.9;
    row.run_out_error_m = 0.5;
    const Intensities classes{usual_intensities(), usual_intensities_origin()};
    EXPECT_TRUE(
        has(reach_text(row, 70, classes), ": not reached, but 0.1 m beyond the front is within its error"));
    EXPECT_EQ(Json::parse(reach_json(row, 70, classes)).at("within_error"), true);
    EXPECT_TRUE(has(reach_text(summary_of({row}), 70), "In 1 of them the place is within the error"));
    EXPECT_EQ(Json::parse(reach_json(summary_of({row}), 70)).at("results_within_error"), 1);
    row.farthest_front_m = 20.25;
    EXPECT_TRUE(
        has(reach_text(row, 70, classes), ": reached, but 0.25 m behind the front is within its error"));
    row.farthest_front_m = 30;
    EXPECT_TRUE(has(reach_text(row, 70, classes), ": reached after 0 s.")) << reach_text(row, 70, classes);
    EXPECT_EQ(Json::parse(reach_json(row, 70, classes)).at("within_error"), false);
    row.status = "stable";
    row.farthest_front_m = nan;
    row.run_out_m = 19.9;
    EXPECT_EQ(Json::parse(reach_json(row, 70, classes)).at("within_error"), false) << "a source that stands";
}

TEST(RunSummary, AStableSourceStands) {
    StoredRun run = slope_run();
    run.status = RunStatus::stable;
    run.measures.reach_angle_deg = nan;
    const std::string text = run_summary(run);
    EXPECT_TRUE(has(text, "stands at this strength: no run-out")) << text;
    EXPECT_FALSE(has(text, "past the toe")) << text;
    EXPECT_FALSE(has(text, "nan")) << text;
}

TEST(RunSummary, DebrisMayStopOnTheFace) {
    StoredRun run = slope_run();
    run.measures.run_out_m = 0;
    run.measures.reach_angle_deg = nan;
    const std::string text = run_summary(run);
    EXPECT_TRUE(has(text, "does not pass the toe")) << text;
    EXPECT_FALSE(has(text, "nan")) << text;
}

TEST(RunSummary, AFailedRunHasNoResult) {
    for (const RunStatus status : {RunStatus::time_limit, RunStatus::left_section, RunStatus::not_converged,
                                   RunStatus::diverged, RunStatus::interrupted, RunStatus::not_a_body}) {
        StoredRun run = slope_run();
        run.status = status;
        run.status_detail = "at t = 0.2 s";
        const std::string text = run_summary(run);
        EXPECT_TRUE(has(text, "cut-60: no result: ")) << text;
        EXPECT_TRUE(has(text, "(at t = 0.2 s)")) << text;
        EXPECT_FALSE(has(text, "12.35")) << text;
    }
}

TEST(RunSummary, LongRunsAreInMinutes) {
    StoredRun run = slope_run();
    run.work.wall_s = 200.4;
    EXPECT_TRUE(has(run_summary(run), "3 min 20 s"));
}

TEST(TimeTable, SharesAddUp) {
    const std::string text = time_table({{"neighbours", 0.5}, {"pressure", 1.5}});
    EXPECT_EQ(text,
              "Time in             s   share\n"
              "neighbours      0.500    25 %\n"
              "pressure        1.500    75 %\n");
    EXPECT_EQ(time_table({}), "");
    EXPECT_EQ(time_table({{"neighbours", 0.0}}), "");
}

}  // namespace
}  // namespace runout
