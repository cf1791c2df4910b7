// Thickness of all soil and the front that is read of it, against sums by hand and fine scans.

#include "measures/thickness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "measures/reach.h"

namespace runout {
namespace {

constexpr FrontRule rule{0.3, 0.03};
constexpr double spacing = 0.05;

/// Particles on a bed of one's own.
struct Soil {
    Discretisation d = make_discretisation(spacing, 1.3, 2000);
    BedLine bed{Polyline{{-20, 0}, {20, 0}}};
    std::vector<double> x, y, vx, vy;

    void add(double at, double height, double speed = 0) {
        x.push_back(at);
        y.push_back(height);
        vx.push_back(speed);
        vy.push_back(0);
    }
    void add_layer(double from, double to, int rows, double floor = 0) {
        for (double at = from + 0.5 * spacing; at < to; at += spacing)
            for (int row = 0; row < rows; ++row) add(at, floor + (row + 0.5) * spacing);
    }
    [[nodiscard]] StateView view() const {
        StateView state;
        state.discretisation = &d;
        state.bed = &bed;
        state.ground = &bed;
        state.gravity = 9.81;
        state.x = x;
        state.y = y;
        state.vx = vx;
        state.vy = vy;
        return state;
    }
    [[nodiscard]] ThicknessField field(const FrontRule& asked = rule) const {
        ThicknessField soil(asked, view());
        soil.take(view());
        return soil;
    }
};

/// Heaps, thin sheets and single grains at random.
Soil random_soil(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-5, 5), share(0, 1);
    Soil soil;
    const int heaps = 1 + static_cast<int>(3 * share(random));
    for (int heap = 0; heap < heaps; ++heap) {
        const double from = place(random);
        soil.add_layer(from, from + 0.2 + 2 * share(random), 1 + static_cast<int>(6 * share(random)));
    }
    const int grains = static_cast<int>(60 * share(random));
    for (int grain = 0; grain < grains; ++grain) soil.add(place(random), share(random), place(random));
    return soil;
}

/// There the digits of x are coarser than the steps of the search: once it went on for ever.
TEST(ThicknessTest, FrontIsFoundFarFromTheToe) {
    constexpr double far = 131072;  // of which the digits are exact
    for (unsigned seed = 1; seed <= 300; ++seed) {
        std::mt19937 random(seed);
        Soil near = random_soil(random);
        const double front = near.field().front();
        Soil away = near;
        away.bed = BedLine(Polyline{{far - 20, 0}, {far + 20, 0}});
        for (double& x : away.x) x += far;
        EXPECT_NEAR(away.field().front() - far, front, 1e-7) << seed;
    }
}

TEST(ThicknessTest, OfALayerIsItsThicknessAndTheSpeedIsThatOfTheSoil) {
    Soil soil;
    soil.add_layer(-2, 2, 4);
    std::ranges::fill(soil.vx, 3.0);
    const ThicknessField field = soil.field();
    EXPECT_NEAR(field.at(0.013).thickness, 0.2, 1e-3);
    EXPECT_NEAR(field.at(0.013).velocity.x(), 3.0, 1e-12);
    EXPECT_EQ(field.at(2.31).thickness, 0.0);
}

// The front of a step of 0.2 m: where the part of the window that holds soil is 0.03/0.2 of its weight.
TEST(ThicknessTest, FrontOfAStepIsWhereTheWindowSays) {
    Soil soil;
    soil.add_layer(-2, 2, 4);
    const auto tail = [](double u) {
        return 0.5 - 15.0 / 16.0 * (u - 2 * u * u * u / 3 + std::pow(u, 5) / 5);
    };
    double u = 0;
    while (tail(u) > 0.15) u += 1e-5;
    EXPECT_NEAR(soil.field().front(), 2 + u * rule.window, 0.01);
}

TEST(ThicknessTest, FrontIsTheFarthestPlaceThatIsThickEnough) {
    std::mt19937 random(3);
    int with_front = 0;
    for (int k = 0; k < 300; ++k) {
        const Soil soil = random_soil(random);
        const ThicknessField field = soil.field();
        const double front = field.front();
        double scanned = ThicknessField::nowhere;
        for (double x = 8; x > -6 && scanned < -1e3; x -= 0.001)
            if (field.at(x).thickness >= rule.threshold) scanned = x;
        if (!(front > ThicknessField::nowhere)) {
            EXPECT_EQ(scanned, ThicknessField::nowhere);
            continue;
        }
        ++with_front;
        EXPECT_GE(field.at(front).thickness, rule.threshold * (1 - 1e-9)) << k;
        EXPECT_LT(field.at(front + 1e-7).thickness, rule.threshold) << k;
        EXPECT_GE(front, scanned - 1e-12) << k;
        EXPECT_LE(front, scanned + 0.0011) << k;
    }
    EXPECT_GT(with_front, 250);
}

TEST(ThicknessTest, ALumpBeyondAGapIsDebrisAndAGrainIsNot) {
    Soil soil;
    soil.add_layer(-2, 0, 4);
    soil.add(5, 0.025);
    EXPECT_LT(soil.field().front(), 1);
    soil.add_layer(3, 3.3, 2);
    EXPECT_GT(soil.field().front(), 3);
    EXPECT_LT(soil.field().front(), 4);
}

TEST(ThicknessTest, NothingIsThickEnoughForATallThreshold) {
    Soil soil;
    soil.add_layer(-2, 2, 4);
    EXPECT_EQ(soil.field({0.3, 0.25}).front(), ThicknessField::nowhere);
}

double integral(const ThicknessField& field) {
    double sum = 0;
    for (double x = -20; x < 20; x += 0.001) sum += 0.001 * field.at(x).thickness;
    return sum;
}

TEST(ThicknessTest, HoldsTheAreaOfTheSoilAlsoAtWalls) {
    std::mt19937 random(5);
    for (int k = 0; k < 10; ++k) {
        Soil soil = random_soil(random);
        const double area = spacing * spacing * static_cast<double>(soil.x.size());
        EXPECT_NEAR(integral(soil.field()), area, 2e-3 * area);
        // A drop behind, and a wall before the soil.
        soil.bed = BedLine{Polyline{{-20, 9}, {-6, 9}, {-6, 0}, {7, 0}, {7, 9}, {20, 9}}};
        EXPECT_NEAR(integral(soil.field()), area, 5e-3 * area);
    }
}

TEST(ThicknessTest, NoWindowReachesThroughAWall) {
    Soil soil;
    soil.bed = BedLine{Polyline{{-20, 0}, {2, 0}, {2, 5}, {20, 5}}};
    soil.add_layer(-1, 2, 10);
    const ThicknessField field = soil.field();
    EXPECT_EQ(field.front(), 2.0);
    EXPECT_EQ(field.at(2.01).thickness, 0.0);
    EXPECT_NEAR(field.at(1.99).thickness, 0.5, 2e-3) << "thrown back and not lost";
    // Soil above the wall is not held back.
    soil.add_layer(1.5, 3, 2, 5);
    EXPECT_GT(soil.field().front(), 3.0);
}

TEST(ThicknessTest, ABarrierHoldsSoilAndAKerbOrASawDoesNot) {
    Soil soil;
    const BedLine ground{Polyline{{-20, 0}, {20, 0}}};
    const BedLine with_barrier{Polyline{{-20, 0}, {2, 0}, {2, 1}, {2.2, 1}, {2.2, 0}, {20, 0}}};
    EXPECT_EQ(walls_of(ground, with_barrier, 0.03).size(), 2u);
    EXPECT_TRUE(walls_of(ground, with_barrier, 0.03)[0].rises);
    EXPECT_FALSE(walls_of(ground, with_barrier, 0.03)[1].rises);
    const BedLine kerb{Polyline{{-20, 0}, {2, 0}, {2, 0.02}, {20, 0.02}}};
    EXPECT_TRUE(walls_of(kerb, kerb, 0.03).empty());
    // Survey points on one face make one wall; a face of 60 deg makes none.
    const BedLine face{Polyline{{-20, 0}, {2, 0}, {2.01, 0.5}, {2.01, 1}, {2.02, 2}, {4, 5.4}, {20, 5.4}}};
    ASSERT_EQ(walls_of(face, face, 0.03).size(), 1u);
    EXPECT_EQ(walls_of(face, face, 0.03)[0].top, Vec2(2.02, 2));
}

// A pit that swallows all: the soil does not come out at its far side, however narrow it is.
TEST(ThicknessTest, SoilInASlotStaysBeforeItsFarSide) {
    for (const double width : {0.1, 0.2, 0.5, 1.0}) {
        Soil soil;
        soil.bed = BedLine{Polyline{{-20, 0}, {2, 0}, {2, -9}, {2 + width, -9}, {2 + width, 0}, {20, 0}}};
        soil.add_layer(2, 2 + width, 40, -9);
        EXPECT_LE(soil.field().front(), 2 + width);
        EXPECT_GT(soil.field().front(), 2);
    }
}

TEST(ThicknessTest, NodesSayWhatTheSumSays) {
    std::mt19937 random(7);
    for (int k = 0; k < 20; ++k) {
        Soil soil = random_soil(random);
        if (k % 2 == 1) soil.bed = BedLine{Polyline{{-20, 9}, {-3, 9}, {-3, 0}, {4, 0}, {4, 9}, {20, 9}}};
        const ThicknessField field = soil.field();
        for (std::size_t i = 0; i < field.nodes(); ++i) {
            const double x =
                static_cast<double>(field.first_node() + static_cast<long>(i)) * field.node_step();
            EXPECT_NEAR(field.node(i).thickness, field.at(x).thickness, 1e-9);
            EXPECT_NEAR(static_cast<double>(field.beyond_node(i)) * field.particle_area(),
                        field.area_beyond(x), 1e-12);
        }
    }
}

TEST(ThicknessTest, TakesWhatADivergedRunLeaves) {
    Soil soil;
    soil.add_layer(-2, 2, 4);
    soil.add(std::nan(""), 0);
    soil.add(1e300, 1e300, 1e300);
    soil.add(-1e300, 0);
    const ThicknessField field = soil.field();
    EXPECT_GT(field.front(), 2);
    EXPECT_LT(field.nodes(), 1000u);
}

TEST(ReachTest, KeepsTheFarthestFrontAndWhatIsBeyondIt) {
    Soil soil;
    soil.add_layer(-2, 2, 4);
    soil.add(6, 0.1, 7.5);
    ReachRecorder reach(rule, soil.view());
    const double first = reach.front();
    for (double& x : soil.x) x -= 1;
    std::ranges::fill(soil.vx, 2.0);
    reach.look(soil.view());
    EXPECT_NEAR(reach.front(), first - 1, 1e-9);
    EXPECT_EQ(reach.farthest_front(), first);
    EXPECT_EQ(reach.farthest_soil(), 6.0);
    EXPECT_EQ(reach.speed_beyond_front(), 7.5);
    EXPECT_NEAR(reach.peak_front_speed(), 2.0, 1e-9);
    EXPECT_NEAR(reach.soil().area_beyond(reach.front()), spacing * spacing, 1e-12);
}

}  // namespace
}  // namespace runout
