// Effects that change what resists or drives the soil: each against exact mechanics or a known height.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/effects/shaking.h"
#include "engine/simulation.h"
#include "observe.h"
#include "run/run_scene.h"
#include "scene/make_problem.h"
#include "scenes.h"

namespace runout {
namespace {

constexpr double g = 9.81;

constexpr int slab_columns = 300;
constexpr int slab_rows = 10;
constexpr double slab_spacing = 0.005;

/// Greatest relative deviation of speed / time from `exact` within a tenth of a second.
double slab_deviation(const Scene& scene, double slope, double exact) {
    Simulation simulation(make_problem(scene));
    double worst = 0.0;
    double next = 0.01;
    while (simulation.time() < 0.1) {
        simulation.step();
        if (simulation.time() < next) continue;
        next += 0.01;
        const double deviation =
            slab_speed(simulation, slab_columns, slab_rows, slope) / simulation.time() / exact - 1.0;
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

TEST(BaseFriction, SlabSlidesAsItsBaseLetsItHoweverMuchStrongerTheSoilIs) {
    const double slope = radians(45.0);
    for (const double angle : {5.0, 20.0, 30.0}) {
        Scene scene = scenes::slab(45.0, slab_columns, slab_rows, 60.0, slab_spacing);
        scene.effects.base_friction = BaseFriction{radians(angle)};
        const double exact = g * (std::sin(slope) - std::tan(radians(angle)) * std::cos(slope));
        const double deviation = slab_deviation(scene, slope, exact);
        RecordProperty("deviation", std::to_string(deviation));
        EXPECT_LT(std::abs(deviation), 0.03) << "base of " << angle << " deg";
    }
}

TEST(PorePressure, TheSlowerItDissipatesTheFurtherTheMassRuns) {
    double previous = 0.0;
    for (const double time : {0.02, 0.1, 0.5, 2.5}) {
        Scene scene = scenes::aluminium_column(21.9, 0.008);
        scene.effects.pore_pressure = PorePressure{.base_excess = 0.5, .dissipation_time = time};
        const RunResult result = run_scene(scene);
        ASSERT_EQ(result.status, RunStatus::settled) << result.status_detail;
        EXPECT_GT(result.measures.front_mass_995_m, previous) << "dissipated in " << time << " s";
        previous = result.measures.front_mass_995_m;
    }
}

TEST(SideWalls, AFluidSlabIsBrakedByPressureOverWidth) {
    // Without friction of its own the slab's pressure is rho g d cos(t), with mean rho g h cos(t) / 2; and
    // there are two walls.
    const double slope = radians(45.0);
    Scene scene = scenes::slab(45.0, slab_columns, slab_rows, 0.0, slab_spacing);
    scene.effects.side_walls = SideWalls{.width = 0.1, .angle = radians(20.0)};
    const double height = slab_rows * slab_spacing;
    const double braking = std::tan(radians(20.0)) * g * height * std::cos(slope) / 0.1;
    const double deviation = slab_deviation(scene, slope, g * std::sin(slope) - braking);
    RecordProperty("deviation", std::to_string(deviation));
    EXPECT_LT(std::abs(deviation), 0.03);
}

TEST(Shaking, SlabMovesAsNewmarksBlock) {
    // A slab that stands by itself slides only while the shaking overcomes its friction.
    const double slope = radians(20.0);
    const double sin_phi = std::sin(radians(30.0));
    Scene scene = scenes::slab(20.0, slab_columns, slab_rows, 30.0, slab_spacing);
    Shaking shaking;
    const double period = 0.3;
    const double amplitude = 8.0;
    for (int k = 0; k <= 100; ++k) {
        shaking.time.push_back(0.009 * k);
        shaking.horizontal.push_back(-amplitude * std::sin(2.0 * std::numbers::pi * 0.009 * k / period));
        shaking.vertical.push_back(0.0);
    }
    scene.effects.shaking = shaking;
    const GroundMotion motion(shaking);
    double speed = 0.0;
    double exact = 0.0;
    for (double t = 0.0; t < 0.9; t += 1e-6) {
        const double push = -motion.acceleration(t).x();
        const double along = g * std::sin(slope) + push * std::cos(slope);
        const double across = std::max(0.0, g * std::cos(slope) - push * std::sin(slope));
        speed = std::max(0.0, speed + 1e-6 * (along - sin_phi * across));
        exact += 1e-6 * speed;
    }
    Simulation simulation(make_problem(scene));
    const std::vector<Vec2> start = positions_by_id(simulation);
    while (simulation.time() < 0.9) simulation.step();
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
                                  {{0, 0}, {2 * height, 0}, {2 * height, height}, {0, height}},
                                  friction_angle_deg, height / rows);
    scene.effects.cohesion = Cohesion{.strength = scene.material.density * g * height / factor};
    scene.run.friction_iterations = 60;  // these two as make_scene gives a cohesive soil
    scene.run.pressure_tolerance = 1e-3;
    return scene;
}

RunStatus status_of(const Scene& scene) {
    Simulation simulation(make_problem(scene));
    while (simulation.status() == RunStatus::running) simulation.step();
    return simulation.status();
}

/// Farthest that any particle gets from its place in `time` sqrt(sqrt(S)/g), spacings; nothing sleeps.
double sag(Scene scene, double time) {
    scene.run.sleeping = false;
    Simulation simulation(make_problem(scene));
    const std::vector<Vec2> start = positions_by_id(simulation);
    while (simulation.time() < time * simulation.time_scale()) simulation.step();
    const std::vector<Vec2> end = positions_by_id(simulation);
    double farthest = 0.0;
    for (std::size_t i = 0; i < start.size(); ++i) farthest = std::max(farthest, (end[i] - start[i]).norm());
    return farthest / simulation.state().discretisation->spacing;
}

constexpr double known_height = 3.83;  // c/(rho g), of a vertical cut without friction

TEST(Cohesion, VerticalCutStandsUpToTheKnownHeightWithinATenth) {
    EXPECT_EQ(status_of(vertical_cut(0.0, 0.9 * known_height, 20)), RunStatus::stable);
    EXPECT_EQ(status_of(vertical_cut(0.0, 1.1 * known_height, 20)), RunStatus::settled);
}

TEST(Cohesion, WithFrictionTheHeightLiesBetweenDavisAndFullParameters) {
    const double phi = 30.0;
    const double davis = std::atan(std::sin(radians(phi)));
    const double low = 4.0 * std::cos(radians(phi)) * std::tan(radians(45.0) + 0.5 * davis);
    const double high = 4.0 * std::tan(radians(45.0 + 0.5 * phi));
    EXPECT_EQ(status_of(vertical_cut(phi, low, 20)), RunStatus::stable);
    EXPECT_EQ(status_of(vertical_cut(phi, high, 20)), RunStatus::settled);
}

// A run that ends when nothing has moved for a while says little if all begins to move after it.
TEST(Cohesion, AStandingCutStandsOn) {
    const double without_friction = sag(vertical_cut(0.0, 0.9 * known_height, 20), 40.0);
    const double finer = sag(vertical_cut(0.0, 0.9 * known_height, 40), 20.0);
    const double with_friction = sag(vertical_cut(30.0, 5.6, 20), 40.0);
    RecordProperty("without_friction", std::to_string(without_friction));
    RecordProperty("finer", std::to_string(finer));
    RecordProperty("with_friction", std::to_string(with_friction));
    EXPECT_LT(without_friction, 0.5);
    EXPECT_LT(finer, 0.5);
    EXPECT_LT(with_friction, 0.2);
}

TEST(Rate, SteadyFlowHasBagnoldsProfile) {
    // So long that what happens at its ends has not reached the middle when the flow is steady there.
    constexpr int columns = 970;
    constexpr int rows = 16;
    constexpr double friction_angle_deg = 11.5;
    const double height = 0.05;
    const double slope = std::atan(0.45);
    Scene scene = scenes::slab(degrees(slope), columns, rows, friction_angle_deg, height / rows);
    RateDependence rate;
    rate.increase = 0.6;
    rate.grain_diameter = height / 5.0;
    rate.grain_density = scene.material.density;
    scene.effects.rate = rate;
    const double mu = std::sin(radians(friction_angle_deg));
    const double number =
        rate.inertial_number * (std::tan(slope) - mu) / (mu + rate.increase - std::tan(slope));
    const auto exact = [&](double y) {
        return 2.0 / 3.0 * number / rate.grain_diameter *
               std::sqrt(g * std::cos(slope) * std::pow(height, 3)) * (1.0 - std::pow(1.0 - y / height, 1.5));
    };
    Simulation simulation(make_problem(scene));
    while (simulation.time() < 2.0) simulation.step();
    const StateView state = simulation.state();
    double miss = 0.0, all = 0.0, worst = 0.0;
    std::vector<double> layer_miss(rows, 0.0);
    std::vector<int> layer_count(rows, 0);
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        const int column = state.id[i] / rows;
        if (column < 2 * columns / 5 || column >= 3 * columns / 5) continue;
        const double y = state.x[i] * std::sin(slope) + state.y[i] * std::cos(slope);
        const double u = state.vx[i] * std::cos(slope) - state.vy[i] * std::sin(slope);
        miss += u - exact(std::min(y, height));
        all += exact(std::min(y, height));
        worst = std::max(worst, std::abs(u - exact(std::min(y, height))));
        const int layer = std::clamp(static_cast<int>(y / height * rows), 0, rows - 1);
        layer_miss[layer] += u - exact(std::min(y, height));
        ++layer_count[layer];
    }
    double profile = 0.0;
    for (int k = 0; k < rows; ++k)
        if (layer_count[k] > 0) profile = std::max(profile, std::abs(layer_miss[k]) / layer_count[k]);
    RecordProperty("profile_of_surface_speed", std::to_string(profile / exact(height)));
    RecordProperty("mean_deviation", std::to_string(miss / all));
    RecordProperty("worst_of_surface_speed", std::to_string(worst / exact(height)));
    EXPECT_LT(std::abs(miss / all), 0.03);
    EXPECT_LT(profile, 0.03 * exact(height));
    EXPECT_LT(worst, 0.05 * exact(height));
}

/// (L - L0) / L0 of a column of glass beads six times as high as wide.
double spread_of_tall_column(bool rate, int lattice_seed) {
    const double length = 0.05;
    Scene scene = scenes::polygon({{0, 0.4}, {0, 0}, {2, 0}},
                                  {{0, 0}, {length, 0}, {length, 6 * length}, {0, 6 * length}}, 22.4, 0.0035);
    if (rate) scene.effects.rate = RateDependence{.grain_diameter = 0.002, .grain_density = 2500};
    scene.run.lattice_seed = lattice_seed;
    const RunResult result = run_scene(scene);
    EXPECT_EQ(result.status, RunStatus::settled) << result.status_detail;
    return (result.measures.run_out_m - length) / length;
}

// Glass beads in a channel: 1.9 a^(2/3) (Lajeunesse et al. 2005). The thin front scatters from lattice to
// lattice, so it is the mean over several that is held against them.
TEST(Rate, TakesMoreThanHalfOfWhatATallColumnSpreadsTooFar) {
    const double measured = 1.9 * std::pow(6.0, 2.0 / 3.0);
    constexpr int lattices = 4;
    double coulomb = 0.0;
    double with_rate = 0.0;
    for (int seed = 1; seed <= lattices; ++seed) {
        coulomb += spread_of_tall_column(false, seed) / lattices;
        with_rate += spread_of_tall_column(true, seed) / lattices;
    }
    RecordProperty("coulomb", std::to_string(coulomb / measured));
    RecordProperty("with_rate", std::to_string(with_rate / measured));
    EXPECT_GT(coulomb, 1.7 * measured);
    EXPECT_LT(with_rate - measured, (coulomb - measured) / 2.0);
}

}  // namespace
}  // namespace runout
