// The exact polygons, the search for an area, and the walk along the ground.

#include "source/polygons.h"

#include <gtest/gtest.h>

#include <random>

#include "core/units.h"
#include "source/area_search.h"
#include "source/ground_walk.h"

namespace runout {
namespace {

TEST(Region, BoxOnARisingFaceTouchesItWithoutAGap) {
    const Polyline ground{{-1.1, 0.7}, {0, 0}, {3, 0}};
    const Region box_region = box_on_ground(ground, {0, 0.9}, 1.0 / 3, 0.1);
    EXPECT_EQ(box_region.bed_in(ground), ground);
    const double length2 = 1.1 * 1.1 + 0.7 * 0.7;
    EXPECT_NEAR(box_region.area(), length2 / 30, 1e-16);
    EXPECT_NEAR(box_region.area_above({0, -1}, radians(1)), length2 / 30, 1e-16);
    EXPECT_EQ(box_region.area_above({0, 9}, radians(1)), 0);
}

TEST(Region, ConcaveMassTakesTheGroundAboveItsArms) {
    // A hook that reaches under a piece of ground: no overhang may stay.
    const Polyline ground{{0, 10}, {10, 10}, {10, 0}, {20, 0}};
    const auto hook = simple_polygon({{4, 4}, {10, 4}, {10, 5}, {5, 5}, {5, 10}, {4, 10}});
    ASSERT_TRUE(hook);
    const Polyline expected{{0, 10}, {4, 10}, {4, 4}, {10, 4}, {10, 0}, {20, 0}};
    EXPECT_EQ(hook->bed_in(ground), expected);
}

TEST(AreaSearch, FindsTheLastDigitInFewSteps) {
    int calls = 0;
    const auto area = [&](const GroundPoint& p) {
        ++calls;
        const double s = static_cast<double>(p.segment) + p.fraction;
        return 0.3 * s * s + 0.1 * s;
    };
    const std::vector<Stretch> way{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {3, 0, 1}};
    const auto found = point_with_area(way, area, 2.0);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->segment, 2u);
    EXPECT_NEAR(area(*found), 2.0, 2e-14);
    EXPECT_LT(calls, 20);
    EXPECT_FALSE(point_with_area(way, area, 5.21));
    EXPECT_FALSE(point_with_area({}, area, 1));
}

TEST(GroundWalk, GoesAlongTheGroundInBothDirections) {
    const Polyline ground{{0, 4}, {1, 4}, {2, 2}, {2, 0}, {4, 0}};
    const auto up = walk(at_vertex(ground, 4), {1, 0.5});
    ASSERT_EQ(up.size(), 3u);
    EXPECT_EQ(up[0].segment, 3u);
    EXPECT_EQ(up[2].to, 0.5);
    EXPECT_EQ(walk({1, 0.5}, at_vertex(ground, 4)).size(), 3u);
    EXPECT_TRUE(walk({1, 0.5}, {1, 0.5}).empty());
    const auto on_wall = first_at_elevation(ground, up, 0.5);
    ASSERT_TRUE(on_wall);
    EXPECT_EQ(position(ground, *on_wall), Vec2(2, 0.5));
    EXPECT_FALSE(first_at_elevation(ground, up, 3.5));
    EXPECT_EQ(elevation_at(ground, 2), 2);
    EXPECT_EQ(elevation_at(ground, 1.5), 3);
    EXPECT_EQ(without_needless_points({{0, 0}, {1, 1e-14}, {1, 0}, {2, 0}, {3, 1}}, 1e-12).size(), 3u);
}

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
    return distance(p, Polyline{a, b});
}

/// As the declaration has it, asked for each point again.
Polyline plainly_without_needless_points(const Polyline& line, double tolerance) {
    Polyline kept{line.front()};
    std::size_t last = 0;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        bool needless = true;
        for (std::size_t k = last + 1; k <= i && needless; ++k)
            needless = distance_to_segment(line[k], kept.back(), line[i + 1]) <= tolerance;
        if (needless) continue;
        kept.push_back(line[i]);
        last = i;
    }
    kept.push_back(line.back());
    return kept;
}

TEST(GroundWalk, LeavesOutThePointsThatASegmentStandsFor) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0, 1);
    std::size_t left_out = 0;
    for (int round = 0; round < 2000; ++round) {
        Polyline line{{share(random), share(random)}};
        Vec2 way(1, 0);
        for (int i = 0; i < 30; ++i) {
            if (share(random) < 0.2) way = Vec2(0.3 + share(random), share(random) - 0.5);
            const double noise = (share(random) - 0.5) * (share(random) < 0.5 ? 1e-6 : 4e-3);
            line.push_back(line.back() + way * (0.1 + share(random)) + Vec2(0, noise));
        }
        const Polyline kept = without_needless_points(line, 1e-3);
        ASSERT_EQ(kept, plainly_without_needless_points(line, 1e-3)) << round;
        left_out += line.size() - kept.size();
    }
    EXPECT_GT(left_out, 5000u);
}

// 2 x 10^10 comparisons where each point of the stretch is asked for again.
TEST(GroundWalk, ALongStraightStretchCostsNoMoreThanItsPoints) {
    Polyline line;
    for (int i = 0; i < 200'000; ++i) line.emplace_back(i * 1e-3, 1 - i * 1e-3);
    EXPECT_EQ(without_needless_points(line, 1e-9), (Polyline{line.front(), line.back()}));
}

// Lazy numbers that hold each other, one a corner, overflowed the stack.
TEST(Region, ManyCornersHaveAnArea) {
    constexpr int teeth = 30'000;
    std::vector<Vec2> saw{{0, -1}, {2.0 * teeth, -1}};
    for (int i = teeth; i > 0; --i) {
        saw.emplace_back(2 * i, 0);
        saw.emplace_back(2 * i - 1, 1);
    }
    saw.emplace_back(0, 0);
    EXPECT_EQ(simple_polygon(saw)->area(), 3.0 * teeth);
}

}  // namespace
}  // namespace runout
