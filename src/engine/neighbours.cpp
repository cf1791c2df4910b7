#include "engine/neighbours.h"

#include <array>
#include <cmath>

#include "engine/pair_row.h"
#include "engine/parallel.h"

namespace runout {
namespace {

/// Inverse of the moment matrix; the identity for a particle too lonely to have a gradient.
void invert_moment(const double* m, Neighbours& n, int node) {
    const double det = m[0] * m[3] - m[1] * m[2];
    const double size2 = m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + m[3] * m[3];
    const bool lonely = det < 0.1 * size2 || det < 0.05;
    n.correction[0][node] = lonely ? 1.0F : static_cast<float>(m[3] / det);
    n.correction[1][node] = lonely ? 0.0F : static_cast<float>(-m[1] / det);
    n.correction[2][node] = lonely ? 0.0F : static_cast<float>(-m[2] / det);
    n.correction[3][node] = lonely ? 1.0F : static_cast<float>(m[0] / det);
}

void write_row(PairBlock& block, const PairRow& row, int row_number, std::size_t first) {
    std::size_t slot = first;
    for (int k = 0; k < row.soil.count; ++k, slot += lanes) {
        block.column[slot] = row.soil.column[k];
        block.gx[slot] = static_cast<float>(row.soil.gx[k]);
        block.gy[slot] = static_cast<float>(row.soil.gy[k]);
        block.stiffness[slot] = static_cast<float>(row.soil.stiffness[k]);
    }
    for (WallPair pair : row.merged) {
        pair.slot = static_cast<int>(slot);
        pair.row = row_number;
        block.wall_pairs.push_back(pair);
        block.gx[slot] = pair.gx;
        block.gy[slot] = pair.gy;
        block.stiffness[slot] = pair.stiffness;
        slot += lanes;
    }
}

void write_slice(PairBlock& block, int slice, const std::array<PairRow, lanes>& rows) {
    std::size_t width = 0;
    for (const PairRow& row : rows) width = std::max(width, row.size());
    const std::size_t first = block.column.size();
    const std::size_t last = first + width * lanes;
    block.column.resize(last, 0);
    block.gx.resize(last, 0.0F);
    block.gy.resize(last, 0.0F);
    block.stiffness.resize(last, 0.0F);
    for (int l = 0; l < lanes; ++l) write_row(block, rows[l], block.first_row + slice * lanes + l, first + l);
    block.offset[slice + 1] = static_cast<int>(last);
}

template <class T>
void permute(std::vector<T>& values, const std::vector<int>& order, std::vector<T>& scratch) {
    scratch.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) scratch[i] = values[order[i]];
    std::copy(scratch.begin(), scratch.end(), values.begin());
}

}  // namespace

NeighbourSearch::NeighbourSearch(const Discretisation& discretisation, int threads)
    : discretisation_(discretisation), kernel_(discretisation.smoothing_length), threads_(threads) {
    grid_.size = kernel_.support() / cells_per_support;
}

void NeighbourSearch::sort(Soil& soil) {
    grid_.sort(soil.x, soil.y, soil.count, order_);
    for (auto* field : {&soil.x, &soil.y, &soil.vx, &soil.vy, &soil.pressure, &soil.sxx, &soil.sxy}) {
        permute(*field, order_, scratch_);
    }
    permute(soil.id, order_, int_scratch_);
    permute(soil.aggregate, order_, int_scratch_);
}

void NeighbourSearch::find(const Soil& soil, const Wall& wall, Neighbours& n) {
    n.soil_count = soil.count;
    n.first_boundary = soil.padded();
    n.stiffness_sum.assign(soil.padded(), 0.0);
    n.surface_x.assign(soil.padded(), 0.0);
    n.surface_y.assign(soil.padded(), 0.0);
    n.nearest_boundary.assign(soil.padded(), -1);
    n.density.assign(soil.padded(), 1.0);
    for (auto& component : n.correction) component.assign(soil.padded(), 0.0F);
    const int blocks = (soil.padded() + rows_per_block - 1) / rows_per_block;
    n.blocks.resize(blocks);
    for_each_block(blocks, threads_, [&](int b) { find_block(soil, wall, n, b); });
    number_boundary(soil, wall, n);
    fill_boundary_rows(wall, soil, n);
}

