// Runs against exact mechanics, and properties that every run must have.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/simulation.h"
#include "observe.h"
#include "scene/make_problem.h"
#include "scenes.h"

namespace runout {
namespace {

constexpr double g = 9.81;

/// Greatest displacement since release, m.
double greatest_displacement(const Simulation& simulation, const std::vector<Vec2>& start) {
    const StateView state = simulation.state();
    double greatest = 0.0;
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        greatest = std::max(greatest, (Vec2{state.x[i], state.y[i]} - start[state.id[i]]).norm());
    }
    return greatest;
}

class SlabTest : public testing::TestWithParam<double> {};

// a = g (sin t - sin phi cos t) from the first instant: the run starts from an equilibrium state of stress.
TEST_P(SlabTest, AcceleratesAsTheSinPhiRuleSays) {
    constexpr int columns = 300;
    constexpr int rows = 10;
    const double slope = radians(GetParam());
    const double exact = g * (std::sin(slope) - std::sin(radians(38.0)) * std::cos(slope));
    Simulation simulation(make_problem(scenes::slab(GetParam(), columns, rows, 38.0, 0.005)));
    double next = 1e-9;
    double worst = 0.0;
    while (simulation.time() < 0.1) {
        simulation.step();
        if (simulation.time() < next) continue;
        next += 0.01;
        const double deviation =
            slab_speed(simulation, columns, rows, slope) / simulation.time() / exact - 1.0;
        EXPECT_LT(std::abs(deviation), 0.03) << "t = " << simulation.time();
        worst = std::max(worst, std::abs(deviation));
    }
    RecordProperty("worst_deviation", std::to_string(worst));
}
INSTANTIATE_TEST_SUITE_P(Slopes, SlabTest, testing::Values(45.0, 60.0, 70.0));

double mean_pressure(const Simulation& simulation) {
    double sum = 0.0;
    for (const double p : simulation.state().pressure) sum += p;
    return sum / static_cast<double>(simulation.state().pressure.size());
}

// What one step has too much the next must not have too little: strength that follows such a pressure holds
// soil up half of the time only. The step is a tenth of what the flow takes to change.
TEST(Pressure, DoesNotAlternateFromStepToStep) {
    Simulation simulation(make_problem(scenes::aluminium_column(21.9, 0.003)));
    while (simulation.time() < 0.1) simulation.step();
    constexpr int steps = 50;
    std::array<double, 3> last{};
    double alternation = 0.0;
    double sum = 0.0;
    for (int k = 0; k < steps + 2; ++k) {
        simulation.step();
        last = {last[1], last[2], mean_pressure(simulation)};
        if (k < 2) continue;
        alternation += std::abs(last[0] - 2.0 * last[1] + last[2]) / 4.0;
        sum += last[1];
    }
    RecordProperty("share", std::to_string(alternation / sum));
    EXPECT_LT(alternation / sum, 0.01);
}

TEST(Rest, SlabFlatterThanReposeStands) {
    constexpr int columns = 100;
    Simulation simulation(make_problem(scenes::slab(25.0, columns, 10, 38.0, 0.005)));
    double next = 0.0;
    while (simulation.time() < 0.3) {
        simulation.step();
        if (simulation.time() < next) continue;
        next += 0.05;
        // Under 1 % of what a frictionless slab would have reached.
        EXPECT_LT(std::abs(slab_speed(simulation, columns, 10, radians(25.0))),
                  0.01 * g * std::sin(radians(25.0)) * 0.3);
    }
}

TEST(Rest, ColumnBetweenWallsNeitherMovesNorLosesWeight) {
    const Scene scene = scenes::silo(0.1, 0.1, 21.9, 0.005);
    Simulation simulation(make_problem(scene));
    const std::vector<Vec2> start = positions_by_id(simulation);
    const double weight = scene.material.density * g * scene.source.area;
    double worst = 0.0;
    while (simulation.time() < 2.0) {  // also long after the run would have ended
        simulation.step();
        if (simulation.time() == 0.0) continue;  // the stress at release is still sought
        const double deviation = -simulation.bed_force().y() / weight - 1.0;
        ASSERT_LT(std::abs(deviation), 0.02) << "t = " << simulation.time();
        worst = std::max(worst, std::abs(deviation));
    }
    RecordProperty("worst_deviation_of_bed_force", std::to_string(worst));
    EXPECT_EQ(simulation.status(), RunStatus::stable);
    EXPECT_LT(greatest_displacement(simulation, start), 0.5 * 0.005);
}

TEST(Rest, HeapBelowReposeStandsForThirtyFallTimes) {
    // Repose of phi = 21.9 deg is 20.45 deg.
    const double spacing = 0.0025;
    Simulation simulation(make_problem(scenes::heap(15.4, 0.1, 21.9, spacing)));
    const std::vector<Vec2> start = positions_by_id(simulation);
    while (simulation.time() < 30.0 * std::sqrt(0.1 / g)) simulation.step();
    const double moved = greatest_displacement(simulation, start) / spacing;
    EXPECT_LT(moved, 1.0);
    RecordProperty("greatest_displacement_in_spacings", std::to_string(moved));
}

// It has nothing to lean on there. It was taken for soil deep in the wall, and the run called diverged.
TEST(Properties, SoilAboveTheWallThatEndsASectionLeavesIt) {
    Simulation simulation(make_problem(scenes::polygon(
        {{0, 0.2}, {0, 0}, {2, 0}}, {{0, 0}, {0.05, 0}, {0.05, 0.3}, {0, 0.3}}, 22.4, 0.004)));
    while (simulation.status() == RunStatus::running) simulation.step();
    EXPECT_EQ(simulation.status(), RunStatus::left_section) << simulation.status_detail();
}

TEST(Properties, PressureNeverPulls) {
    Simulation simulation(make_problem(scenes::aluminium_column(21.9, 0.008)));
    while (simulation.status() == RunStatus::running) {
        simulation.step();
        const StateView state = simulation.state();
        for (std::size_t i = 0; i < state.x.size(); ++i) ASSERT_GE(state.pressure[i], 0.0);
    }
    EXPECT_EQ(simulation.status(), RunStatus::settled);
}

TEST(Properties, EnergyIsAccountedFor) {
    Simulation simulation(make_problem(scenes::aluminium_column(21.9, 0.004)));
    const EnergyBudget start = simulation.energy();
    double least = start.potential;
    while (simulation.status() == RunStatus::running) {
        simulation.step();
        const EnergyBudget now = simulation.energy();
        // Mechanical energy may not rise by more than a thousandth of what there was.
        EXPECT_LT(now.kinetic + now.potential, least + 0.001 * start.potential);
        least = std::min(least, now.kinetic + now.potential);
    }
    const EnergyBudget end = simulation.energy();
    const double lost = start.potential - end.kinetic - end.potential;
    // What is lost went into friction and, for a small part, into the error of the projection and to the bed
    // line, which brakes lone grains; nothing else takes any.
    EXPECT_NEAR(end.friction_work + end.guard_work - end.pressure_work, lost, 0.01 * lost);
    EXPECT_GT(end.friction_work, 0.96 * lost);
    EXPECT_LT(std::abs(end.guard_work), 0.03 * lost);
}

// Boundary particles that soil was just reaching took that for compression and braked the front: a tenth of
// the energy of this box went there, and its run-out grew with every refinement.
TEST(Properties, TheBedDoesNotBrakeAFrontThatReachesIt) {
    Simulation simulation(make_problem(scenes::box(70.0, 0.385, 0.003)));
    const double start = simulation.energy().potential;
    while (simulation.status() == RunStatus::running) simulation.step();
    const EnergyBudget end = simulation.energy();
    const double lost = start - end.kinetic - end.potential;
    EXPECT_LT(-end.pressure_work, 0.045 * lost);
}

TEST(Properties, ParticlesAreNumberedOnceAndStayOutOfTheBed) {
    Simulation simulation(make_problem(scenes::box(70.0, 0.385, 0.003)));
    const std::size_t count = simulation.state().x.size();
    while (simulation.status() == RunStatus::running) simulation.step();
    EXPECT_EQ(simulation.status(), RunStatus::settled) << simulation.status_detail();
    const StateView state = simulation.state();
    ASSERT_EQ(state.x.size(), count);
    std::vector<char> seen(count, 0);
    for (const int id : state.id) seen[id] = 1;
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<long>(count));
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_GE(state.bed->nearest({state.x[i], state.y[i]}).distance, -1e-12);
    }
    EXPECT_LT(simulation.work().bed_guard_activations, simulation.work().steps / 100);
}

