// Soil at rest sleeps, and wakes in time; see docs/effects.md, "What a step leaves out".

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/simulation.h"
#include "engine/watch/sleep_watch.h"
#include "observe.h"
#include "run/run_scene.h"
#include "scene/make_problem.h"
#include "scenes.h"

namespace runout {
namespace {

constexpr double spacing = 0.01;
constexpr double window = 0.1;  // s

/// A block of soil at rest, 24 x 8 particles, watched.
struct Block {
    Discretisation discretisation = make_discretisation(spacing, 1.3, 2000.0);
    SleepWatch watch{discretisation, 9.81, window};
    Soil soil;
    std::vector<double> density;
    double time = 0;

    Block() {
        std::vector<Vec2> points;
        for (int i = 0; i < 24; ++i)
            for (int j = 0; j < 8; ++j) points.emplace_back((i + 0.5) * spacing, (j + 0.5) * spacing);
        soil = soil_at(points);
        density.assign(soil.x.size(), 1.0);
        watch.wake_all(soil, 0.0);
    }

    void pass(double dt) {
        time += dt;
        watch.observe(soil, density, time);
    }
    /// Number of particles in slices that rest, and the least x of them.
    int sleeping(double& from) const {
        std::vector<char> slices;
        const int count = watch.find_sleeping(soil, slices);
        from = 1e9;
        for (int i = 0; i < soil.count; ++i)
            if (count > 0 && slices[static_cast<std::size_t>(i / lanes)]) from = std::min(from, soil.x[i]);
        return count;
    }
    int sleeping() const {
        double from;
        return sleeping(from);
    }
};

TEST(SleepWatch, SoilAtRestSleepsAfterTwoWindows) {
    Block block;
    for (int k = 0; k < 10; ++k) block.pass(0.019);
    EXPECT_EQ(block.sleeping(), 0) << "one window has closed";
    for (int k = 0; k < 3; ++k) block.pass(0.019);
    EXPECT_EQ(block.sleeping(), block.soil.count);
}

TEST(SleepWatch, WhatIsNearMovingSoilStaysAwake) {
    Block block;
    for (int k = 0; k < 30; ++k) {
        for (int i = 0; i < 8; ++i) block.soil.y[i] += 0.05 * spacing;  // the first column rises
        block.pass(0.02);
    }
    double from;
    EXPECT_GT(block.sleeping(from), block.soil.count / 2);
    EXPECT_GT(from, 2.6 * spacing) << "more than a kernel support from the first column";
    EXPECT_LT(from, 9.0 * spacing);
}

TEST(SleepWatch, MotionAndAChangeOfLoadWakeWhatIsNearAtOnce) {
    for (const bool by_load : {false, true}) {
        Block block;
        for (int k = 0; k < 15; ++k) block.pass(0.02);
        ASSERT_EQ(block.sleeping(), block.soil.count);
        if (by_load)
            block.soil.pressure[0] += 2000.0 * 9.81 * spacing;
        else
            block.soil.x[0] -= 0.1 * spacing;
        block.pass(1e-4);
        double from;
        EXPECT_LT(block.sleeping(from), block.soil.count);
        EXPECT_GT(block.sleeping(from), 0) << "what is far sleeps on";
        EXPECT_GT(from, 2.6 * spacing);
    }
}

TEST(SleepWatch, SoilThatGetsFasterIsNotTakenForQuiet) {
    Block block;
    const double start = block.soil.x[0];
    for (int k = 0; k < 100 && block.soil.x[0] - start < spacing; ++k) {
        block.pass(0.02);
        // 0.5 a t^2 with 0.0125 spacings in the first window, which alone would pass for rest.
        const double path = 0.0125 * spacing * std::pow(block.time / window, 2);
        for (int i = 0; i < block.soil.count; ++i) {
            if (k > 0) block.soil.x[i] -= 0.0125 * spacing * std::pow((block.time - 0.02) / window, 2);
            block.soil.x[i] += path;
        }
        ASSERT_EQ(block.sleeping(), 0) << "at t = " << block.time;
    }
}

/// Runs to the end. `asleep`: share of the particle steps.
RunResult run_with(Scene scene, bool sleeping, double& asleep) {
    scene.run.sleeping = sleeping;
    RunResult result = run_scene(scene);
    asleep = result.work.spared_share;  // nothing flies free here
    return result;
}

/// A layer of soil on a long flat in front of the column that comes down on it.
Scene long_layer() {
    Scene scene =
        scenes::polygon({{0, 0.2}, {0, 0}, {3.0, 0}}, {{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}}, 21.9, 0.008);
    scene.effects.erodible_bed = ErodibleBed{.depth = 0.04, .from = 0.2, .to = 2.8};
    return scene;
}

TEST(Sleep, ALayerSleepsUntilTheDebrisReachesItAndTheRunOutIsTheSame) {
    double asleep, none;
    const RunResult with = run_with(long_layer(), true, asleep);
    const RunResult without = run_with(long_layer(), false, none);
    EXPECT_GT(asleep, 0.5);
    EXPECT_EQ(none, 0.0);
    ASSERT_EQ(with.status, RunStatus::settled) << with.status_detail;
    ASSERT_EQ(without.status, RunStatus::settled) << without.status_detail;
    EXPECT_NEAR(with.measures.run_out_m, without.measures.run_out_m, 0.008);
    EXPECT_NEAR(with.measures.eroded_area_m2, without.measures.eroded_area_m2,
                0.02 * without.measures.eroded_area_m2 + 4 * 0.008 * 0.008);
}

TEST(Sleep, ADepositWakesUnderTheNextMass) {
    Scene scene = scenes::aluminium_column(21.9, 0.008);
    scene.effects.release = StagedRelease{.masses = {scenes::mass_above_column(scene, 1.5, 0.1)}};
    // The front of one run depends on the lattice that it starts from by two spacings.
    double with = 0.0, without = 0.0;
    for (int seed = 1; seed <= 4; ++seed) {
        scene.run.lattice_seed = seed;
        double asleep, none;
        const RunResult result = run_with(scene, true, asleep);
        EXPECT_EQ(result.status, RunStatus::settled) << result.status_detail;
        EXPECT_GT(asleep, 0.0);
        with += 0.25 * result.measures.run_out_m;
        without += 0.25 * run_with(scene, false, none).measures.run_out_m;
    }
    EXPECT_NEAR(with, without, 0.008);
}

TEST(Sleep, LayersPouredOnASleepingHeapMakeTheSameHeap) {
    Scene scene =
        scenes::polygon({{0, 0.5}, {0, 0}, {1.0, 0}}, {{0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1}}, 30.0, 0.01);
    scene.effects.release = StagedRelease{8, 0.06, 0.02};
    double asleep, none;
    const RunResult with = run_with(scene, true, asleep);
    const RunResult without = run_with(scene, false, none);
    EXPECT_GT(asleep, 0.05);
    ASSERT_EQ(with.status, RunStatus::settled) << with.status_detail;
    // Where single grains come to lie is chance; the heap is not.
    EXPECT_NEAR(with.measures.deposit_height_m, without.measures.deposit_height_m, 0.015);
    EXPECT_NEAR(with.measures.run_out_m, without.measures.run_out_m, 0.03);
}

TEST(Sleep, ASlabThatStartsSlowlyIsNotHeldBack) {
    // 0.6 deg steeper than the soil can stand: a / g = 0.012.
    Scene scene = scenes::slab(27.2, 40, 6, 30.0, 0.01);
    Simulation awake([&] {
        Scene s = scene;
        s.run.sleeping = false;
        return make_problem(s);
    }());
    Simulation simulation(make_problem(scene));
    while (simulation.time() < 0.5) simulation.step();
    while (awake.time() < 0.5) awake.step();
    EXPECT_EQ(simulation.work().sleeping_particle_steps, 0.0);
    EXPECT_EQ(positions_by_id(simulation), positions_by_id(awake));
}

TEST(Sleep, NothingSleepsWhileTheGroundShakesOrWhereFrictionIsExplicit) {
    Scene scene = scenes::heap(15, 0.1, 30, 0.01);
    double asleep;
    run_with(scene, true, asleep);
    EXPECT_GT(asleep, 0.0);
    scene.effects.shaking = Shaking{};
    scene.effects.shaking->time = {0.0, 3.0};
    scene.effects.shaking->horizontal = scene.effects.shaking->vertical = {0.0, 0.0};
    Simulation shaken(make_problem(scene));
    while (shaken.time() < 2.9) shaken.step();
    EXPECT_EQ(shaken.work().sleeping_particle_steps, 0.0);
    scene.effects.shaking.reset();
    scene.run.friction = FrictionScheme::explicit_;
    scene.run.time_limit = 0.5;
    run_with(scene, true, asleep);
    EXPECT_EQ(asleep, 0.0);
}

TEST(Sleep, IsTheSameOnTwoThreads) {
    Scene scene = long_layer();
    scene.run.particle_spacing = 0.005;  // enough for two
    std::vector<std::vector<Vec2>> ends;
    for (const int threads : {1, 2}) {
        scene.run.threads = threads;
        Simulation simulation(make_problem(scene));
        while (simulation.time() < 0.4) simulation.step();
        EXPECT_GT(simulation.work().sleeping_particle_steps, 0.0);
        ends.push_back(positions_by_id(simulation));
    }
    EXPECT_EQ(ends[0], ends[1]);
}

}  // namespace
}  // namespace runout
