// Effects that change what lies in the way, or when the soil comes: barrier, places, later masses, erodible
// bed.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/simulation.h"
#include "run/run_scene.h"
#include "scene/make_problem.h"
#include "scenes.h"

namespace runout {
namespace {

constexpr double g = 9.81;

/// Water-like block against a wall, with a barrier.
Scene dam(double length, double barrier_x, double spacing) {
    Scene scene = scenes::polygon({{0, 0.2}, {0, 0}, {2, 0}}, {{0, 0}, {length, 0}, {length, 0.1}, {0, 0.1}},
                                  0.0, spacing);
    scene.effects.barrier = Barrier{.x = barrier_x, .height = 0.15, .thickness = 0.05};
    return scene;
}

TEST(BarrierLoad, AtRestItIsTheHydrostaticLoad) {
    const Scene scene = dam(0.2, 0.2, 0.005);
    Simulation simulation(make_problem(scene));
    while (simulation.time() < 0.3) simulation.step();
    const BarrierForce& load = *simulation.barrier_force();
    const double force = 0.5 * scene.material.density * g * 0.01;
    EXPECT_NEAR(load.force.x(), force, 0.03 * force);
    EXPECT_NEAR(load.moment, force * 0.1 / 3.0, 0.06 * force * 0.1 / 3.0);
    EXPECT_NEAR(load.impulse.x(), force * simulation.time(), 0.03 * force * simulation.time());
}

TEST(BarrierLoad, ItsImpulseIsTheMomentumThatTheSoilLoses) {
    const Scene scene = dam(0.1, 0.5, 0.004);
    Simulation simulation(make_problem(scene));
    const auto momentum = [&] {
        const StateView state = simulation.state();
        double sum = 0.0;
        for (const double v : state.vx) sum += v;
        return state.discretisation->mass() * sum;
    };
    while (simulation.barrier_force()->impulse.x() < 0.1) simulation.step();
    const double before = momentum() + simulation.barrier_force()->impulse.x();
    double others = 0.0;  // impulse on the rest of the bed, above all on the wall behind
    const double start = simulation.time();
    double last = start;
    while (simulation.time() < start + 0.15) {
        simulation.step();
        others +=
            (simulation.bed_force().x() - simulation.barrier_force()->force.x()) * (simulation.time() - last);
        last = simulation.time();
    }
    const double impulse = simulation.barrier_force()->impulse.x();
    EXPECT_GT(impulse, 5.0);
    EXPECT_NEAR(momentum() + impulse + others, before, 0.03 * impulse);
}

TEST(Places, WhatPassesIsWhatLiesBeyondAndWhatFlowed) {
    Scene scene = scenes::aluminium_column(21.9, 0.005);
    scene.places = {{"first", 0.25}, {"second", 0.3}, {"far", 1.0}};
    scene.run.snapshot_times = {0.3};
    const RunResult result = run_scene(scene);
    ASSERT_EQ(result.places.size(), 3U);
    const PlaceRecord& first = result.places[0];
    ASSERT_EQ(result.snapshots.size(), 1U);
    const Snapshot& state = result.snapshots[0];
    const double beyond = static_cast<double>(std::count_if(state.x_m.begin(), state.x_m.end(),
                                                            [](float x) { return x > 0.25F; })) *
                          0.005 * 0.005;
    const auto after = std::find_if(first.rows.begin(), first.rows.end(),
                                    [&](const PlaceRow& row) { return row.time_s >= state.time_s; });
    ASSERT_NE(after, first.rows.end());
    EXPECT_NEAR(after->passed_area_m2, beyond, 0.03 * beyond);
    double flowed = 0.0;
    for (std::size_t i = 1; i < first.rows.size(); ++i)
        flowed += 0.5 *
                  (first.rows[i].thickness_m * first.rows[i].speed_m_s +
                   first.rows[i - 1].thickness_m * first.rows[i - 1].speed_m_s) *
                  (first.rows[i].time_s - first.rows[i - 1].time_s);
    EXPECT_NEAR(flowed, first.passed_area_m2, 0.1 * first.passed_area_m2);
    EXPECT_LT(first.arrival_time_s, result.places[1].arrival_time_s);
    EXPECT_NEAR(first.greatest_kinetic_head_m, std::pow(first.greatest_speed_m_s, 2) / (2.0 * g), 1e-9);
    EXPECT_TRUE(std::isnan(result.places[2].arrival_time_s));
    EXPECT_EQ(result.places[2].passed_area_m2, 0.0);
}

TEST(LaterMasses, LandOnTheDepositOfTheFirst) {
    Scene scene = scenes::aluminium_column(21.9, 0.008);
    const LaterMass dropped = scenes::mass_above_column(scene, 5.0, 0.05);
    scene.effects.release = StagedRelease{.masses = {dropped}};
    Simulation simulation(make_problem(scene));
    const std::size_t first = simulation.state().x.size();
    while (simulation.status() == RunStatus::running) simulation.step();
    EXPECT_EQ(simulation.status(), RunStatus::settled) << simulation.status_detail();
    EXPECT_GT(simulation.time(), 5.0);
    const StateView state = simulation.state();
    EXPECT_NEAR(static_cast<double>(state.x.size() - first), dropped.mass.area / (0.008 * 0.008), 6.0);
    // Where it fell it lies on the soil of the first.
    double earlier = 0.0, later = 0.0;
    int earlier_count = 0, later_count = 0;
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        if (state.x[i] > 0.1) continue;
        const bool is_later = state.id[i] >= static_cast<int>(first);
        (is_later ? later : earlier) += state.y[i];
        ++(is_later ? later_count : earlier_count);
    }
    EXPECT_GT(later / later_count, 1.5 * earlier / earlier_count);
}

/// Column beside a layer of the same soil, `depth` deep.
Scene on_erodible_bed(double depth) {
    Scene scene = scenes::aluminium_column(21.9, 0.008);
    scene.effects.erodible_bed = ErodibleBed{.depth = depth, .from = 0.2, .to = 0.6};
    return scene;
}

// The debris takes the upper 3 to 4 mm of the layer, however deep that is.
TEST(ErodibleBed, SourceAndErodedSoilMakeTheDebris) {
    for (const double depth : {0.016, 0.048}) {
        const Scene scene = on_erodible_bed(depth);
        const RunResult result = run_scene(scene);
        ASSERT_EQ(result.status, RunStatus::settled) << result.status_detail;
        const Measures& m = result.measures;
        EXPECT_GT(m.eroded_area_m2, 0.02 * m.source_area_m2);
        EXPECT_LT(m.eroded_area_m2, 0.06 * m.source_area_m2);
        EXPECT_NEAR(m.deposit_area_m2, m.source_area_m2 + m.eroded_area_m2, 0.04 * m.source_area_m2);
    }
}

}  // namespace
}  // namespace runout