/// Final positions, to be compared bit by bit.
std::vector<Vec2> final_positions(Scene scene, int threads, double until) {
    scene.run.threads = threads;
    Simulation simulation(make_problem(scene));
    while (simulation.status() == RunStatus::running && simulation.time() < until) simulation.step();
    return positions_by_id(simulation);
}

TEST(Properties, OneThreadAndTwoGiveTheSameBits) {
    const Scene scene = scenes::aluminium_column(21.9, 0.0025);
    EXPECT_EQ(final_positions(scene, 1, 0.1), final_positions(scene, 2, 0.1));
}

TEST(Effects, ABaseAsStrongAsTheSoilChangesNotABit) {
    const Scene scene = scenes::aluminium_column(21.9, 0.008);
    Scene strong = scene;
    strong.effects.base_friction = BaseFriction{radians(25.0)};  // tan 25 deg > sin 21.9 deg
    EXPECT_EQ(final_positions(scene, 1, 0.2), final_positions(strong, 1, 0.2));
    strong.effects.base_friction = BaseFriction{radians(10.0)};
    EXPECT_NE(final_positions(scene, 1, 0.2), final_positions(strong, 1, 0.2));
}

TEST(Effects, LayersArePouredOntoSoilAtRestAndStayBelowTheWall) {
    Scene scene = scenes::aluminium_column(21.9, 0.01);
    scene.effects.release = StagedRelease{2, 0.05, 0.02};
    Simulation simulation(make_problem(scene));
    const std::size_t first = simulation.state().x.size();
    int stages = 0;
    while (simulation.status() == RunStatus::running) {
        simulation.step();
        stages += simulation.stage_ended() ? 1 : 0;
    }
    EXPECT_EQ(simulation.status(), RunStatus::settled) << simulation.status_detail();
    EXPECT_EQ(stages, 2);
    const StateView state = simulation.state();
    EXPECT_EQ(state.x.size(), first + 2 * 5 * 2);
    // A layer let go from the height of the wall would be thrown about.
    EXPECT_LT(*std::max_element(state.y.begin(), state.y.end()), 0.12);
}