void NeighbourSearch::find_block(const Soil& soil, const Wall& wall, Neighbours& n, int b) const {
    thread_local std::array<PairRow, lanes> rows;
    PairBlock& block = n.blocks[b];
    block.first_row = b * rows_per_block;
    block.column.clear();
    block.gx.clear();
    block.gy.clear();
    block.stiffness.clear();
    block.wall_pairs.clear();
    for (int slice = 0; slice < slices_per_block; ++slice) {
        for (int l = 0; l < lanes; ++l) {
            PairRow& row = rows[l];
            row.clear();
            const int i = block.first_row + slice * lanes + l;
            if (i >= soil.count) continue;
            find_pair_row(grid_, discretisation_, soil, wall, i, row);
            n.density[i] = row.kernel_sum / discretisation_.lattice_sum;
            n.stiffness_sum[i] = row.stiffness_sum;
            n.surface_x[i] = row.surface_x;
            n.surface_y[i] = row.surface_y;
            n.nearest_boundary[i] = row.nearest_boundary;
            invert_moment(row.moment, n, i);
        }
        write_slice(block, slice, rows);
    }
}

void NeighbourSearch::number_boundary(const Soil& soil, const Wall& wall, Neighbours& n) {
    node_of_boundary_.assign(wall.boundary_count, -1);
    for (const PairBlock& block : n.blocks) {
        for (const WallPair& pair : block.wall_pairs) node_of_boundary_[pair.boundary] = 0;
    }
    n.active.clear();
    for (int b = 0; b < wall.boundary_count; ++b) {
        if (node_of_boundary_[b] < 0) continue;
        node_of_boundary_[b] = n.first_boundary + n.active_count();
        n.active.push_back(b);
    }
    n.nodes = soil.padded() + n.active_count();
    for_each_block(static_cast<int>(n.blocks.size()), threads_, [&](int b) {
        PairBlock& block = n.blocks[b];
        for (const WallPair& pair : block.wall_pairs)
            block.column[pair.slot] = node_of_boundary_[pair.boundary];
    });
}

void NeighbourSearch::fill_boundary_rows(const Wall& wall, const Soil& soil, Neighbours& n) {
    const int count = n.active_count();
    n.boundary_start.assign(count + 1, 0);
    n.boundary_soil.assign(count, 0);
    n.density.resize(n.nodes);
    for (auto& component : n.correction) component.resize(n.nodes);
    std::vector<double>& moment = scratch_;
    moment.assign(4 * count, 0.0);
    for (int a = 0; a < count; ++a) {
        n.density[n.first_boundary + a] = wall.kernel_sum[n.active[a]];
        for (int c = 0; c < 4; ++c) moment[4 * a + c] = wall.moment[4 * n.active[a] + c];
    }
    for (const PairBlock& block : n.blocks) {
        for (const WallPair& pair : block.wall_pairs) {
            ++n.boundary_start[node_of_boundary_[pair.boundary] - n.first_boundary + 1];
        }
    }
    for (int a = 0; a < count; ++a) n.boundary_start[a + 1] += n.boundary_start[a];
    n.boundary_pairs.resize(n.boundary_start[count]);
    cursor_.assign(n.boundary_start.begin(), n.boundary_start.end());
    for (const PairBlock& block : n.blocks) {
        for (const WallPair& pair : block.wall_pairs) {
            const int a = node_of_boundary_[pair.boundary] - n.first_boundary;
            n.boundary_pairs[cursor_[a]++] = {pair.row,       -pair.gx,     -pair.gy,
                                              pair.stiffness, -pair.own_gx, -pair.own_gy};
            if (!pair.own) continue;
            ++n.boundary_soil[a];
            n.density[n.first_boundary + a] += pair.own_kernel;
            const double dx = soil.x[pair.row] - wall.x[pair.boundary];
            const double dy = soil.y[pair.row] - wall.y[pair.boundary];
            moment[4 * a + 0] += dx * -pair.own_gx;
            moment[4 * a + 1] += dx * -pair.own_gy;
            moment[4 * a + 2] += dy * -pair.own_gx;
            moment[4 * a + 3] += dy * -pair.own_gy;
        }
    }
    for (int a = 0; a < count; ++a) {
        n.density[n.first_boundary + a] /= discretisation_.lattice_sum;
        invert_moment(&moment[4 * a], n, n.first_boundary + a);
    }
}

}  // namespace runout
