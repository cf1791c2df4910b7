// Effects as such: the neutral value of each against its absence, what is not simulated where it is not
// called for, advice, and every pair of them together.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "engine/simulation.h"
#include "observe.h"
#include "run/run_scene.h"
#include "scene/make_problem.h"
#include "scenes.h"

namespace runout {
namespace {

constexpr double g = 9.81;

std::vector<Vec2> positions_at(const Scene& scene, double until) {
    Simulation simulation(make_problem(scene));
    while (simulation.status() == RunStatus::running && simulation.time() < until) simulation.step();
    return positions_by_id(simulation);
}

/// Each effect with the value that makes it nothing, and with one that does not.
struct Choice {
    const char* name;
    std::function<void(Effects&)> neutral;
    std::function<void(Effects&)> active;
};

std::vector<Choice> choices() {
    const auto still = [](double size) {
        return Shaking{{0.0, 0.1, 5.0}, {0.0, size, 0.0}, {0.0, 0.0, 0.0}};
    };
    return {
        {"base_friction", [](Effects& e) { e.base_friction = BaseFriction{.angle = radians(21.9)}; },
         [](Effects& e) {
             e.base_friction = BaseFriction{.ranges = {{0.1, 0.4, radians(12.0)}}};
         }},
        {"cohesion", [](Effects& e) { e.cohesion = Cohesion{}; },
         [](Effects& e) { e.cohesion = Cohesion{.strength = 100.0}; }},
        {"rate", [](Effects& e) { e.rate = RateDependence{.increase = 0.0, .grain_diameter = 0.003}; },
         [](Effects& e) { e.rate = RateDependence{.grain_diameter = 0.003}; }},
        {"pore_pressure", [](Effects& e) { e.pore_pressure = PorePressure{}; },
         [](Effects& e) {
             e.pore_pressure = PorePressure{.ratio = 0.1, .base_excess = 0.2, .dissipation_time = 0.2};
         }},
        {"barrier",
         {},
         [](Effects& e) { e.barrier = Barrier{.x = 0.35, .height = 0.04, .thickness = 0.04}; }},
        {"shaking", [=](Effects& e) { e.shaking = still(0.0); }, [=](Effects& e) { e.shaking = still(1.0); }},
        {"side_walls",
         [](Effects& e) {
             e.side_walls = SideWalls{std::numeric_limits<double>::infinity(), 0.4};
         },
         [](Effects& e) { e.side_walls = SideWalls{.width = 0.5, .angle = radians(20.0)}; }},
        {"release", [](Effects& e) { e.release = StagedRelease{}; },
         [](Effects& e) {
             e.release = StagedRelease{.layers = 1, .layer_width = 0.05, .layer_height = 0.02};
         }},
        {"erodible_bed",
         {},
         [](Effects& e) { e.erodible_bed = ErodibleBed{.depth = 0.02, .from = 0.21, .to = 0.34}; }},
    };
}

TEST(Neutral, EqualsAbsentToTheBit) {
    Scene scene = scenes::aluminium_column(21.9, 0.01);
    scene.run.sleeping = false;  // nothing sleeps while the ground moves, if only by nothing
    const std::vector<Vec2> absent = positions_at(scene, 0.4);
    for (const Choice& choice : choices()) {
        Scene changed = scene;
        if (choice.neutral) {
            choice.neutral(changed.effects);
            EXPECT_EQ(positions_at(changed, 0.4), absent) << choice.name;
        }
        changed = scene;
        choice.active(changed.effects);
        if (std::string(choice.name) == "release") continue;  // shows after rest only
        EXPECT_NE(positions_at(changed, 0.4), absent) << choice.name;
    }
}

TEST(FreeFlight, NeedsNoFrictionAndNoPressureUntilItLands) {
    Scene scene = scenes::aluminium_column(21.9, 0.01);
    Simulation standing(make_problem(scene));
    while (standing.status() == RunStatus::running) standing.step();
    EXPECT_EQ(standing.work().flying_particle_steps, 0.0) << "on the bed nothing flies";
    for (Vec2& corner : scene.source.outline) corner += Vec2{0.1, 0.15};  // off bed and wall
    Simulation simulation(make_problem(scene));
    const std::vector<Vec2> start = positions_by_id(simulation);
    while (simulation.time() < 0.12) simulation.step();
    EXPECT_EQ(simulation.work().flying_particle_steps, simulation.work().particle_steps);
    EXPECT_EQ(simulation.work().pressure_iterations, 0);
    const std::vector<Vec2> now = positions_by_id(simulation);
    const Vec2 fall = now[0] - start[0];
    EXPECT_NEAR(fall.y(), -0.5 * g * std::pow(simulation.time(), 2), 0.01);
    for (std::size_t i = 0; i < now.size(); ++i) EXPECT_LT((now[i] - start[i] - fall).norm(), 1e-9);
    while (simulation.status() == RunStatus::running) simulation.step();
    EXPECT_EQ(simulation.status(), RunStatus::settled) << simulation.status_detail();
    EXPECT_LT(simulation.work().flying_particle_steps, 0.5 * simulation.work().particle_steps);
}

/// Whether a run's advice names the effect.
bool advises(const Scene& scene, const std::string& effect) {
    const std::vector<std::string> advice = run_scene(scene).advice;
    return std::any_of(advice.begin(), advice.end(), [&](const std::string& sentence) {
        return sentence.find("[effects." + effect + "] may matter") != std::string::npos;
    });
}

TEST(Advice, NamesCohesionWhereMoistureCouldHoldTheSource) {
    Scene scene = scenes::aluminium_column(21.9, 0.0125);
    const std::vector<std::string> advice = run_scene(scene).advice;
    // rho g H / (4 tan(45 + phi/2)) = 2079.5 x 9.81 x 0.1 / (4 x 1.480)
    ASSERT_FALSE(advice.empty());
    EXPECT_NE(advice.back().find("A cohesion of 0.34 kPa"), std::string::npos) << advice.back();
    EXPECT_TRUE(advises(scene, "cohesion"));
    scene.effects.cohesion = Cohesion{.strength = 10.0};
    EXPECT_FALSE(advises(scene, "cohesion")) << "it is on";
    scene.effects.cohesion.reset();
    scene.run.gravity = 9.81e3;
    EXPECT_FALSE(advises(scene, "cohesion")) << "345 kPa are more than moisture gives";
}

TEST(Advice, NamesTheRateWhereTheFrontIsFast) {
    Scene scene = scenes::box(70, 0.385, 0.005);
    EXPECT_TRUE(advises(scene, "rate"));
    scene.effects.rate = RateDependence{.increase = 0.0};
    EXPECT_FALSE(advises(scene, "rate")) << "it is on";
    EXPECT_FALSE(advises(scenes::heap(15, 0.1, 30, 0.01), "rate")) << "nothing moves";
}

TEST(Combinations, EveryPairRunsToItsEndAndKeepsTheInvariants) {
    const std::vector<Choice> all = choices();
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            Scene scene = scenes::aluminium_column(21.9, 0.0125);
            all[i].active(scene.effects);
            all[j].active(scene.effects);
            const RunResult result = run_scene(scene);
            EXPECT_TRUE(result.status == RunStatus::settled || result.status == RunStatus::stable)
                << all[i].name << " with " << all[j].name << ": " << to_string(result.status) << " "
                << result.status_detail;
        }
    }
}

}  // namespace
}  // namespace runout