TEST(Properties, LatticeSeedsMoveParticlesOffTheLatticeAndAreRepeatable) {
    Scene scene = scenes::aluminium_column(21.9, 0.01);
    const std::vector<Vec2> regular = final_positions(scene, 1, 0.0);
    scene.run.lattice_seed = 1;
    const std::vector<Vec2> jittered = final_positions(scene, 1, 0.0);
    EXPECT_NE(jittered, regular);
    EXPECT_EQ(final_positions(scene, 1, 0.0), jittered);
    scene.run.lattice_seed = 2;
    EXPECT_NE(final_positions(scene, 1, 0.0), jittered);
}

TEST(Properties, AMirroredSectionGivesTheSameBits) {
    const Scene scene = scenes::aluminium_column(21.9, 0.008);
    const Scene mirrored = scenes::polygon({{-1.2, 0}, {0, 0}, {0, 0.2}},
                                           {{0, 0}, {-0.2, 0}, {-0.2, 0.1}, {0, 0.1}}, 21.9, 0.008);
    EXPECT_EQ(final_positions(scene, 1, 10.0), final_positions(mirrored, 1, 10.0));
}

TEST(Properties, LengthAndGravityTimesTenChangeNothingButTheScale) {
    const Scene scene = scenes::aluminium_column(21.9, 0.008);
    Scene large = scenes::polygon({{0, 2}, {0, 0}, {12, 0}}, {{0, 0}, {2, 0}, {2, 1}, {0, 1}}, 21.9, 0.08);
    large.run.gravity = 10.0 * g;
    const std::vector<Vec2> a = final_positions(scene, 1, 10.0);
    const std::vector<Vec2> b = final_positions(large, 1, 10.0);
    double front_a = 0.0;
    double front_b = 0.0;
    for (const Vec2& p : a) front_a += p.x();
    for (const Vec2& p : b) front_b += p.x();
    EXPECT_NEAR(front_b / front_a, 10.0, 0.1);  // rounding decides single grains, not the mass
}

TEST(WorkCounts, ColumnStaysWithinItsBudget) {
    Simulation simulation(make_problem(scenes::aluminium_column(21.9, 0.004)));
    while (simulation.status() == RunStatus::running) simulation.step();
    EXPECT_LT(simulation.work().steps, 1300);
    EXPECT_LT(simulation.work().pressure_iterations, 10 * simulation.work().steps);
    EXPECT_EQ(simulation.work().unconverged_solves, 0);
}

TEST(Endings, SoilThatPassesTheEndOfTheSectionIsSaid) {
    Scene scene =
        scenes::polygon({{0, 0.2}, {0, 0}, {0.3, 0}}, {{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}}, 21.9, 0.008);
    Simulation simulation(make_problem(scene));
    while (simulation.status() == RunStatus::running) simulation.step();
    EXPECT_EQ(simulation.status(), RunStatus::left_section);
    EXPECT_NE(simulation.status_detail().find("distal end"), std::string::npos);
}

TEST(Endings, TimeLimitIsSaid) {
    Scene scene = scenes::aluminium_column(21.9, 0.008);
    scene.run.time_limit = 0.1;
    Simulation simulation(make_problem(scene));
    while (simulation.status() == RunStatus::running) simulation.step();
    EXPECT_EQ(simulation.status(), RunStatus::time_limit);
}

TEST(ExplicitFriction, IsThePapersSchemeAndCreeps) {
    Scene scene = scenes::heap(15.4, 0.1, 21.9, 0.005);
    const auto drop = [](const Scene& s) {
        Simulation simulation(make_problem(s));
        const double start = simulation.energy().potential;
        while (simulation.time() < 1.0) simulation.step();
        return (start - simulation.energy().potential) / start;
    };
    const double projected = drop(scene);
    scene.run.friction = FrictionScheme::explicit_;
    EXPECT_GT(drop(scene), 5.0 * std::abs(projected));
}

}  // namespace
}  // namespace runout
