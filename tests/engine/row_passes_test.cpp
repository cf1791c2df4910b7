// Passes that follow each other through the rows give what one pass after the other gives.

#include "engine/pairs/row_passes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "filled_box.h"

namespace runout {
namespace {

using namespace filled_box;

/// A box filled with enough blocks to be cut, and so high that pairs decide where.
struct High : Filled {
    High() : Filled(60, 700) {}
};

/// One of which blocks and single slices rest in the middle third.
struct PartlyAsleep : High {
    PartlyAsleep() {
        Neighbours& n = neighbours;
        n.asleep.assign(soil.padded() / lanes, 0);
        for (std::size_t s = n.asleep.size() / 3; s < 2 * n.asleep.size() / 3; ++s)
            n.asleep[s] = s / slices_per_block % 2 == 0 || s % 5 == 0 ? 1 : 0;
        search.find(soil, wall, n);
    }
};

int chunk_of(const Neighbours& n, int row) {
    int c = 0;
    while (n.chunks.list[c].last_block * rows_per_block <= row) ++c;
    return c;
}

/// Per active boundary particle.
std::vector<int> chunks_of_boundary(const Neighbours& n) {
    std::vector<int> chunk(n.active_count(), -1);
    for (int c = 0; c < n.chunks.count(); ++c) for_each_boundary(n, c, [&](int a) { chunk[a] = c; });
    return chunk;
}

void expect_no_pair_beyond_the_next_chunk(const High& f) {
    const Neighbours& n = f.neighbours;
    ASSERT_GT(n.chunks.count(), 4);
    for (const PairBlock& block : n.blocks) {
        for_each_pair(block, n, [&](int i, int j, int) {
            if (j >= n.soil_count || n.is_asleep(i) || n.is_asleep(j)) return;
            ASSERT_LE(std::abs(chunk_of(n, i) - chunk_of(n, j)), 1) << i << ' ' << j;
        });
    }
    const std::vector<int> chunk = chunks_of_boundary(n);
    for (int a = 0; a < n.active_count(); ++a) {
        ASSERT_GE(chunk[a], 0) << "boundary " << a;
        for (int p = n.boundary_start[a]; p < n.boundary_start[a + 1]; ++p)
            ASSERT_LE(std::abs(chunk_of(n, n.boundary_pairs[p].soil) - chunk[a]), 1) << "boundary " << a;
        const int b = n.active[a];
        for (int k = f.wall.neighbour_start[b]; k < f.wall.neighbour_start[b + 1]; ++k) {
            const int other = n.node_of_boundary[f.wall.neighbour[k]];
            if (other < 0) continue;
            ASSERT_LE(std::abs(chunk[other - n.first_boundary_node] - chunk[a]), 1) << "boundary " << a;
        }
    }
}

/// Pairs of soil and wall of the chunks of each share.
std::vector<double> work_of_shares(const Neighbours& n) {
    std::vector<double> work;
    for (int share = 0; share < n.chunks.shares(); ++share) {
        double pairs = 0;
        for (int c = n.chunks.share_start[share]; c < n.chunks.share_start[share + 1]; ++c)
            for_each_awake(n, c, [&](const PairRows& rows, int) { pairs += rows.offset[rows.slices]; });
        work.push_back(pairs);
    }
    return work;
}

TEST(RowChunksTest, EachThreadHasTheSameWork) {
    High f;
    NeighbourSearch search(f.d, 2);
    search.find(f.soil, f.wall, f.neighbours);
    const std::vector<double> work = work_of_shares(f.neighbours);
    ASSERT_EQ(work.size(), 2u);
    EXPECT_NEAR(work[0], work[1], 0.01 * work[0]);
}

TEST(RowChunksTest, NoPairReachesBeyondTheNextChunk) {
    expect_no_pair_beyond_the_next_chunk(High());
    expect_no_pair_beyond_the_next_chunk(PartlyAsleep());
}

/// Two fields that are made from each other in turn, pass by pass, as friction makes velocity and stress.
struct Fields {
    std::vector<std::uint64_t> even, odd;

    explicit Fields(const Neighbours& n) : even(n.nodes, 1), odd(n.nodes, 2) {
        for (int i = 0; i < n.nodes; ++i) even[i] += static_cast<std::uint64_t>(i);
    }
    void update_rows(int pass, const PairRows& rows, int last) {
        const auto& from = pass % 2 == 0 ? even : odd;
        auto& to = pass % 2 == 0 ? odd : even;
        for (int i = rows.first_row; i < last; ++i) {
            const int slice = (i - rows.first_row) / lanes;
            for (int e = rows.offset[slice] + (i - rows.first_row) % lanes; e < rows.offset[slice + 1];
                 e += lanes)
                to[i] = 31 * to[i] + (rows.stiffness[e] > 0.0F ? from[rows.column[e]] : 0);
        }
    }
    void update_boundary(const Neighbours& n, int pass, int a) {
        const auto& from = pass % 2 == 0 ? even : odd;
        auto& to = pass % 2 == 0 ? odd : even;
        for (int k = n.boundary_start[a]; k < n.boundary_start[a + 1]; ++k)
            to[n.first_boundary_node + a] =
                31 * to[n.first_boundary_node + a] + from[n.boundary_pairs[k].soil];
    }
};

/// On `threads` threads.
void expect_the_same_as_pass_by_pass(Filled f, int threads) {
    NeighbourSearch search(f.d, threads);
    search.sort(f.soil);
    search.find(f.soil, f.wall, f.neighbours);
    const Neighbours& n = f.neighbours;
    EXPECT_EQ(n.chunks.shares(), std::min(threads, n.chunks.count()));
    constexpr int passes = 7;
    Fields expected(n);
    for (int pass = 0; pass < passes; ++pass) {
        for (const PairBlock& block : n.blocks) {
            for_each_awake_run(
                block, n, [&](const PairRows& rows, int last) { expected.update_rows(pass, rows, last); });
        }
        for (int a = 0; a < n.active_count(); ++a) expected.update_boundary(n, pass, a);
    }
    Fields found(n);
    TeamSignals signals;
    const auto work = [&](int pass, int chunk) {
        for_each_awake(n, chunk,
                       [&](const PairRows& rows, int last) { found.update_rows(pass, rows, last); });
        for_each_boundary(n, chunk, [&](int a) { found.update_boundary(n, pass, a); });
    };
    int met = 0;
    with_team(n.chunks, signals, [&](TeamMember& member) {
        member.for_each_pass(3, work);
        member.synchronise([&] { ++met; });
        EXPECT_EQ(met, 1);
        member.for_each_pass(passes - 3, [&](int pass, int chunk) { work(3 + pass, chunk); });
    });
    EXPECT_EQ(found.even, expected.even);
    EXPECT_EQ(found.odd, expected.odd);
}

TEST(RowPassesTest, GiveWhatOnePassAfterTheOtherGives) {
    for (const int threads : {1, 2, 3, 4}) {
        expect_the_same_as_pass_by_pass(Filled(30), threads);
        expect_the_same_as_pass_by_pass(High(), threads);
        expect_the_same_as_pass_by_pass(PartlyAsleep(), threads);
    }
}

}  // namespace
}  // namespace runout
