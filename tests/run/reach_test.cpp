// What arrives where: the front, the places and the envelope of a run say one thing, on scenes drawn at
// random.

#include "measures/reach.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "engine/simulation.h"
#include "measures/envelope.h"
#include "measures/front_rule.h"
#include "run/run_scene.h"
#include "scene/make_problem.h"
#include "scenes.h"

namespace runout {
namespace {

/// A column, heap or box over flat ground, a step, a ditch or a facing wall; 60 to 150 particles.
Scene random_scene(std::mt19937& random) {
    std::uniform_real_distribution<double> share(0, 1);
    const double height = 0.05 + 0.25 * share(random), width = 0.1;
    const double friction = 15 + 25 * share(random);
    const double end = 3.0, at = width + 0.1 + 0.4 * share(random), step = 0.3 * (share(random) - 0.5);
    std::vector<Vec2> section = {{-0.2, 0.5}, {0, 0.5}, {0, 0}};
    switch (static_cast<int>(4 * share(random))) {
        case 0:
            break;
        case 1:  // a step up or down
            section.insert(section.end(), {{at, 0}, {at, step}});
            break;
        case 2:  // a ditch
            section.insert(section.end(), {{at, 0}, {at, -0.1}, {at + 0.1, -0.1}, {at + 0.1, 0}});
            break;
        default:  // a wall that faces the slope
            section.insert(section.end(), {{at, 0}, {at, 0.6}});
            break;
    }
    section.emplace_back(end, section.back().y());
    Scene scene = scenes::polygon(section, {{0, 0}, {width, 0}, {width, height}, {0, height}}, friction,
                                  std::sqrt(width * height) / 9);
    if (scene.run.time_limit == 0) scene.run.time_limit = 6;
    return scene;
}

/// Places at the nodes of the envelope, and one between each two.
void add_places(Scene& scene) {
    const double step = front_rule(scene).window / ThicknessField::nodes_per_window;
    for (int k = 0; k < 60; ++k) {
        const double x = 0.5 * k * step;
        if (x > 0.11 && x < 2.5) scene.places.push_back({.name = std::to_string(k), .x = x});
    }
}

/// Highest point of the source over the lowest of the bed, m.
double greatest_fall(const Scene& scene) {
    double high = -1e9, low = 1e9;
    for (const Vec2& point : scene.source.outline) high = std::max(high, point.y());
    for (const Vec2& point : scene.source.bed) low = std::min(low, point.y());
    return high - low;
}

void check_places(const Scene& scene, const RunResult& result, const std::string& what) {
    const Measures& m = result.measures;
    for (std::size_t i = 0; i < scene.places.size(); ++i) {
        const bool reached = !std::isnan(result.places[i].arrival_time_s);
        EXPECT_EQ(reached, m.farthest_front_m >= scene.places[i].x) << what << " at " << scene.places[i].x;
        EXPECT_TRUE(reached || m.run_out_m < scene.places[i].x) << what;
    }
}

void check_envelope(const Scene& scene, const RunResult& result, const std::string& what) {
    const Envelope& e = result.envelope;
    ASSERT_EQ(e.greatest_thickness_m.size(), e.passed_area_m2.size());
    for (std::size_t p = 0; p < scene.places.size(); ++p) {
        const double place = (scene.places[p].x - e.first_m) / e.step_m;
        const auto i = static_cast<std::size_t>(std::lround(place));
        const PlaceRecord& record = result.places[p];
        if (std::abs(place - static_cast<double>(i)) > 1e-6 || i >= e.passed_area_m2.size()) continue;
        EXPECT_NEAR(e.greatest_thickness_m[i], record.greatest_thickness_m, 1e-9) << what;
        EXPECT_NEAR(e.final_thickness_m[i], record.final_thickness_m, 1e-9) << what;
        EXPECT_NEAR(e.greatest_speed_m_s[i], record.greatest_speed_m_s, 1e-6) << what;
        EXPECT_NEAR(e.greatest_kinetic_head_m[i], record.greatest_kinetic_head_m, 1e-6) << what;
        EXPECT_NEAR(e.greatest_momentum_flux_n_m[i], record.greatest_momentum_flux_n_m, 1e-3) << what;
        EXPECT_NEAR(e.passed_area_m2[i], record.passed_area_m2, 1e-12) << what;
        const bool reached = !std::isnan(e.arrival_time_s[i]);
        EXPECT_EQ(reached, !std::isnan(record.arrival_time_s)) << what << " at " << scene.places[p].x;
        if (reached) {
            EXPECT_EQ(e.arrival_time_s[i], record.arrival_time_s) << what;
        }
    }
}

void check_speeds(const Scene& scene, const RunResult& result, const std::string& what) {
    constexpr double settling = 1.05;  // soil rises by a little as its lattice loosens
    const double most = settling * std::sqrt(2 * scene.run.gravity * greatest_fall(scene));
    EXPECT_LE(result.measures.peak_front_speed_m_s, most) << what;
    for (const double speed : result.envelope.greatest_speed_m_s) EXPECT_LE(speed, most) << what;
}

// 12 scenes; RUNOUT_REACH_SCENES=1000 in .ci/run --full stability.
TEST(Reach, FrontPlacesAndEnvelopeSayOneThing) {
    const char* asked = std::getenv("RUNOUT_REACH_SCENES");
    const int scenes = asked != nullptr ? std::atoi(asked) : 12;
    std::mt19937 random(38);
    int moved = 0;
    for (int k = 0; k < scenes; ++k) {
        Scene scene = random_scene(random);
        add_places(scene);
        const RunResult result = run_scene(scene);
        const std::string what = "scene " + std::to_string(k) + ", " + std::string(to_string(result.status));
        if (result.status == RunStatus::stable) continue;
        ++moved;
        check_places(scene, result, what);
        check_envelope(scene, result, what);
        check_speeds(scene, result, what);
        if (is_result(result.status)) {
            EXPECT_LE(result.measures.run_out_m, std::max(0.0, result.measures.farthest_front_m)) << what;
            EXPECT_GE(result.measures.reach_angle_deg, 0) << what;
        }
    }
    EXPECT_GT(moved, scenes / 2);
}

// At every instant what has passed is what lies beyond, less what lay there at the start.
TEST(Reach, PassedAreaIsTheSoilBeyond) {
    const Scene scene = scenes::aluminium_column(21.9, 0.01);
    Simulation simulation(make_problem(scene));
    while (!simulation.released()) simulation.step();
    ReachRecorder reach(front_rule(scene), simulation.state());
    EnvelopeRecorder recorder(scene.material.density, reach);
    recorder.look(reach, simulation.state());
    const auto beyond = [&](double x) {
        const StateView state = simulation.state();
        double area = 0;
        for (const double at : state.x)
            if (at >= x) area += state.discretisation->volume();
        return area;
    };
    std::vector<double> start;
    const double step = front_rule(scene).window / ThicknessField::nodes_per_window;
    for (int k = 0; k < 40; ++k) start.push_back(beyond(k * step));
    while (simulation.status() == RunStatus::running && simulation.time() < 0.4) {
        simulation.step();
        reach.look(simulation.state());
        recorder.look(reach, simulation.state());
        const Envelope envelope = recorder.envelope();
        for (int k = 0; k < 40; ++k) {
            const auto i = static_cast<std::size_t>(std::lround(k - envelope.first_m / step));
            const double passed = i < envelope.passed_area_m2.size() ? envelope.passed_area_m2[i] : 0;
            ASSERT_NEAR(passed, beyond(k * step) - start[static_cast<std::size_t>(k)], 1e-12) << k;
        }
    }
}

TEST(Reach, ASourceThatStandsReachesNothing) {
    Scene scene = scenes::heap(15.0, 0.1, 30.0, 0.005);
    scene.places = {{.name = "at its foot", .x = 0.38}};
    const RunResult result = run_scene(scene);
    ASSERT_EQ(result.status, RunStatus::stable);
    EXPECT_TRUE(std::isnan(result.places[0].arrival_time_s));
    EXPECT_TRUE(std::isnan(result.measures.farthest_front_m));
    for (const double time : result.envelope.arrival_time_s) EXPECT_TRUE(std::isnan(time));
}

TEST(Reach, AThresholdAboveTheDepositIsNoBody) {
    Scene scene =
        scenes::polygon({{0, 0.4}, {0, 0}, {2, 0}}, {{0, 0}, {0.1, 0}, {0.1, 0.25}, {0, 0.25}}, 20, 0.01);
    scene.run.front_thickness = 0.2;
    const RunResult result = run_scene(scene);
    EXPECT_EQ(result.status, RunStatus::not_a_body);
    EXPECT_NE(result.status_detail.find("nowhere 0.2 m thick"), std::string::npos) << result.status_detail;
}

TEST(Reach, AFrontThatLeavesTheSectionIsNoRunOut) {
    // The soil itself stays on the section, its front does not.
    Scene scene = scenes::polygon({{0, 0.2}, {0, 0}, {0.385, 0}}, {{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}},
                                  21.9, 0.008);
    const RunResult result = run_scene(scene);
    EXPECT_EQ(result.status, RunStatus::left_section);
}

TEST(Reach, AFacingWallEndsTheRunOut) {
    const double wall = 0.27;
    const Scene scene = scenes::polygon({{0, 0.2}, {0, 0}, {wall, 0}, {wall, 1}, {2, 1}},
                                        {{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}}, 21.9, 0.008);
    const RunResult result = run_scene(scene);
    ASSERT_EQ(result.status, RunStatus::settled);
    EXPECT_EQ(result.measures.farthest_front_m, wall);
    EXPECT_EQ(result.measures.run_out_m, wall);
    EXPECT_GT(result.measures.reach_angle_deg, 0);
}

// Distances are horizontal: a fine saw and a deep crack add nothing to them.
TEST(Reach, TeethAndCracksAddNoDistance) {
    const auto run_out = [](const std::vector<Vec2>& section) {
        const RunResult result =
            run_scene(scenes::polygon(section, {{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}}, 21.9, 0.008));
        EXPECT_EQ(result.status, RunStatus::settled);
        return result.measures;
    };
    const Measures flat = run_out({{0, 0.2}, {0, 0}, {2, 0}});
    const Measures crack =
        run_out({{0, 0.2}, {0, 0}, {0.3, 0}, {0.3, -40}, {0.3001, -40}, {0.3001, 0}, {2, 0}});
    EXPECT_NEAR(crack.run_out_m, flat.run_out_m, 0.03);
    EXPECT_GT(crack.run_out_along_bed_m, 40);
    std::vector<Vec2> saw = {{0, 0.2}, {0, 0}, {0.25, 0}};
    for (double x = 0.25; x < 0.9; x += 0.02) saw.insert(saw.end(), {{x + 0.01, 0.0008}, {x + 0.02, 0}});
    saw.emplace_back(2, 0);
    const Measures teeth = run_out(saw);
    EXPECT_NEAR(teeth.run_out_m, flat.run_out_m, 0.05);
    EXPECT_LT(teeth.peak_front_speed_m_s, std::sqrt(2 * 9.81 * 0.1));
    // Teeth finer than the particles, on which they once skipped as on ice.
    std::vector<Vec2> fine = {{0, 0.2}, {0, 0}, {0.21, 0}};
    for (double x = 0.21; x < 0.9; x += 0.002) fine.insert(fine.end(), {{x + 0.001, 0.001}, {x + 0.002, 0}});
    fine.emplace_back(2, 0);
    const Measures rough = run_out(fine);
    EXPECT_NEAR(rough.run_out_m, flat.run_out_m, 0.05);
    EXPECT_LT(rough.peak_front_speed_m_s, std::sqrt(2 * 9.81 * 0.1));
}

}  // namespace
}  // namespace runout
