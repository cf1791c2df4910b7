// A run ends early where what still creeps can no longer matter, and goes on where it can.

#include <gtest/gtest.h>

#include <string>

#include "engine/simulation.h"
#include "measures/front_rule.h"
#include "run/creep_watch.h"
#include "run/run_scene.h"
#include "scene/make_problem.h"
#include "scenes.h"

namespace runout {
namespace {

/// Looks on while a mass goes through `windows` windows of the watch, whatever the engine says of its rest.
CreepWatch watched(const Scene& scene, int windows) {
    Simulation simulation(make_problem(scene));
    ReachRecorder reach(front_rule(scene), simulation.state());
    CreepWatch creep(scene, simulation);
    const double end = windows * CreepWatch::window_time_scales * simulation.time_scale();
    while (simulation.time() < end && !creep.negligible()) {
        simulation.step();
        reach.look(simulation.state());
        creep.look(simulation, reach);
    }
    return creep;
}

/// A heap that stands, 13.7 m long, on level ground up to the edge of a drop.
Scene heap_before_edge(double edge) {
    return scenes::polygon({{0, 10}, {0, 0}, {edge, 0}, {edge + 5, -10}, {edge + 30, -10}},
                           {{0, 0}, {13.7, 0}, {0, 5}}, 30.0, 0.5);
}

TEST(Creep, OfAHeapThatStandsIsNegligible) {
    const CreepWatch creep = watched(heap_before_edge(20), 6);
    EXPECT_TRUE(creep.negligible());
    EXPECT_NE(creep.sentence().find("% of the soil still crept"), std::string::npos) << creep.sentence();
}

/// Whatever little energy is left: a grain pushed over the edge goes all the way.
TEST(Creep, BeforeAnEdgeIsNeverNegligible) {
    EXPECT_FALSE(watched(heap_before_edge(14.2), 6).negligible());
}

TEST(Creep, IsNotJudgedWhereWaterChangesTheStrength) {
    Scene scene = scenes::heap(10.0, 5.0, 30.0, 0.5);
    scene.effects.pore_pressure = PorePressure{};
    scene.effects.pore_pressure->ratio = 0.2;
    EXPECT_FALSE(watched(scene, 5).negligible());
}

TEST(Creep, DoesNotEndARunThatComesToRestByItself) {
    Scene scene = scenes::box(70.0, 0.4, 0.004);
    const RunResult result = run_scene(scene);
    EXPECT_EQ(result.status, RunStatus::settled);
    for (const std::string& sentence : result.advice) EXPECT_FALSE(sentence.starts_with("Ended")) << sentence;
}

}  // namespace
}  // namespace runout
