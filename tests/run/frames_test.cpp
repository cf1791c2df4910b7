// Pictures of the particles for the animation: how many, which, and how true.

#include "run/frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run/run_scene.h"
#include "scenes.h"

namespace runout {
namespace {

Scene column() {
    Scene scene = scenes::aluminium_column(21.9, 0.008);
    scene.run.snapshot_times = {0.0, 0.1};
    return scene;
}

RunResult run_with(int frames) {
    RunControl control;
    control.frames = frames;
    return run_scene(column(), control);
}

double decoded(double low, double step, unsigned code) {
    return low + step * code;
}

TEST(Frames, AreNoneUnlessAskedFor) {
    EXPECT_TRUE(run_scene(column()).frames.empty());
}

TEST(Frames, DoNotChangeTheRun) {
    const RunResult without = run_with(0), with = run_with(20);
    EXPECT_EQ(with.work.steps, without.work.steps);
    for (const MeasureField& field : measure_fields()) {
        if (std::isnan(without.measures.*field.value)) {
            EXPECT_TRUE(std::isnan(with.measures.*field.value)) << field.name;
        } else {
            EXPECT_EQ(with.measures.*field.value, without.measures.*field.value) << field.name;
        }
    }
}

TEST(Frames, AreAtMostAsManyAsAskedAndSpanTheRunEvenly) {
    for (const int most : {1, 2, 7, 60}) {
        const RunResult result = run_with(most);
        const auto& frames = result.frames;
        ASSERT_FALSE(frames.empty());
        EXPECT_LE(frames.size(), static_cast<std::size_t>(std::max(most, 2))) << most;
        EXPECT_GE(frames.size(), static_cast<std::size_t>(most) / 2);
        EXPECT_EQ(frames.front().scale.time_s, 0.0);
        EXPECT_EQ(frames.back().scale.time_s, result.work.simulated_s);
        if (most != 60) continue;
        const double usual = frames[2].scale.time_s - frames[1].scale.time_s;
        for (std::size_t k = 1; k + 1 < frames.size(); ++k)
            EXPECT_NEAR(frames[k].scale.time_s - frames[k - 1].scale.time_s, usual, 0.5 * usual) << k;
    }
}

TEST(Frames, ShowTheParticlesWhereTheyAre) {
    const RunResult result = run_with(40);
    const Frame& first = result.frames.front();
    const Snapshot& start = result.snapshots.front();
    ASSERT_EQ(first.x.size(), start.x_m.size());
    const FrameScale& s = first.scale;
    double greatest = 0;
    for (std::size_t i = 0; i < first.x.size(); ++i) {
        // The snapshot is one step later than the picture at time 0.
        greatest = std::max(greatest, std::abs(decoded(s.x_low_m, s.x_step_m, first.x[i]) - start.x_m[i]));
        greatest = std::max(greatest, std::abs(decoded(s.y_low_m, s.y_step_m, first.y[i]) - start.y_m[i]));
    }
    EXPECT_LT(greatest, 0.05 * result.work.particle_spacing_m);
    EXPECT_LT(s.x_step_m, 1e-3 * result.work.particle_spacing_m * 10);
    for (const Frame& frame : result.frames) {
        EXPECT_EQ(frame.x.size(), frame.y.size());
        EXPECT_EQ(frame.x.size(), frame.speed.size());
        EXPECT_EQ(frame.x.size(), frame.pressure.size());
    }
    const auto fastest = [](const Frame& frame) { return *std::ranges::max_element(frame.speed); };
    EXPECT_EQ(fastest(result.frames.back()) < 30, true) << "all but at rest at the end";
    EXPECT_EQ(std::ranges::max(result.frames, {}, fastest).speed.size(), first.x.size());
}

TEST(Frames, OfManyParticlesShowAnEvenPart) {
    constexpr std::size_t particles = 40'000;
    std::size_t shown = 0, gap = 0, longest_gap = 0;
    for (int id = 0; id < static_cast<int>(particles); ++id) {
        gap = is_shown(id, particles) ? 0 : gap + 1;
        shown += is_shown(id, particles) ? 1 : 0;
        longest_gap = std::max(longest_gap, gap);
    }
    EXPECT_NEAR(static_cast<double>(shown), frame_particles, 2.0);
    EXPECT_LE(longest_gap, 16u) << "one of ten is shown";
    for (int id = 0; id < 100; ++id) EXPECT_TRUE(is_shown(id, frame_particles));
}

}  // namespace
}  // namespace runout
