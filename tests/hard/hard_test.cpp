// Named hard scenes: each settles by itself with every invariant kept, and its deposit then stands.

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>

#include "engine/simulation.h"
#include "hard/creep.h"
#include "hard/hard_scenes.h"
#include "scene/make_problem.h"

namespace runout {

/// For the names of the tests.
void PrintTo(const HardScene& scene, std::ostream* out) {
    *out << scene.name;
}

namespace {

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

    const std::vector<double> moved = leave_alone(simulation, scene).moved_spacings;
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

// 256, 1,024 and 4,096 particles.
INSTANTIATE_TEST_SUITE_P(QuickAtSize, HardSceneTest, testing::ValuesIn(hard_scenes_at(16, true)), name_of);
INSTANTIATE_TEST_SUITE_P(FullAt32, HardSceneTest, testing::ValuesIn(hard_scenes_at(32, false)), name_of);
INSTANTIATE_TEST_SUITE_P(FullAt64, HardSceneTest, testing::ValuesIn(hard_scenes_at(64, true)), name_of);

}  // namespace
}  // namespace runout
