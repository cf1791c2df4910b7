// Grains on the bed that no continuum carries: alone they are point masses, and films of them stand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/pairs/packing.h"
#include "engine/simulation.h"
#include "observe.h"
#include "scene/make_problem.h"
#include "scenes.h"

namespace runout {
namespace {

constexpr double g = 9.81;
constexpr double spacing = 0.005;

/// A row of grains half a spacing above the bed line of a plane slope, `distance` spacings apart.
Simulation row_on_slope(double slope_deg, double phi_deg, int grains, double distance,
                        double smoothing_ratio = 1.3) {
    Scene scene = scenes::slab(slope_deg, 100, 1, phi_deg, spacing);
    scene.run.smoothing_ratio = smoothing_ratio;
    const double slope = radians(slope_deg);
    const Vec2 along{std::cos(slope), -std::sin(slope)};
    const Vec2 up{std::sin(slope), std::cos(slope)};
    const Vec2 head = scene.source.bed.front() + 0.3 * (scene.source.bed.back() - scene.source.bed.front()) +
                      0.5 * spacing * up;
    Packing packing;
    packing.spacing = spacing;
    for (int k = 0; k < grains; ++k) packing.points.push_back(head + k * distance * spacing * along);
    return {make_problem(scene), packing};
}

/// How far a grain gets until `end_time`, m.
double furthest_until(Simulation& simulation, double end_time) {
    const std::vector<Vec2> start = positions_by_id(simulation);
    while (simulation.time() < end_time) simulation.step();
    const std::vector<Vec2> end = positions_by_id(simulation);
    double furthest = 0.0;
    for (std::size_t i = 0; i < start.size(); ++i) furthest = std::max(furthest, (end[i] - start[i]).norm());
    return furthest;
}

double speed(const Simulation& simulation) {
    return std::hypot(simulation.state().vx[0], simulation.state().vy[0]);
}

TEST(LoneGrain, SlidesAsAPointMass) {
    const double slope = radians(45.0);
    const double exact = g * (std::sin(slope) - std::sin(radians(30.0)) * std::cos(slope));
    Simulation simulation = row_on_slope(45.0, 30.0, 1, 1.0);
    furthest_until(simulation, 0.1);
    const double landed = speed(simulation);
    const double time = simulation.time();
    furthest_until(simulation, 0.2);
    EXPECT_NEAR((speed(simulation) - landed) / (exact * (simulation.time() - time)), 1.0, 1e-9);
}

TEST(LoneGrain, StandsOnASlopeFlatterThanRepose) {
    Simulation simulation = row_on_slope(25.0, 30.0, 1, 1.0);  // repose is 26.6 deg
    furthest_until(simulation, 0.1);                           // until it has landed
    EXPECT_LT(furthest_until(simulation, 5.0), 1e-9 * spacing);
}

class FilmTest : public testing::TestWithParam<double> {};

// Once the bed line carried grains that friction took for falling, and their friction went to hold their
// fall: films crept down slopes 8 deg below repose.
TEST_P(FilmTest, StandsOnASlopeFlatterThanRepose) {
    for (const double distance : {1.2, 1.6, 2.0, 2.1}) {
        Simulation simulation = row_on_slope(18.0, 28.3, 24, distance, GetParam());  // repose is 25.4 deg
        furthest_until(simulation, 1.0);  // it falls to the bed and finds its place
        EXPECT_LT(furthest_until(simulation, 5.0), 0.1 * spacing) << distance << " spacings apart";
    }
}

// Pressure in a film that is thinner than a grain once pressed its grains apart: films on a slope at nine
// tenths of repose crept and spread for as long as they were watched, the further the finer the soil.
TEST_P(FilmTest, OfGrainsApartIsCarriedByTheBedLineAlone) {
    const double repose = std::sin(radians(10.0));
    for (const double distance : {1.6, 1.8, 2.0, 2.2}) {
        Simulation simulation =
            row_on_slope(degrees(std::atan(0.97 * repose)), 10.0, 24, distance, GetParam());
        furthest_until(simulation, 1.0);
        EXPECT_LT(furthest_until(simulation, 5.0), 1e-6 * spacing) << distance << " spacings apart";
    }
}

INSTANTIATE_TEST_SUITE_P(SmoothingRatios, FilmTest, testing::Values(1.3, 1.5, 2.0));

}  // namespace
}  // namespace runout
