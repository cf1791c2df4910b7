// Points in cells: against brute force, and in how many cells.

#include "engine/particles/cell_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "engine/threads/parallel.h"

namespace runout {
namespace {

/// A heap, and grains that have flown from it far and deep.
struct Points {
    std::vector<double> x, y;
};

Points heap_with_far_grains(unsigned seed, double farthest) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> heap(-1.0, 1.0);
    std::uniform_real_distribution<double> far(-farthest, farthest);
    Points points;
    for (int i = 0; i < 400; ++i) {
        points.x.push_back(2.0 * heap(random));
        points.y.push_back(heap(random));
    }
    for (int i = 0; i < 20; ++i) {
        points.x.push_back(far(random));
        points.y.push_back(-std::abs(far(random)));
    }
    return points;
}

std::vector<int> shares(const Points& points, unsigned threads) {
    return even_shares(static_cast<int>(points.x.size()), static_cast<int>(threads));
}

std::vector<int> found_around(const CellGrid& grid, const std::vector<int>& order, double x, double y,
                              int reach) {
    std::vector<int> found;
    grid.around(x, y, reach, [&](int first, int last) {
        for (int k = first; k < last; ++k) found.push_back(order[static_cast<std::size_t>(k)]);
    });
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<int> brute_force(const CellGrid& grid, const Points& points, double x, double y, int reach) {
    std::vector<int> found;
    for (int i = 0; i < static_cast<int>(points.x.size()); ++i) {
        const bool near = std::abs(grid.column(points.x[i]) - grid.column(x)) <= reach &&
                          std::abs(grid.tier(points.y[i]) - grid.tier(y)) <= reach;
        if (near) found.push_back(i);
    }
    return found;
}

// One grid for all, as a run uses it: nothing of the points before may be left.
TEST(CellGridTest, FindsWhatBruteForceFindsAlsoWhenUsedAgain) {
    CellGrid grid;
    grid.size = 0.25;
    std::vector<int> order;
    for (unsigned seed = 0; seed < 5; ++seed) {
        const Points points = heap_with_far_grains(seed, seed % 2 == 0 ? 30.0 : 3.0);
        grid.sort(points.x, points.y, shares(points, 1 + seed % 3), order);
        for (std::size_t i = 0; i < points.x.size(); ++i) {
            for (const int reach : {0, 1, 2}) {
                const double x = points.x[i] + 0.3, y = points.y[i] - 0.2;
                ASSERT_EQ(found_around(grid, order, x, y, reach), brute_force(grid, points, x, y, reach))
                    << "seed " << seed << ", point " << i << ", reach " << reach;
            }
        }
    }
}

TEST(CellGridTest, ParticlesAreInTheOrderOfColumnsThenTiersThenTheirOwn) {
    const Points points = heap_with_far_grains(7, 10.0);
    CellGrid grid;
    grid.size = 0.25;
    std::vector<int> order;
    grid.sort(points.x, points.y, shares(points, 3), order);
    const auto key = [&](int i) {
        return std::array<long, 3>{grid.column(points.x[i]), grid.tier(points.y[i]), i};
    };
    ASSERT_EQ(order.size(), points.x.size());
    for (std::size_t k = 1; k < order.size(); ++k) EXPECT_LT(key(order[k - 1]), key(order[k]));
}

// A step must not take longer because a grain has flown far: all that is done for each cell would.
TEST(CellGridTest, FarGrainsAddACellEach) {
    Points points = heap_with_far_grains(3, 1.0);
    CellGrid grid;
    grid.size = 0.25;
    grid.cover(points.x, points.y, shares(points, 2));
    const std::size_t before = grid.start.size();
    for (const double far : {1e4, -2e4, 5e4}) {
        points.x.push_back(far);
        points.y.push_back(-std::abs(far));
    }
    grid.cover(points.x, points.y, shares(points, 2));
    EXPECT_EQ(grid.start.size(), before + 3);
}

TEST(CellGridTest, WithoutPointsNothingIsFound) {
    CellGrid grid;
    std::vector<int> order;
    grid.sort({1.0}, {1.0}, {0, 1}, order);
    grid.sort({}, {}, {0, 0}, order);
    EXPECT_TRUE(found_around(grid, order, 1.0, 1.0, 3).empty());
}

}  // namespace
}  // namespace runout
