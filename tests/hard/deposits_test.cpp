// Deposits of random scenes, left alone: what friction has brought to rest stays there.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "core/input_error.h"
#include "engine/simulation.h"
#include "hard/creep.h"
#include "scene/make_problem.h"
#include "stress/stress_scene.h"

namespace runout {

/// The scenes that `runout stress --scenes N --seed N` draws, until so many of them have come to rest.
struct RandomDeposits {
    std::uint64_t seed = 0;
    int scenes = 0;
    int deposits = 0;             ///< as many at most
    double resolution = 0;        ///< sqrt(S)/dl; 0: that of each scene, 5 to 12
    std::vector<int> known = {};  ///< whose grains creep a spacing: open, see docs/stability.md
};

/// For the names of the tests.
void PrintTo(const RandomDeposits& deposits, std::ostream* out) {
    *out << "seed_" << deposits.seed;
    if (deposits.resolution > 0) *out << "_at_" << deposits.resolution;
}

namespace {

/// None where the mass does not fit the hillside. Nothing sleeps: friction alone must hold it.
std::optional<Scene> random_scene(const StressPoint& point, double resolution) {
    try {
        Scene scene = stress_scene(point, "random");
        if (resolution > 0) scene.run.resolution = resolution;
        scene.run.sleeping = false;
        return scene;
    } catch (const InputError&) {
        return {};
    }
}

class RandomDepositsTest : public testing::TestWithParam<RandomDeposits> {};

TEST_P(RandomDepositsTest, StandButForThoseKnown) {
    const RandomDeposits& asked = GetParam();
    const std::vector<StressPoint> points = stress_points(stress_axes(), asked.scenes, asked.seed);
    std::vector<int> crept;
    int deposits = 0;
    double furthest = 0, fallen = 0;
    for (int k = 0; k < asked.scenes && deposits < asked.deposits; ++k) {
        const std::optional<Scene> scene =
            random_scene(points[static_cast<std::size_t>(k)], asked.resolution);
        if (!scene) continue;
        ++deposits;
        Simulation simulation(make_problem(*scene));
        while (simulation.status() == RunStatus::running) simulation.step();
        ASSERT_TRUE(is_result(simulation.status())) << "scene " << k << ": " << simulation.status_detail();
        const Creep creep = leave_alone(simulation, *scene);
        std::printf("scene %d: moved by %.3g spacings, fell by %.2g M g sqrt(S)\n", k,
                    creep.moved_spacings.back(), creep.energy_lost);
        furthest = std::max(furthest, creep.moved_spacings.back());
        fallen = std::max(fallen, creep.energy_lost);
        if (creep.moved_spacings.back() >= 1.0 || creep.energy_lost >= 1e-4) crept.push_back(k);
    }
    RecordProperty("deposits", deposits);
    RecordProperty("furthest_spacings", std::to_string(furthest));
    RecordProperty("greatest_energy_lost", std::to_string(fallen));
    EXPECT_EQ(crept, asked.known);
}

// Scene 45 of seed 3: a chain of grains two spacings apart, on a base of 2.04 deg that falls nearly as
// steeply.
INSTANTIATE_TEST_SUITE_P(FullSmall, RandomDepositsTest,
                         testing::Values(RandomDeposits{1, 1000, 1000, 0}, RandomDeposits{2, 1000, 1000, 0},
                                         RandomDeposits{3, 1000, 1000, 0, {45}}),
                         testing::PrintToStringParamName());

// About 1,000 particles. Films creep (7), a heap sinks a little more than it should (10), and grains come off
// the edge of a ledge (16).
INSTANTIATE_TEST_SUITE_P(FullAtSize, RandomDepositsTest,
                         testing::Values(RandomDeposits{991, 150, 15, 32, {7, 10, 16}}),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace runout
