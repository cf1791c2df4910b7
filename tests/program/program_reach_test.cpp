// What arrives at a place: `runout at`, places of a case in every output, and the height of a barrier.

#include <SQLiteCpp/Database.h>

#include <chrono>
#include <cmath>

#include "program_fixture.h"

namespace runout {
namespace {

/// The sound case with this after it; its toe is at chainage 0.45 m.
std::string with(const std::string& text) {
    return sound_case + text;
}

TEST_F(ProgramTest, EveryOutputSaysAlikeWhatIsReached) {
    write("case.toml", with("[[place]]\nname = \"near\"\nchainage_m = 0.5\nwidth_m = 0.05\nkind = \"road\"\n"
                            "[[gauge]]\nname = \"far\"\nchainage_m = 0.9\n"));
    const Outcome run = runout({"run", "case.toml", "--db", "v.db", "--json", "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json json = Json::parse(run.out);
    const double front = json.at("farthest_front_m");
    ASSERT_GT(front, 0.05);
    ASSERT_LT(front, 0.45);
    const auto place = [&](const char* name) {
        for (const Json& each : json.at("places"))
            if (each.at("name") == name) return each;
        return Json();
    };
    EXPECT_EQ(place("near").at("reached"), true);
    EXPECT_EQ(place("near").at("kind"), "road");
    EXPECT_EQ(place("far").at("reached"), false);
    const std::string table = runout({"table", "v.db"}).out;
    EXPECT_TRUE(contains(table, "at near")) << table;
    EXPECT_TRUE(contains(table, "not reached")) << table;
    const auto at = [&](double from_toe) {
        const Outcome said = runout({"at", "v.db", "--chainage", std::to_string(0.45 + from_toe), "--json"});
        EXPECT_EQ(said.exit_code, 0) << said.err;
        return Json::parse(said.out);
    };
    EXPECT_EQ(at(0.05).at("reached"), true);
    EXPECT_EQ(at(front - 1e-4).at("reached"), true);
    EXPECT_EQ(at(front + 1e-4).at("reached"), false);
    EXPECT_EQ(at(0.45).at("reached"), false);
    EXPECT_EQ(at(0.45).at("greatest_thickness_m"), 0.0);
    // Between its nodes, which are a third of a window apart, the envelope is that of the place.
    const double thickness = place("near").at("final_thickness_m");
    EXPECT_NEAR(at(0.05).at("final_thickness_m").get<double>(), thickness, 0.1 * thickness);
    EXPECT_TRUE(contains(runout({"at", "v.db", "--chainage", "0.5"}).out,
                         "Intensity: medium. Default classes, not yet checked"));
    EXPECT_TRUE(contains(runout({"at", "v.db", "--chainage", "0.5", "--intensity", "low=0,0", "--intensity",
                                 "grave=0.001,0.1"})
                             .out,
                         "Intensity: grave. Classes as given"));
    const std::string page = [&] {
        (void)runout({"report", "v.db", "-o", "page.html"});
        return text_of(work("page.html"));
    }();
    EXPECT_TRUE(contains(page, "What passed along the section"));
    EXPECT_TRUE(contains(page, "Intensity along the section"));
    (void)runout({"report", "v.db", "-o", "own.html", "--intensity", "grave=0.001,0.1"});
    EXPECT_TRUE(contains(text_of(work("own.html")), "grave"));
    EXPECT_TRUE(contains(text_of(work("own.html")), "Classes as given by --intensity."));
    EXPECT_FALSE(contains(page, "grave"));
    for (const char* command : {"report", "map"})
        expect_refused({command, "v.db", "-o", "no.gpkg", "--intensity", "high=1"}, {"--intensity"});
}

/// A run on a section of tests/field, source B, as one would from the command line.
Arguments field_run(const std::string& file, const Arguments& further) {
    const std::string place = std::string(RUNOUT_SOURCE_DIR) + "/tests/field/" + file;
    Arguments words = {"run",         place,    "--set",      "run.resolution=24",
                       "--no-pilots", "--json", "--no-store", "--quiet"};
    words.insert(words.end(), further.begin(), further.end());
    return words;
}

const Arguments source_b = {"--source",         "B",  "--base-angle",   "35",     "--scarp-angle",    "80",
                            "--friction-angle", "38", "--toe-chainage", "41.547", "--crest-chainage", "30"};

// Distances are horizontal: what 0.6.0 made 93 m and 2,020 m/s, 51.7 m at -61.5 deg, and 17 to 19 m/s.
TEST_F(ProgramTest, CracksWallsAndDrainsOfTheFieldAddNoDistance) {
    const auto answer = [&](const char* file) {
        const Outcome said = runout(field_run(file, source_b));
        EXPECT_EQ(said.exit_code, 0) << file << ": " << said.err;
        return Json::parse(said.out);
    };
    constexpr double bar = 0.6, free_fall = 19.81;  // m, of 12.9 m; m/s, from 20 m
    const Json plain = answer("slope.csv"), crack = answer("crack.csv"), channel = answer("u-channel.csv");
    const double run_out = plain.at("run_out_m");
    EXPECT_NEAR(run_out, 12.9, bar);
    EXPECT_NEAR(crack.at("run_out_m").get<double>(), 12.9, bar);
    EXPECT_GT(crack.at("run_out_along_bed_m").get<double>(), 90.0) << "which is another length";
    EXPECT_NEAR(channel.at("run_out_m").get<double>(), run_out, bar + 0.6);
    for (const Json& json : {plain, crack, channel})
        EXPECT_LT(json.at("peak_front_speed_m_s").get<double>(), free_fall);
    const Json wall = answer("facing-wall.csv");
    EXPECT_LE(wall.at("run_out_m").get<double>(), 3.4531);
    EXPECT_LE(wall.at("farthest_front_m").get<double>(), 3.4531);
    EXPECT_GT(wall.at("reach_angle_deg").get<double>(), 0.0);
}

// The front was said to stop 12.76 m past the toe, and nothing to arrive 12.0 m past it.
TEST_F(ProgramTest, FrontAndPlaceOfTheFieldAgree) {
    const Outcome said = runout(field_run("gauge-and-front.toml", {}));
    ASSERT_EQ(said.exit_code, 0) << said.err;
    const Json json = Json::parse(said.out);
    EXPECT_NEAR(json.at("toe_chainage_m").get<double>(), 28.6, 1e-9);
    const bool passes = json.at("farthest_front_m").get<double>() >= 40.6 - 28.6;
    EXPECT_EQ(json.at("places").at(0).at("reached"), passes);
    EXPECT_EQ(json.at("places").at(0).at("arrival_time_s").is_null(), !passes);
}

TEST_F(ProgramTest, AStudyTellsHowProbableItIsThatAPlaceIsReached) {
    write("study.toml",
          "[study]\nname = \"small\"\ncase = \"case.toml\"\nsamples = 12\n[vary]\n"
          "material.friction_angle_deg = { distribution = \"uniform\", low = 31, high = 38 }\n");
    ASSERT_EQ(runout({"sweep", "study.toml", "--db", "s.db", "--quiet"}).exit_code, 0);
    const auto json = [&](const char* chainage) {
        const Outcome said = runout({"at", "s.db", "--chainage", chainage, "--study", "small", "--json"});
        EXPECT_EQ(said.exit_code, 0) << said.err;
        return Json::parse(said.out);
    };
    EXPECT_EQ(json("0.46").at("probability_of_reaching"), 1.0);
    EXPECT_EQ(json("1.4").at("probability_of_reaching"), 0.0);
    EXPECT_EQ(json("0.46").at("greatest_thickness_m").size(), 3U);
    EXPECT_GT(json("0.46").at("greatest_thickness_m").at(0).at("value").get<double>(), 0.0);
    // The table says the same of a distance from the toe.
    for (const char* distance : {"0.1", "0.2", "0.3"}) {
        const std::string chainage = std::to_string(0.45 + std::stod(distance));
        const std::string table = runout({"table", "s.db", "--distance", distance}).out;
        const double p = json(chainage.c_str()).at("probability_of_reaching");
        EXPECT_TRUE(contains(table, fmt::format("is reached with a probability of {:.3g} ", p))) << table;
    }
    EXPECT_EQ(runout({"at", "s.db", "--chainage", "0.5", "--section", "section.csv"}).exit_code, 0);
    // Its runs lose their envelopes, as older ones have none.
    SQLite::Database(work("s.db").string(), SQLite::OPEN_READWRITE).exec("DELETE FROM envelope");
    expect_refused({"at", "s.db", "--chainage", "0.5", "--study", "small"}, {"has no envelopes"});
    EXPECT_TRUE(contains(runout({"at", "s.db", "--chainage", "0.46", "--run", "1"}).out, "has no envelope"));
}

TEST_F(ProgramTest, PlacesThatCannotBeAreWrongInput) {
    const auto refused = [&](const std::string& text, const Arguments& parts) {
        write("wrong.toml", with(text));
        expect_refused({"run", "wrong.toml", "--quiet"}, parts);
    };
    refused("[[place]]\nchainage_m = 99\n", {"place.chainage_m = 99", "is not on the section"});
    refused("[[place]]\nname = \"shed\"\nchainage_m = 0.35\n", {"puts shed into the source or uphill of it"});
    refused("[[place]]\nname = \"shed\"\nchainage_m = 0.5\nwidth_m = 1000\n",
            {"ends shed beyond the section"});
    refused("[[place]]\nwidth_m = 3\n", {"place.width_m", "needs place.chainage_m"});
    refused("front_window_m = 1000\n", {"run.front_window_m", "out of proportion"});
    refused("front_thickness_m = 1000\n", {"run.front_thickness_m", "out of proportion"});
    write("case.toml", sound_case);
    ASSERT_EQ(runout({"run", "case.toml", "--db", "v.db", "--quiet"}).exit_code, 0);
    expect_refused({"at", "v.db"}, {"--chainage", "is missing"});
    expect_refused({"at", "v.db", "--chainage", "99"}, {"is not on the section"});
    expect_refused({"at", "v.db", "--chainage", "0.5", "--study", "none"}, {"is not in this database"});
    expect_refused({"at", "v.db", "--chainage", "0.5", "--section", "none"}, {"has no runs"});
    expect_refused({"at", "v.db", "--chainage", "0.5", "--run", "7"}, {"no such run"});
    for (const char* wrong : {"high", "high=1", "=1,2", "high=1,x", "high=-1,2"})
        expect_refused({"at", "v.db", "--chainage", "0.5", "--intensity", wrong}, {"--intensity"});
    expect_refused(
        {"at", "v.db", "--chainage", "0.5", "--intensity", "high=1,1", "--intensity", "low=0.5,0.5"},
        {"--intensity", "is not above high"});
    expect_refused({"barrier", "case.toml"}, {"effects.barrier.chainage_m", "is missing"});
}

TEST_F(ProgramTest, ABarrierIsFoundThatHoldsTheFront) {
    write("case.toml", with("[effects.barrier]\nchainage_m = 0.5\nheight_m = 0.01\nthickness_m = 0.01\n"));
    const Outcome outcome = runout({"barrier", "case.toml", "--tolerance", "20", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json json = Json::parse(outcome.out);
    const double least = json.at("least_height_m"), too_low = json.at("too_low_m");
    EXPECT_LE(least - too_low, 0.2 * least);
    for (const Json& trial : json.at("trials")) {
        const bool holds = trial.at("holds");
        if (trial.at("height_m").get<double>() <= too_low) {
            EXPECT_FALSE(holds);
        }
        if (holds) {
            EXPECT_LE(trial.at("farthest_front_m").get<double>(), 0.05 + 0.01 + 1e-9);
        }
        EXPECT_GT(trial.at("greatest_force_n_m").get<double>(), 0.0);
    }
}

// 10,000 scenarios of one study: the section and the source are the same, runs and envelopes are not.
TEST_F(ProgramTest, APlaceOfTenThousandScenariosIsAnsweredWithinASecond) {
    write("study.toml",
          "[study]\nname = \"big\"\ncase = \"case.toml\"\nsamples = 4\n[vary]\nrun.resolution = 6\n"
          "material.friction_angle_deg = { distribution = \"uniform\", low = 30, high = 38 }\n");
    ASSERT_EQ(runout({"sweep", "study.toml", "--db", "s.db", "--quiet"}).exit_code, 0);
    SQLite::Database file(work("s.db").string(), SQLite::OPEN_READWRITE);
    const auto columns = [&](const char* table, const char* without) {
        std::string names;
        SQLite::Statement statement(file, "SELECT name FROM pragma_table_info(?) WHERE name <> ?");
        statement.bind(1, table);
        statement.bind(2, without);
        while (statement.executeStep())
            names += (names.empty() ? "" : ", ") + statement.getColumn(0).getString();
        return names;
    };
    file.exec(
        "CREATE TEMP TABLE n AS WITH RECURSIVE c(i) AS (SELECT 10 UNION ALL SELECT i + 1 FROM c WHERE i < "
        "10005)"
        " SELECT i FROM c");
    const auto copies = [&](const std::string& table, const std::string& id, const std::string& changed,
                            const std::string& to) {
        std::string names = columns(table.c_str(), id.c_str()), values = names;
        values.replace(values.find(changed), changed.size(), to);
        file.exec("INSERT INTO " + table + " (" + id + ", " + names + ") SELECT i, " + values + " FROM n, " +
                  table + " WHERE " + id + " = 1");
    };
    copies("scenario", "scenario_id", "scenario_hash", "'hash' || i");
    copies("run", "run_id", "scenario_id", "i");
    for (const std::string table : {"measure", "envelope"})
        file.exec("INSERT INTO " + table + " (run_id, " + columns(table.c_str(), "run_id") + ") SELECT i, " +
                  columns(table.c_str(), "run_id") + " FROM n, " + table + " WHERE run_id = 1");
    file.exec("INSERT INTO study_scenario SELECT study_id, i, 'hash' || i, '{}', '' FROM n, study");
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = runout({"at", "s.db", "--chainage", "0.5", "--study", "big", "--json"});
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out).at("results"), 10000);
    EXPECT_LT(seconds, 5) << "asked is one second; a busy machine or a sanitizer takes longer";
    RecordProperty("seconds", std::to_string(seconds));
}

}  // namespace
}  // namespace runout
