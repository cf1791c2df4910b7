// Named hard scenes: each settles by itself with every invariant kept, and its deposit then stands.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <optional>
#include <ostream>
#include <string>

#include "core/input_error.h"
#include "engine/simulation.h"
#include "hard/hard_scenes.h"
#include "observe.h"
#include "scene/make_problem.h"

namespace runout {

/// For the names of the tests.
void PrintTo(const HardScene& scene, std::ostream* out) {
    *out << scene.name;
}

namespace {

/// Height of the source above the lowest bed, m.
double fall_height(const Scene& scene) {
    double top = scene.source.outline.front().y();
    double floor = scene.source.bed.front().y();
    for (const Vec2& p : scene.source.outline) top = std::max(top, p.y());
    for (const Vec2& p : scene.source.bed) floor = std::min(floor, p.y());
    return top - floor;
}

/// Distances between two states in spacings, in rising order.
std::vector<double> moved_spacings(const std::vector<Vec2>& from, const std::vector<Vec2>& to,
                                   double spacing) {
    std::vector<double> moved;
    for (std::size_t i = 0; i < from.size(); ++i) moved.push_back((to[i] - from[i]).norm() / spacing);
    std::ranges::sort(moved);
    return moved;
}

/// Leaves a deposit for another 100 sqrt(H/g): how far each particle then is from its place, in spacings, in
/// rising order.
std::vector<double> creep(Simulation& simulation, const Scene& scene) {
    const std::vector<Vec2> deposit = positions_by_id(simulation);
    const double end = simulation.time() + 100 * std::sqrt(fall_height(scene) / scene.run.gravity);
    while (simulation.time() < end) simulation.step();
    return moved_spacings(deposit, positions_by_id(simulation), simulation.state().discretisation->spacing);
}

class HardSceneTest : public testing::TestWithParam<HardScene> {};

TEST_P(HardSceneTest, SettlesAndThenStands) {
    const Scene scene = GetParam().make();
    Simulation simulation(make_problem(scene));
    const std::size_t particles = simulation.state().x.size();
    while (simulation.status() == RunStatus::running) simulation.step();
    ASSERT_TRUE(is_result(simulation.status()))
        << to_string(simulation.status()) << ": " << simulation.status_detail();
    if (!scene.effects.release) {
        EXPECT_EQ(simulation.state().x.size(), particles);
    }
    for (int k = 0; k < static_cast<int>(Invariant::count); ++k) {
        const InvariantReading& reading = simulation.invariants()[static_cast<std::size_t>(k)];
        EXPECT_LE(reading.worst, reading.limit) << to_string(static_cast<Invariant>(k));
    }

    const std::vector<double> moved = creep(simulation, scene);
    RecordProperty("creep_spacings", std::to_string(moved.back()));
    const auto beyond = moved.end() - std::ranges::lower_bound(moved, 1.0);
    RecordProperty("beyond_a_spacing", std::to_string(beyond));
    EXPECT_EQ(beyond, 0) << "particles that moved a spacing or more, the furthest by " << moved.back();
}

std::string name_of(const testing::TestParamInfo<HardScene>& info) {
    return info.param.name;
}

std::vector<HardScene> scenes_where(bool quick) {
    std::vector<HardScene> chosen;
    for (const HardScene& scene : hard_scenes())
        if (scene.quick == quick) chosen.push_back(scene);
    return chosen;
}

INSTANTIATE_TEST_SUITE_P(Quick, HardSceneTest, testing::ValuesIn(scenes_where(true)), name_of);
INSTANTIATE_TEST_SUITE_P(Full, HardSceneTest, testing::ValuesIn(scenes_where(false)), name_of);

/// A scene of `runout stress`; none where the mass does not fit the hillside.
std::optional<Scene> random_scene(const StressPoint& point) {
    try {
        return stress_scene(point, "random");
    } catch (const InputError&) {
        return {};
    }
}

/// The thousand scenes that `runout stress --scenes 1000 --seed N` draws.
struct RandomDeposits {
    std::uint64_t seed = 0;
    std::vector<std::size_t> known;  ///< whose grains creep a spacing: open, see docs/stability.md
};

void PrintTo(const RandomDeposits& deposits, std::ostream* out) {
    *out << "seed_" << deposits.seed;
}

class RandomDepositsTest : public testing::TestWithParam<RandomDeposits> {};

TEST_P(RandomDepositsTest, StandButForThoseKnown) {
    std::vector<std::size_t> crept;
    const std::vector<StressPoint> points = stress_points(stress_axes(), 1000, GetParam().seed);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const std::optional<Scene> scene = random_scene(points[k]);
        if (!scene) continue;
        Simulation simulation(make_problem(*scene));
        while (simulation.status() == RunStatus::running) simulation.step();
        ASSERT_TRUE(is_result(simulation.status())) << "scene " << k << ": " << simulation.status_detail();
        const double furthest = creep(simulation, *scene).back();
        if (furthest > 0.3) std::cout << "scene " << k << ": " << furthest << " spacings\n";
        if (furthest >= 1.0) crept.push_back(k);
    }
    EXPECT_EQ(crept, GetParam().known);
}

// Scene 45 of seed 3: a chain of grains two spacings apart, on a base of 2.04 deg that falls nearly as
// steeply.
INSTANTIATE_TEST_SUITE_P(Full, RandomDepositsTest,
                         testing::Values(RandomDeposits{1, {}}, RandomDeposits{2, {}},
                                         RandomDeposits{3, {45}}),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace runout
