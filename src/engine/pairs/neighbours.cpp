#include "engine/pairs/neighbours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/pairs/pair_row.h"
#include "engine/particles/kernel.h"
#include "engine/threads/node_array.h"
#include "engine/threads/parallel.h"

namespace runout {
namespace {

// A grain is alone where the soil around it is no denser than in a row of grains so far apart, and in company
// where it is as dense as in the closer row. In spacings. Pressure in a film as thin as that would press its
// grains apart far more than so little depth can, and films on slopes below repose would creep without end.
constexpr double lone_spacing = 1.6;
constexpr double company_spacing = 1.3;

/// Sum of W over all others of an endless row of grains `distance` apart, 1/m2.
double row_sum(const WendlandKernel& kernel, double distance) {
    double sum = 0.0;
    for (double r = distance; r < kernel.support(); r += distance) sum += 2.0 * kernel.value(r);
    return sum;
}

/// Multiplies all wall pairs of a row by `fraction`.
void fade(WallRow& row, float fraction) {
    for (WallPair& pair : row.merged) {
        for (float* value : {&pair.gx, &pair.gy, &pair.stiffness, &pair.own_gx, &pair.own_gy})
            *value *= fraction;
        pair.own_kernel_value *= fraction;
        pair.own = pair.own && fraction > 0.0F;
    }
    RowSums& sums = row.sums;
    for (double* value :
         {&sums.kernel_sum, &sums.stiffness, &sums.surface_x, &sums.surface_y, &sums.xx, &sums.xy, &sums.yy})
        *value *= fraction;
}

/// Writes the inverse of the moment matrix; the identity for a particle with too few neighbours to have a
/// gradient.
void invert_moment(const double* m, Neighbours& n, int node) {
    const double det = m[0] * m[3] - m[1] * m[2];
    const double size2 = m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + m[3] * m[3];
    const bool lonely = det < 0.1 * size2 || det < 0.05;
    n.correction[0][node] = lonely ? 1.0F : static_cast<float>(m[3] / det);
    n.correction[1][node] = lonely ? 0.0F : static_cast<float>(-m[1] / det);
    n.correction[2][node] = lonely ? 0.0F : static_cast<float>(-m[2] / det);
    n.correction[3][node] = lonely ? 1.0F : static_cast<float>(m[0] / det);
}

/// What one thread works with while it finds the rows of a slice.
struct SliceRows {
    NearSlice soil;
    std::array<WallRow, lanes> wall;
};

/// The last neighbour of a row has the highest number, since rows are filled in spatial order.
void widen_reach(PairBlock& block, const NearSlice& near) {
    for (int l = 0; l < lanes; ++l) {
        if (near.count[l] == 0) continue;
        block.highest =
            std::max(block.highest, static_cast<int>(near.column[(near.count[l] - 1) * lanes + l]));
    }
}

/// Room for one more slice. It is taken for the whole block at once, as if the slices to come were like those
/// that are there: taking it bit by bit would leave holes in memory. New entries hold old values until they
/// are written.
void grow(PairBlock& block, std::size_t size, int slices) {
    if (block.column.size() >= size) return;
    const auto fit_whole = [&](auto& field) {
        make_room(field, std::max(size, size * slices_per_block / static_cast<std::size_t>(slices)));
        field.resize(size);
    };
    fit_whole(block.column);
    for (auto* field : {&block.gx, &block.gy, &block.stiffness}) fit_whole(*field);
}

/// Padding: entries that add 0 to every sum.
void clear(PairBlock& block, std::size_t first, std::size_t last) {
    std::fill(&block.column[first], &block.column[first] + (last - first), 0);
    for (auto* field : {&block.gx, &block.gy, &block.stiffness})
        std::fill(&(*field)[first], &(*field)[first] + (last - first), 0.0F);
}

/// Writes the soil pairs of a slice and finds their geometry. Short lanes are filled up with separations of
/// one support, which add 0 to every sum.
void write_soil_pairs(PairBlock& block, std::size_t first, NearSlice& near, const PairFinder& finder,
                      SliceSums& sums) {
    const int width = near.width();
    for (int l = 0; l < lanes; ++l) {
        for (int slot = near.count[l] * lanes + l; slot < width * lanes; slot += lanes) {
            near.column[slot] = 0;
            near.separation[slot] = {finder.support, 0.0F};
        }
    }
    std::copy_n(near.column.data(), width * lanes, &block.column[first]);
    pair_kernels().slice_geometry(
        {width, near.separation.data(), &block.gx[first], &block.gy[first], &block.stiffness[first]},
        finder.constants, sums);
}

/// Wall pairs follow the soil pairs of their row.
void write_wall_pairs(PairBlock& block, std::size_t first, int first_row, const SliceRows& rows) {
    for (int l = 0; l < lanes; ++l) {
        std::size_t slot = first + l + static_cast<std::size_t>(rows.soil.count[l]) * lanes;
        if (!rows.wall[l].merged.empty()) make_room(block.wall_pairs, rows_per_block);
        for (WallPair pair : rows.wall[l].merged) {
            pair.slot = static_cast<int>(slot);
            pair.row = first_row + l;
            block.wall_pairs.push_back(pair);
            block.gx[slot] = pair.gx;
            block.gy[slot] = pair.gy;
            block.stiffness[slot] = pair.stiffness;
            slot += lanes;
        }
    }
}

/// Brings fields of one length into a new order: `at_once` fields at a time, through the same scratch memory,
/// each thread its share of the new order.
template <class T, std::size_t fields, std::size_t at_once>
void permute(const std::array<std::vector<T>*, fields>& values, const std::vector<int>& order,
             const std::vector<int>& shares, std::array<std::vector<T>, at_once>& scratch) {
    static_assert(fields % at_once == 0);
    for (auto& room : scratch) fit(room, order.size());
    for (std::size_t begin = 0; begin < fields; begin += at_once) {
        for_each_share(shares, [&](int, int first, int last) {
            for (std::size_t k = 0; k < at_once; ++k)
                for (int i = first; i < last; ++i) scratch[k][i] = (*values[begin + k])[order[i]];
        });
        for (std::size_t k = 0; k < at_once; ++k) values[begin + k]->swap(scratch[k]);
    }
}

}  // namespace

NeighbourSearch::NeighbourSearch(const Discretisation& discretisation, int threads)
    : discretisation_(discretisation), threads_(threads) {
    const WendlandKernel kernel(discretisation.smoothing_length);
    grid_.size = kernel.support() / cells_per_support;
    lone_kernel_sum_ = row_sum(kernel, lone_spacing * discretisation.spacing);
    company_kernel_sum_ = row_sum(kernel, company_spacing * discretisation.spacing);
}

void NeighbourSearch::sort(Soil& soil) {
    if (share_rows_.empty() || share_rows_.back() != soil.padded())
        share_rows_ = even_shares(soil.padded(), threads_);
    share_points_ = share_rows_;
    for (int& point : share_points_) point = std::min(point, soil.count);
    grid_.sort(soil.x, soil.y, share_points_, order_);
    for (int i = soil.count; i < soil.padded(); ++i) order_.push_back(i);
    const SoilFields fields = fields_of(soil);
    permute(fields.numbers, order_, share_rows_, scratch_);
    permute(fields.names, order_, share_rows_, name_scratch_);
}

/// In the next step each thread finds the pairs of the rows that it worked on in this one.
void NeighbourSearch::keep_shares(const Neighbours& n) {
    const RowChunks& chunks = n.chunks;
    fit(share_blocks_, chunks.shares() + 1);
    fit(share_rows_, chunks.shares() + 1);
    for (int t = 0; t < chunks.shares(); ++t) {
        share_blocks_[t] = chunks.list[chunks.share_start[t]].first_block;
        share_rows_[t] = share_blocks_[t] * rows_per_block;
    }
    share_blocks_.back() = static_cast<int>(n.blocks.size());
    share_rows_.back() = n.first_boundary_node;
}

void NeighbourSearch::find(const Soil& soil, const Wall& wall, Neighbours& n) {
    n.soil_count = soil.count;
    n.first_boundary_node = soil.padded();
    for (auto* field : {&n.stiffness_sum, &n.surface_x, &n.surface_y})
        set_rest(*field, soil.count, soil.padded(), 0.0);
    set_rest(n.density, soil.count, soil.padded(), 1.0);
    set_rest(n.nearest_boundary, soil.count, soil.padded(), -1);
    fit(n.company, soil.padded());
    for (auto& component : n.correction) set_rest(component, soil.count, soil.padded(), 0.0F);
    const int blocks = (soil.padded() + rows_per_block - 1) / rows_per_block;
    n.blocks.resize(blocks);
    if (share_blocks_.empty() || share_blocks_.back() != blocks)
        share_blocks_ = even_shares(blocks, threads_);
    for_each_share(share_blocks_, [&](int, int first, int last) {
        for (int b = first; b < last; ++b) find_block(soil, wall, n, b);
    });
    number_boundary(soil, wall, n);
    fill_boundary_rows(wall, soil, n);
    cutter_.cut(wall, threads_, n);
    keep_shares(n);
}

void NeighbourSearch::find_block(const Soil& soil, const Wall& wall, Neighbours& n, int b) const {
    thread_local SliceRows rows;
    const PairFinder finder(discretisation_);
    PairBlock& block = n.blocks[b];
    block.first_row = b * rows_per_block;
    block.highest = std::min(block.first_row + rows_per_block, soil.count) - 1;
    block.wall_pairs.clear();
    for (int slice = 0; slice < slices_per_block; ++slice) {
        const int first_row = block.first_row + slice * lanes;
        const bool asleep =
            first_row < soil.count && n.is_asleep(first_row);  // the last block has fewer rows
        if (first_row < soil.count) std::fill_n(&n.company[first_row], lanes, 1.0F);
        const int last_row = std::min(first_row + lanes, soil.count);
        finder.find_soil(grid_, soil, first_row, asleep ? first_row : last_row, rows.soil);
        widen_reach(block, rows.soil);
        std::size_t width = 0;
        for (int l = 0; l < lanes; ++l) {
            rows.wall[l].merged.clear();
            const int i = first_row + l;
            if (i >= last_row) continue;
            finder.find_wall(wall, soil.x[i], soil.y[i], rows.wall[l]);
            width = std::max(width, rows.soil.count[l] + rows.wall[l].merged.size());
        }
        const auto first = static_cast<std::size_t>(block.offset[slice]);
        const std::size_t last = first + width * lanes;
        block.offset[slice + 1] = static_cast<int>(last);
        grow(block, last, slice + 1);
        SliceSums sums{};
        if (width > 0) {
            write_soil_pairs(block, first, rows.soil, finder, sums);
            clear(block, first + static_cast<std::size_t>(rows.soil.width()) * lanes, last);
            if (!asleep) fade_lone_grains(n, first_row, sums, rows.wall);
            write_wall_pairs(block, first, first_row, rows);
        }
        for (int l = 0; l < lanes && first_row + l < soil.count; ++l) {
            if (asleep)
                write_sleeping_sums(n, first_row + l, rows.wall[l]);
            else
                write_sums(n, first_row + l, sums, l, rows.wall[l]);
        }
    }
}

/// A lone grain is a point mass that the bed line carries, see BedGuard: its wall pairs fade.
void NeighbourSearch::fade_lone_grains(Neighbours& n, int first_row, const SliceSums& soil,
                                       std::array<WallRow, lanes>& wall) const {
    for (int l = 0; l < lanes; ++l) {
        // Between the two limits it rises evenly, so that rounding cannot decide what a grain is.
        const double rise =
            (soil.kernel_sum[l] - lone_kernel_sum_) / (company_kernel_sum_ - lone_kernel_sum_);
        const auto fraction = static_cast<float>(std::clamp(rise, 0.0, 1.0));
        n.company[first_row + l] = fraction;
        if (fraction < 1.0F) fade(wall[l], fraction);
    }
}

void NeighbourSearch::write_sleeping_sums(Neighbours& n, int i, const WallRow& wall) const {
    n.density[i] = 1.0;
    n.stiffness_sum[i] = n.surface_x[i] = n.surface_y[i] = 0.0;
    n.nearest_boundary[i] = wall.nearest_boundary;
    n.correction[0][i] = n.correction[3][i] = 1.0F;  // the identity, as where neighbours are too few
    n.correction[1][i] = n.correction[2][i] = 0.0F;
}

void NeighbourSearch::write_sums(Neighbours& n, int i, const SliceSums& soil, int lane,
                                 const WallRow& wall) const {
    const RowSums& w = wall.sums;
    const double self = WendlandKernel(discretisation_.smoothing_length).value(0.0);
    n.density[i] = (self + soil.kernel_sum[lane] + w.kernel_sum) / discretisation_.lattice_sum;
    n.stiffness_sum[i] = soil.stiffness[lane] + w.stiffness;
    n.surface_x[i] = soil.surface_x[lane] + w.surface_x;
    n.surface_y[i] = soil.surface_y[lane] + w.surface_y;
    n.nearest_boundary[i] = wall.nearest_boundary;
    const double xy = soil.xy[lane] + w.xy;  // both off the diagonal: gradW lies along the pair
    const double moment[4] = {soil.xx[lane] + w.xx, xy, xy, soil.yy[lane] + w.yy};
    invert_moment(moment, n, i);
}

void NeighbourSearch::number_boundary(const Soil& soil, const Wall& wall, Neighbours& n) {
    // Sections may be long: nothing here may loop over all boundary particles in every step.
    if (n.node_of_boundary.size() != static_cast<std::size_t>(wall.boundary_count)) {
        n.node_of_boundary.assign(static_cast<std::size_t>(wall.boundary_count), -1);
        n.active.clear();
    }
    for (const int b : n.active) n.node_of_boundary[b] = -1;
    n.left.swap(n.active);
    n.active.clear();
    for (const PairBlock& block : n.blocks) {
        for (const WallPair& pair : block.wall_pairs) {
            if (n.node_of_boundary[pair.wall_index] >= 0) continue;
            n.node_of_boundary[pair.wall_index] = 0;
            n.active.push_back(pair.wall_index);
        }
    }
    std::sort(n.active.begin(), n.active.end());
    for (int a = 0; a < n.active_count(); ++a) n.node_of_boundary[n.active[a]] = n.first_boundary_node + a;
    std::erase_if(n.left, [&](int b) { return n.node_of_boundary[b] >= 0; });
    n.nodes = soil.padded() + n.active_count();
    for_each_share(share_blocks_, [&](int, int first, int last) {
        for (int b = first; b < last; ++b) {
            PairBlock& block = n.blocks[b];
            for (const WallPair& pair : block.wall_pairs)
                block.column[pair.slot] = n.node_of_boundary[pair.wall_index];
        }
    });
}

void NeighbourSearch::fill_boundary_rows(const Wall& wall, const Soil& soil, Neighbours& n) {
    const int count = n.active_count();
    set_all(n.boundary_start, count + 1, 0);
    set_all(n.boundary_soil, count, 0);
    make_room(n.density, n.nodes);
    n.density.resize(n.nodes);
    for (auto& component : n.correction) {
        make_room(component, n.nodes);
        component.resize(n.nodes);
    }
    std::vector<double>& moment = moment_;
    set_all(moment, 4 * count, 0.0);
    for (int a = 0; a < count; ++a) {
        n.density[n.first_boundary_node + a] = wall.kernel_sum[n.active[a]];
        for (int c = 0; c < 4; ++c) moment[4 * a + c] = wall.moment[4 * n.active[a] + c];
    }
    for (const PairBlock& block : n.blocks) {
        for (const WallPair& pair : block.wall_pairs) {
            ++n.boundary_start[n.node_of_boundary[pair.wall_index] - n.first_boundary_node + 1];
        }
    }
    for (int a = 0; a < count; ++a) n.boundary_start[a + 1] += n.boundary_start[a];
    make_room(n.boundary_pairs, n.boundary_start[count]);
    n.boundary_pairs.resize(n.boundary_start[count]);
    make_room(cursor_, n.boundary_start.size());
    cursor_.assign(n.boundary_start.begin(), n.boundary_start.end());
    for (const PairBlock& block : n.blocks) {
        for (const WallPair& pair : block.wall_pairs) {
            const int a = n.node_of_boundary[pair.wall_index] - n.first_boundary_node;
            n.boundary_pairs[cursor_[a]++] = {pair.row,       -pair.gx,     -pair.gy,
                                              pair.stiffness, -pair.own_gx, -pair.own_gy};
            if (!pair.own) continue;
            ++n.boundary_soil[a];
            n.density[n.first_boundary_node + a] += pair.own_kernel_value;
            const double dx = soil.x[pair.row] - wall.x[pair.wall_index];
            const double dy = soil.y[pair.row] - wall.y[pair.wall_index];
            moment[4 * a + 0] += dx * -pair.own_gx;
            moment[4 * a + 1] += dx * -pair.own_gy;
            moment[4 * a + 2] += dy * -pair.own_gx;
            moment[4 * a + 3] += dy * -pair.own_gy;
        }
    }
    for (int a = 0; a < count; ++a) {
        n.density[n.first_boundary_node + a] /= discretisation_.lattice_sum;
        invert_moment(&moment[4 * a], n, n.first_boundary_node + a);
    }
}

}  // namespace runout
