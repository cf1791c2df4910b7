// Effects that a case names: each against exact mechanics, its neutral value against its absence, and every
// pair of them together.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "engine/bed_shape.h"
#include "engine/simulation.h"
#include "measures/run.h"
#include "scenes.h"

namespace runout {
namespace {

constexpr double g = 9.81;

std::vector<Vec2> positions_by_id(const Simulation& simulation) {
    const StateView state = simulation.state();
    std::vector<Vec2> positions(state.x.size());
    for (std::size_t i = 0; i < state.x.size(); ++i) positions[state.id[i]] = {state.x[i], state.y[i]};
    return positions;
}

std::vector<Vec2> positions_at(const Scene& scene, double until) {
    Simulation simulation(scene);
    while (simulation.status() == RunStatus::running && simulation.time() < until) simulation.step();
    return positions_by_id(simulation);
}

constexpr int slab_columns = 300;
constexpr int slab_rows = 10;
constexpr double slab_spacing = 0.005;

/// Mean of a component along the plane over the middle fifth of a slab.
double slab_mean(const Simulation& simulation, double slope, std::span<const double> x, std::span<const double> y) {
    const StateView state = simulation.state();
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        const int column = state.id[i] / slab_rows;  // packing goes column by column
        if (column < 2 * slab_columns / 5 || column >= 3 * slab_columns / 5) continue;
        sum += x[i] * std::cos(slope) - y[i] * std::sin(slope);
        ++count;
    }
    return sum / count;
}

double slab_speed(const Simulation& simulation, double slope) {
    return slab_mean(simulation, slope, simulation.state().vx, simulation.state().vy);
}

/// Greatest relative deviation of speed / time from `exact` within a tenth of a second.
double slab_deviation(const Scene& scene, double slope, double exact) {
    Simulation simulation(scene);
    double worst = 0.0;
    double next = 0.01;
    while (simulation.time() < 0.1) {
        simulation.step();
        if (simulation.time() < next) continue;
        next += 0.01;
        const double deviation = slab_speed(simulation, slope) / simulation.time() / exact - 1.0;
        if (std::abs(deviation) > std::abs(worst)) worst = deviation;
    }
    return worst;
}

TEST(PorePressure, SlabFollowsTheEffectiveStress) {
    const double slope = radians(45.0);
    for (const double ratio : {0.1, 0.3}) {
        Scene scene = scenes::slab(45.0, slab_columns, slab_rows, 38.0, slab_spacing);
        scene.effects.pore_pressure = PorePressure{.ratio = ratio};
        const double exact =
            g * (std::sin(slope) - std::sin(radians(38.0)) * (std::cos(slope) - ratio / std::cos(slope)));
        const double deviation = slab_deviation(scene, slope, exact);
        RecordProperty("deviation", std::to_string(deviation));
        EXPECT_LT(std::abs(deviation), 0.03) << "r_u = " << ratio;
    }
}

TEST(SideWalls, SlabIsBrakedByPressureOverWidth) {
    const double slope = radians(45.0);
    Scene scene = scenes::slab(45.0, slab_columns, slab_rows, 38.0, slab_spacing);
    scene.effects.side_walls = SideWalls{.width = 0.1, .angle = radians(20.0)};
    const double height = slab_rows * slab_spacing;
    // The mean pressure over depth is rho g h cos(t) / 2, and there are two walls.
    const double exact =
        g * (std::sin(slope) - std::sin(radians(38.0)) * std::cos(slope)) -
        std::tan(radians(20.0)) * g * height * std::cos(slope) / 0.1;
    const double deviation = slab_deviation(scene, slope, exact);
    RecordProperty("deviation", std::to_string(deviation));
    EXPECT_LT(std::abs(deviation), 0.03);
}

TEST(Shaking, SlabMovesAsNewmarksBlock) {
    // A slab that stands by itself slides only while the shaking overcomes its friction.
    const double slope = radians(20.0);
    const double sin_phi = std::sin(radians(30.0));
    Scene scene = scenes::slab(20.0, slab_columns, slab_rows, 30.0, slab_spacing);
    Shaking shaking;
    const double period = 0.1;
    const double amplitude = 8.0;
    for (int k = 0; k <= 100; ++k) {
        shaking.time.push_back(0.003 * k);
        shaking.horizontal.push_back(-amplitude * std::sin(2.0 * std::numbers::pi * 0.003 * k / period));
        shaking.vertical.push_back(0.0);
    }
    scene.effects.shaking = shaking;
    const GroundMotion motion(shaking);
    double speed = 0.0;
    double exact = 0.0;
    for (double t = 0.0; t < 0.3; t += 1e-6) {
        const double push = -motion.acceleration(t).x();
        const double along = g * std::sin(slope) + push * std::cos(slope);
        const double across = std::max(0.0, g * std::cos(slope) - push * std::sin(slope));
        speed = std::max(0.0, speed + 1e-6 * (along - sin_phi * across));
        exact += 1e-6 * speed;
    }
    Simulation simulation(scene);
    const std::vector<Vec2> start = positions_by_id(simulation);
    while (simulation.time() < 0.3) simulation.step();
    const std::vector<Vec2> end = positions_by_id(simulation);
    double moved = 0.0;
    int count = 0;
    for (int i = 2 * slab_columns / 5 * slab_rows; i < 3 * slab_columns / 5 * slab_rows; ++i, ++count)
        moved += (end[i] - start[i]).x() * std::cos(slope) - (end[i] - start[i]).y() * std::sin(slope);
    RecordProperty("displacement_mm", std::to_string(1e3 * moved / count));
    RecordProperty("exact_mm", std::to_string(1e3 * exact));
    EXPECT_NEAR(moved / count, exact, 0.03 * exact);
}

/// Block of cohesive soil with a vertical face, `factor` c / (rho g) high, twice as long as it is high.
Scene vertical_cut(double friction_angle_deg, double factor, int rows) {
    const double height = 2.0;
    Scene scene = scenes::polygon({{0, 2 * height}, {0, 0}, {6 * height, 0}},
                                  {{0, 0}, {2 * height, 0}, {2 * height, height}, {0, height}}, friction_angle_deg,
                                  height / rows);
    scene.effects.cohesion = Cohesion{.strength = scene.material.density * g * height / factor};
    return scene;
}

RunStatus status_of(const Scene& scene) {
    Simulation simulation(scene);
    while (simulation.status() == RunStatus::running) simulation.step();
    return simulation.status();
}

TEST(Cohesion, VerticalCutStandsUpToTheKnownHeight) {
    EXPECT_EQ(status_of(vertical_cut(0.0, 0.9 * 3.83, 20)), RunStatus::stable);
    EXPECT_EQ(status_of(vertical_cut(0.0, 1.1 * 3.83, 20)), RunStatus::settled);
}

TEST(Cohesion, WithFrictionTheHeightLiesBetweenDavisAndFullParameters) {
    const double phi = 30.0;
    const double davis = std::atan(std::sin(radians(phi)));
    const double low = 4.0 * std::cos(radians(phi)) * std::tan(radians(45.0) + 0.5 * davis);
    const double high = 4.0 * std::tan(radians(45.0 + 0.5 * phi));
    EXPECT_EQ(status_of(vertical_cut(phi, low, 20)), RunStatus::stable);
    EXPECT_EQ(status_of(vertical_cut(phi, high, 20)), RunStatus::settled);
}

}  // namespace
}  // namespace runout
