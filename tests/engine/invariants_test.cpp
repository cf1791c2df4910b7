// Each invariant is seen to be violated, by a state made by hand that violates it alone.

#include "engine/watch/invariants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/watch/rest_watch.h"

namespace runout {
namespace {

constexpr double g = 9.81;
constexpr double height = 2.0;
constexpr double spacing = 0.1;

InvariantScales scales() {
    return {.gravity = g, .height = height, .spacing = spacing, .density = 2000, .courant = 0.1};
}

/// Four particles at rest, and a step that took nothing.
struct HandMade {
    Soil soil = soil_at({{0.0, 1.0}, {0.1, 1.0}, {0.2, 1.0}, {0.3, 1.0}});
    std::vector<double> density{1.0, 1.0, 1.0, 1.0};
    StepFacts step{.time = 0.5, .dt = 1e-3};
    InvariantWatch watch{scales()};

    HandMade() { observe(); }
    void observe() { observe_with(watch, density); }
    void observe_with(InvariantWatch& other, const std::vector<double>& densities) const {
        other.observe(survey(soil, densities, g, 0, soil.count), step);
    }
    [[nodiscard]] std::string violation() const { return watch.violation().value_or(""); }
};

bool begins_with(const std::string& text, const std::string& start) {
    return text.starts_with(start);
}

TEST(Invariants, HoldForSoilAtRest) {
    HandMade state;
    for (int k = 0; k < 1000; ++k) state.observe();
    EXPECT_EQ(state.violation(), "");
}

TEST(SoilSurvey, OfTheWholeIsThatOfItsParts) {
    HandMade state;
    state.soil.vx = {1.0, -3.0, 2.0, 0.5};
    state.soil.pressure = {5.0, 7.0, -2.0, -1.0};
    state.density = {0.9, 1.2, 1.0, 1.3};
    const SoilSurvey whole = survey(state.soil, state.density, g, 0, 4);
    for (int cut = 0; cut <= 4; ++cut) {
        SoilSurvey parts;
        parts += survey(state.soil, state.density, g, 0, cut);
        parts += survey(state.soil, state.density, g, cut, 4);
        EXPECT_EQ(parts.count, 4);
        EXPECT_EQ(parts.numbers, whole.numbers);
        EXPECT_DOUBLE_EQ(parts.energy, whole.energy);
        EXPECT_DOUBLE_EQ(parts.excess, whole.excess);
        EXPECT_EQ(parts.speed2, 9.0);
        EXPECT_EQ(parts.fastest_x, 0.1);
        EXPECT_EQ(parts.density, 1.3);
        EXPECT_EQ(parts.densest_x, 0.3);
        EXPECT_EQ(parts.tension, 2.0);
        EXPECT_EQ(parts.tension_x, 0.2);
        EXPECT_EQ(parts.first_x, 0.0);
        EXPECT_EQ(parts.last_x, 0.3);
    }
    state.soil.vx[1] = std::numeric_limits<double>::quiet_NaN();  // no later part may hide it
    SoilSurvey parts = survey(state.soil, state.density, g, 0, 2);
    parts += survey(state.soil, state.density, g, 2, 4);
    EXPECT_TRUE(std::isnan(parts.speed2));
    EXPECT_EQ(parts.fastest_x, 0.1);
}

TEST(Invariants, SayWhichWhenAndWhere) {
    HandMade state;
    state.step.time = 0.75;
    state.step.greatest_depth = 0.6 * spacing;
    state.step.depth_x = 0.25;
    state.observe();
    EXPECT_TRUE(begins_with(state.violation(), "penetration at t = 0.75 s, x = 0.25 m: "))
        << state.violation();
    const InvariantReading& reading =
        state.watch.readings()[static_cast<std::size_t>(Invariant::penetration)];
    EXPECT_NEAR(reading.worst, 0.6, 1e-12);
    EXPECT_EQ(reading.limit, 0.5);
    EXPECT_EQ(reading.time, 0.75);
    EXPECT_EQ(reading.x, 0.25);
}

TEST(Invariants, TheFirstViolationIsKept) {
    HandMade state;
    state.step.greatest_depth = spacing;
    state.observe();
    const std::string first = state.violation();
    state.soil.pressure[0] = -1e9;
    state.observe();
    EXPECT_EQ(state.violation(), first);
}

TEST(Invariants, ParticlesAreCounted) {
    HandMade state;
    state.soil.id[2] = 1;
    state.observe();
    EXPECT_TRUE(begins_with(state.violation(), "particles")) << state.violation();
}

TEST(Invariants, SpeedIsBoundedByTheFall) {
    HandMade state;
    state.soil.vx[3] = 4.1 * std::sqrt(2 * g * height);
    state.observe();
    EXPECT_TRUE(begins_with(state.violation(), "speed at t = 0.5 s, x = 0.3 m")) << state.violation();
}

TEST(Invariants, ASpeedThatIsNoNumberIsFound) {
    HandMade state;
    state.soil.vy[1] = std::numeric_limits<double>::quiet_NaN();
    state.observe();
    EXPECT_TRUE(begins_with(state.violation(), "speed")) << state.violation();
}

TEST(Invariants, EnergyDoesNotRise) {
    HandMade state;
    for (double& y : state.soil.y) y -= 0.5 * height;  // fell, and the loss is accounted for
    state.step.work_done = 0.5 * g * height;
    state.observe();
    EXPECT_EQ(state.violation(), "");
    for (double& y : state.soil.y) y += 0.06 * height;  // still below the start
    state.step.work_done = 0.44 * g * height;
    state.observe();
    EXPECT_TRUE(begins_with(state.violation(), "energy_rise")) << state.violation();
}

TEST(Invariants, EnergyLostIsWorkDone) {
    HandMade state;
    for (double& y : state.soil.y) y -= 0.5 * height;
    state.observe();
    EXPECT_TRUE(begins_with(state.violation(), "energy_balance")) << state.violation();
}

TEST(Invariants, EnergyIsReckonedAnewFromARelease) {
    HandMade state;
    for (double& y : state.soil.y) y += 0.5 * height;
    state.watch.restart(2 * height);
    state.observe();
    EXPECT_EQ(state.violation(), "");
}

TEST(Invariants, DensityIsBounded) {
    HandMade state;
    state.density[1] = 1.6;
    state.observe();
    EXPECT_TRUE(begins_with(state.violation(), "density at t = 0.5 s, x = 0.1 m")) << state.violation();
}

TEST(Invariants, AreaIsKept) {
    HandMade state;
    state.density = {1.1, 1.1, 1.1, 1.1};
    state.observe();
    EXPECT_TRUE(begins_with(state.violation(), "volume")) << state.violation();
}

TEST(Invariants, ASourceThatStartsCrowdedHasNotLostArea) {
    InvariantWatch watch{scales()};
    const std::vector<double> crowded{1.2, 1.2, 1.2, 1.2};
    const HandMade state;
    state.observe_with(watch, crowded);
    EXPECT_FALSE(watch.violation());
    state.observe_with(watch, {1.0, 1.0, 1.0, 1.0});
    EXPECT_FALSE(watch.violation());
    state.observe_with(watch, crowded);  // once it has loosened this is a loss
    EXPECT_TRUE(watch.violation());
}

TEST(Invariants, PressureDoesNotPull) {
    HandMade state;
    state.soil.pressure[2] = -1e-3;
    state.observe();
    EXPECT_TRUE(begins_with(state.violation(), "pressure at t = 0.5 s, x = 0.2 m")) << state.violation();
}

TEST(Invariants, SolvesThatMissTheirToleranceAreForgivenTwentyTimesInARow) {
    HandMade state;
    state.step.unconverged = 20;
    state.observe();
    EXPECT_EQ(state.violation(), "");
    state.step.unconverged = 21;
    state.observe();
    EXPECT_TRUE(begins_with(state.violation(), "residual")) << state.violation();
}

TEST(Invariants, AGuardThatFiresInEveryStepIsFound) {
    HandMade state;
    state.step.driven_in = 1;
    for (int k = 0; k < 50; ++k) state.observe();
    EXPECT_TRUE(begins_with(state.violation(), "wall_guard")) << state.violation();
}

TEST(Invariants, StepsHaveAFloor) {
    HandMade state;
    state.step.dt = 1e-3 * 0.1 * spacing / std::sqrt(2 * g * height) * 0.9;
    state.observe();
    EXPECT_TRUE(begins_with(state.violation(), "time_step")) << state.violation();
}

TEST(Invariants, HaveNamesAndMeanings) {
    for (int k = 0; k < static_cast<int>(Invariant::count); ++k) {
        EXPECT_GT(std::string(to_string(static_cast<Invariant>(k))).size(), 3U);
        EXPECT_GT(std::string(meaning_of(static_cast<Invariant>(k))).size(), 10U);
    }
}

// ---- rest

TEST(Rest, IsJudgedByWhereParticlesGetAndNotByTheirTrembling) {
    Soil soil = soil_at({{0.0, 1.0}, {0.1, 1.0}});
    RestWatch rest(g, 1.0, 0.01);
    rest.start(soil, 0.0);
    double time = 0.0;
    for (int k = 0; k < 200; ++k) {
        soil.x[0] = k % 2 == 0 ? 0.0 : 1e-4;  // a fast tremble, and back
        rest.observe(soil, time += 0.1);
    }
    EXPECT_TRUE(rest.at_rest());
}

TEST(Rest, IsNotThereWhileTheMassSlides) {
    Soil soil = soil_at({{0.0, 1.0}, {0.1, 1.0}});
    RestWatch rest(g, 1.0, 0.01);
    rest.start(soil, 0.0);
    double time = 0.0;
    for (int k = 0; k < 200; ++k) {
        for (double& x : soil.x) x += 0.1 * 0.1;
        rest.observe(soil, time += 0.1);
    }
    EXPECT_FALSE(rest.at_rest());
    EXPECT_NEAR(rest.motion_ended(), time, 0.2);
}

/// Grains that are here or `way` further on at every look, until `end`.
void rock(RestWatch& rest, Soil& soil, double way, double& time, double end) {
    for (int k = 0; time < end; ++k) {
        for (double& x : soil.x) x = k % 2 == 0 ? way : 0.0;
        rest.observe(soil, time += 0.17);
    }
}

TEST(Rest, ComesToGrainsThatAllTremble) {
    const std::vector<Vec2> places(10);
    Soil soil = soil_at(places);
    RestWatch rest(g, 1.0, 0.01);
    rest.start(soil, 0.0);
    double time = 0.0;
    // From one look to the next they have more energy than a mass at rest, but they get nowhere.
    rock(rest, soil, 0.0028, time, 2.0);
    EXPECT_FALSE(rest.at_rest());
    rock(rest, soil, 0.0028, time, 3.4);
    EXPECT_TRUE(rest.at_rest());
    EXPECT_EQ(rest.motion_ended(), 0.0);
}

TEST(Rest, TakesLongerWhereGrainsRock) {
    const std::vector<Vec2> places(10);
    Soil soil = soil_at(places);
    RestWatch rest(g, 1.0, 0.01);
    rest.start(soil, 0.0);
    const double unit = std::sqrt(1.0 / g);
    double time = 0.0;
    rock(rest, soil, 0.009, time, 15.0 * unit);
    EXPECT_FALSE(rest.at_rest());
    rock(rest, soil, 0.009, time, 21.0 * unit);
    EXPECT_TRUE(rest.at_rest());
}

// A pile about to give way: its grains creep by less than those that tremble.
TEST(Rest, IsNotThereWhileGrainsCreep) {
    Soil soil = soil_at({{0.0, 1.0}, {0.1, 1.0}});
    RestWatch rest(g, 1.0, spacing);
    rest.start(soil, 0.0);
    const double unit = std::sqrt(1.0 / g);
    for (int k = 1; k <= 1000; ++k) {
        soil.x[0] = 0.06 * spacing * 0.1 * k;
        rest.observe(soil, 0.1 * unit * k);
        ASSERT_FALSE(rest.at_rest()) << k;
    }
}

TEST(Rest, IsNotThereWhileOneGrainOfAThousandRolls) {
    const std::vector<Vec2> places(1000);
    Soil soil = soil_at(places);
    RestWatch rest(g, 1.0, 0.01);
    rest.start(soil, 0.0);
    double time = 0.0;
    const auto pass = [&](double speed) {
        for (int k = 0; k < 60; ++k) {
            soil.x[17] += 0.05 * speed;
            rest.observe(soil, time += 0.05);
        }
    };
    pass(0.02);  // the mean motion has far less energy than 1e-5 g sqrt(S)
    EXPECT_FALSE(rest.at_rest());
    pass(0.0);
    EXPECT_TRUE(rest.at_rest());
}

}  // namespace
}  // namespace runout
