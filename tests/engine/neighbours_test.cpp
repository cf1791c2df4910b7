// Who is near whom: against brute force, and against a search that starts anew.

#include "engine/pairs/neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "engine/simd/instruction_set.h"
#include "filled_box.h"

namespace runout {
namespace {

using namespace filled_box;

TEST(NeighboursTest, FindsEveryPairThatBruteForceFinds) {
    Filled f(15);
    std::vector<int> row_length(f.soil.count, 0);
    for (const PairBlock& block : f.neighbours.blocks) {
        for (int s = 0; s < slices_per_block; ++s) {
            for (int e = block.offset[s]; e < block.offset[s + 1]; ++e) {
                const int i = block.first_row + s * lanes + (e - block.offset[s]) % lanes;
                if (block.stiffness[e] > 0.0F && block.column[e] < f.neighbours.first_boundary_node)
                    ++row_length[i];
            }
        }
    }
    const double support = 2.0 * f.d.smoothing_length;
    for (int i = 0; i < f.soil.count; ++i) {
        int expected = 0;
        for (int j = 0; j < f.soil.count; ++j) {
            if (j != i && std::hypot(f.soil.x[i] - f.soil.x[j], f.soil.y[i] - f.soil.y[j]) < support)
                ++expected;
        }
        EXPECT_EQ(row_length[i], expected) << "particle " << i;
    }
}

/// What one instruction set finds near rows 4 to 11 of a slice, among all particles but two.
struct Found {
    std::vector<int> count = std::vector<int>(lanes, -1);
    std::vector<std::int32_t> column;
    std::vector<double> separation;
    friend bool operator==(const Found&, const Found&) = default;
};

Found find_near_rows(const PairKernels& kernels, const Soil& soil, float support2) {
    constexpr int first_row = 2 * lanes;
    std::vector<std::int32_t> candidate;
    for (int i = 1; i + 1 < soil.count; ++i) candidate.push_back(i);  // no whole number of fours
    Found found;
    constexpr std::int32_t untouched = -1;
    std::vector<std::int32_t> column(lanes * (candidate.size() + 1), untouched);
    std::vector<FloatPair> separation(column.size());
    kernels.select_near_slice(soil.x.data(), soil.y.data(),
                              {first_row, 0x0FF0, static_cast<int>(candidate.size()), candidate.data()},
                              support2, {found.count.data(), column.data(), separation.data()});
    for (int l = 0; l < lanes; ++l) {
        if (found.count[l] < 0) {
            EXPECT_EQ(column[l], untouched) << "a lane that does not ask";
        }
        for (int k = 0; k < found.count[l]; ++k) {
            found.column.push_back(column[k * lanes + l]);
            found.separation.insert(found.separation.end(),
                                    {separation[k * lanes + l].x, separation[k * lanes + l].y});
        }
    }
    return found;
}

Found find_near_rows_one_by_one(const Soil& soil, float support2) {
    Found found;
    for (int l = 4; l < 12; ++l) {
        const int i = 2 * lanes + l;
        found.count[l] = 0;
        for (int j = 1; j + 1 < soil.count; ++j) {
            const auto dx = static_cast<float>(soil.x[i] - soil.x[j]);
            const auto dy = static_cast<float>(soil.y[i] - soil.y[j]);
            if (j == i || dx * dx + dy * dy >= support2) continue;
            ++found.count[l];
            found.column.push_back(j);
            found.separation.insert(found.separation.end(), {dx, dy});
        }
    }
    return found;
}

TEST(NeighboursTest, EveryInstructionSetFindsTheSameNearRows) {
    for (const double squeeze : {1.0, 0.2}) {  // squeezed, rows have more near them than the widest way holds
        Filled f(12);
        for (int i = 0; i < f.soil.count; ++i) {
            f.soil.x[i] = squeeze * (f.soil.x[i] + 0.3 * spacing * std::sin(12.9898 * i));
            f.soil.y[i] *= squeeze;
        }
        const auto support = static_cast<float>(2.0 * f.d.smoothing_length);
        const float support2 = support * support;
        const Found expected = find_near_rows_one_by_one(f.soil, support2);
        ASSERT_GT(expected.column.size(), squeeze < 1.0 ? 8U * 64U : 80U);
        for (const InstructionSet set : instruction_sets) {
            if (machine_has(set)) {
                EXPECT_EQ(find_near_rows(pair_kernels(set), f.soil, support2), expected) << to_string(set);
            }
        }
    }
}

// A field that were forgotten would give its values to other particles.
TEST(NeighboursTest, SortingCarriesEveryField) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
    std::vector<Vec2> points;
    for (int i = 0; i < 500; ++i) points.emplace_back(anywhere(random), anywhere(random));
    Soil soil = soil_at(points);
    const auto mark = [](int id, std::size_t field) { return 1000.0 * id + static_cast<double>(field); };
    const SoilFields fields = fields_of(soil);
    for (std::size_t k = 2; k < fields.numbers.size(); ++k)
        for (int i = 0; i < soil.count; ++i) (*fields.numbers[k])[i] = mark(i, k);
    NeighbourSearch search(make_discretisation(spacing, 1.3, density), 1);
    search.sort(soil);
    const SoilFields sorted = fields_of(soil);
    bool moved = false;
    for (int i = 0; i < soil.count; ++i) {
        moved = moved || soil.id[i] != i;
        ASSERT_EQ(Vec2(soil.x[i], soil.y[i]), points[soil.id[i]]);
        for (std::size_t k = 2; k < sorted.numbers.size(); ++k)
            ASSERT_EQ((*sorted.numbers[k])[i], mark(soil.id[i], k)) << "field " << k;
    }
    EXPECT_TRUE(moved);
}

TEST(NeighboursTest, GrainsThatFlyAloneHaveTheDensityOfOne) {
    // More of them than stand in a slice of rows: none of its rows has a pair.
    const Discretisation d = make_discretisation(spacing, 1.3, density);
    std::vector<Vec2> points;
    for (int i = 0; i < 2 * lanes; ++i) points.emplace_back(i * 10 * spacing, 1.0);
    Soil soil = soil_at(points);
    const Wall wall = make_wall(BedLine({{-1, -1}, {1, -1}}), d);
    NeighbourSearch search(d, 1);
    Neighbours n;
    search.sort(soil);
    search.find(soil, wall, n);
    const double alone = WendlandKernel(d.smoothing_length).value(0.0) / d.lattice_sum;
    EXPECT_LT(alone, 0.6);
    for (int i = 0; i < soil.count; ++i) {
        EXPECT_DOUBLE_EQ(n.density[i], alone);
        EXPECT_EQ(n.correction[0][i], 1.0F);
    }
}

/// What a block says of its rows, without the room it keeps for longer ones.
std::vector<double> entries(const PairBlock& block) {
    std::vector<double> all(std::begin(block.offset), std::end(block.offset));
    for (int e = 0; e < block.offset[slices_per_block]; ++e) {
        for (const double value : {static_cast<double>(block.column[e]), static_cast<double>(block.gx[e]),
                                   static_cast<double>(block.gy[e]), static_cast<double>(block.stiffness[e])})
            all.push_back(value);
    }
    for (const WallPair& pair : block.wall_pairs) {
        for (const double value : {static_cast<double>(pair.row), static_cast<double>(pair.wall_index),
                                   static_cast<double>(pair.slot), static_cast<double>(pair.own_gx)})
            all.push_back(value);
    }
    return all;
}

TEST(NeighboursTest, MemoryOfACrowdedStepLeavesNoTraceInASparseOne) {
    Filled f(20);
    NeighbourSearch search(f.d, 1);
    Neighbours reused;
    search.sort(f.soil);
    search.find(f.soil, f.wall, reused);
    // Farther apart, and off one wall: every row is shorter, and some boundary particles have no soil left.
    for (int i = 0; i < f.soil.count; ++i) {
        f.soil.x[i] = 1.4 * f.soil.x[i] + 6 * spacing;
        f.soil.y[i] *= 1.4;
    }
    search.sort(f.soil);
    search.find(f.soil, f.wall, reused);
    Neighbours fresh;
    NeighbourSearch anew(f.d, 1);
    anew.sort(f.soil);
    anew.find(f.soil, f.wall, fresh);

    EXPECT_FALSE(reused.left.empty());
    EXPECT_EQ(reused.active, fresh.active);
    EXPECT_EQ(reused.nodes, fresh.nodes);
    ASSERT_EQ(reused.blocks.size(), fresh.blocks.size());
    for (std::size_t b = 0; b < fresh.blocks.size(); ++b)
        EXPECT_EQ(entries(reused.blocks[b]), entries(fresh.blocks[b])) << "block " << b;
    const auto same = [&](const auto& a, const auto& b, int count) {
        return std::equal(a.begin(), a.begin() + count, b.begin(), b.begin() + count);
    };
    EXPECT_TRUE(same(reused.density, fresh.density, fresh.nodes));
    for (int c = 0; c < 4; ++c)
        EXPECT_TRUE(same(reused.correction[c], fresh.correction[c], fresh.nodes)) << "component " << c;
    EXPECT_TRUE(same(reused.stiffness_sum, fresh.stiffness_sum, f.soil.padded()));
    EXPECT_TRUE(same(reused.surface_x, fresh.surface_x, f.soil.padded()));
    EXPECT_TRUE(same(reused.surface_y, fresh.surface_y, f.soil.padded()));
    EXPECT_TRUE(same(reused.nearest_boundary, fresh.nearest_boundary, f.soil.padded()));
    EXPECT_TRUE(same(reused.company, fresh.company, f.soil.count));
    EXPECT_EQ(reused.boundary_start, fresh.boundary_start);
    EXPECT_EQ(reused.boundary_soil, fresh.boundary_soil);
}

}  // namespace
}  // namespace runout
