// The same scene seen from elsewhere, at another size or with another gravity: what must be equal, and how
// equal. Rounding decides the ways of single grains, which is why the mass is compared and not each particle.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "engine/simulation.h"
#include "hard/hard_scenes.h"
#include "scene/make_problem.h"

namespace runout {
namespace {

struct Ending {
    RunStatus status = RunStatus::running;
    long steps = 0;
    double time_in_units = 0;  ///< in sqrt(sqrt(S)/g)
    Vec2 centroid;             ///< of the mass, in sqrt(S)
    std::vector<Vec2> positions;
};

Ending ending_of(const Scene& scene) {
    Simulation simulation(make_problem(scene));
    while (simulation.status() == RunStatus::running) simulation.step();
    const StateView state = simulation.state();
    Ending ending{simulation.status(), simulation.work().steps, simulation.time() / simulation.time_scale(),
                  Vec2(0, 0), std::vector<Vec2>(state.x.size())};
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        ending.positions[state.id[i]] = {state.x[i], state.y[i]};
        ending.centroid += ending.positions[state.id[i]];
    }
    ending.centroid /= static_cast<double>(state.x.size()) * std::sqrt(scene.source.area);
    return ending;
}

/// The plain slope that all of them depart from, with nothing of its own.
StressPoint plain_point() {
    StressPoint p = plain_hard_point();
    p.resolution = 8;
    return p;
}

TEST(SameResult, MirroredSectionsGiveTheSameBits) {
    StressPoint mirrored = plain_point();
    mirrored.reversed = 1.5;
    EXPECT_EQ(ending_of(stress_scene(plain_point(), "plain")).positions,
              ending_of(stress_scene(mirrored, "mirrored")).positions);
}

void expect_same_mass(const StressPoint& point, double tolerance) {
    const Ending plain = ending_of(stress_scene(plain_point(), "plain"));
    const Ending other = ending_of(stress_scene(point, "other"));
    const double apart = (plain.centroid - other.centroid).norm();
    EXPECT_EQ(other.status, plain.status);
    EXPECT_LT(apart, tolerance) << "of the centroids, in sqrt(S)";
    EXPECT_NEAR(other.time_in_units, plain.time_in_units, 0.2 * plain.time_in_units);
    testing::Test::RecordProperty("centroids_apart", std::to_string(apart));
    testing::Test::RecordProperty("steps", std::to_string(plain.steps) + " " + std::to_string(other.steps));
}

TEST(SameResult, AMillionMetresAwayTheMassIsTheSame) {
    StressPoint p = plain_point();
    p.offset_m = 1e6;
    expect_same_mass(p, 0.01);
}

TEST(SameResult, AThousandTimesLargerTheMassIsTheSame) {
    StressPoint p = plain_point();
    p.size_m *= 1e3;
    expect_same_mass(p, 0.01);
}

TEST(SameResult, UnderAThousandTimesTheGravityTheMassIsTheSame) {
    StressPoint p = plain_point();
    p.gravity_m_s2 *= 1e3;
    expect_same_mass(p, 0.01);
}

/// FNV-1a over the bits of all coordinates.
std::uint64_t digest(const std::vector<Vec2>& points) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const Vec2& p : points)
        for (const double c : {p.x(), p.y()})
            for (int byte = 0; byte < 8; ++byte)
                hash = (hash ^ (std::bit_cast<std::uint64_t>(c) >> (8 * byte) & 0xFFU)) * 0x100000001b3U;
    return hash;
}

// Debug, release and sanitizer builds, of g++ and of clang++, must all find this. What changes the engine's
// results changes the number too, and then the failure shows the new one.
TEST(SameResult, EveryBuildGivesTheSameBits) {
    const Ending ending = ending_of(stress_scene(plain_point(), "plain"));
    EXPECT_EQ(ending.steps, 396);
    EXPECT_EQ(digest(ending.positions), 7209191884852067799U);
}

}  // namespace
}  // namespace runout
