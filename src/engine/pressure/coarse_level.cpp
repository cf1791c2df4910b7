#include "engine/pressure/coarse_level.h"

#include <cholmod.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "engine/pairs/row_passes.h"
#include "engine/threads/node_array.h"

namespace runout {
namespace {

constexpr double cell_spacings = 4.0;
// Cells that a pair can span; more than a support, as dummies count as their boundary particle.
constexpr int reach = 2;
constexpr int span = 2 * reach + 1;

struct Cell {
    long column, row;
    friend bool operator==(const Cell&, const Cell&) = default;
    friend auto operator<=>(const Cell&, const Cell&) = default;
};

constexpr int half = span * span / 2;

/// Matrix entries of a cell: with itself, and with those of the 5 x 5 cells around it that come later by
/// column and row. The others follow, since the matrix is symmetric.
using Stencil = std::array<double, half + 1>;

}  // namespace

/// What `build` works with. Its memory is kept from call to call.
struct CoarseLevel::Cells {
    std::vector<std::vector<Cell>> seen;        ///< per chunk
    std::vector<Cell> list;                     ///< the unknowns, sorted by column and row
    std::vector<std::vector<Stencil>> stencil;  ///< per chunk, of the cells from CellSums::low on
    std::vector<Stencil> whole;                 ///< the sum over the chunks
};

struct CoarseLevel::Factor {
    cholmod_common common{};
    cholmod_factor* factor = nullptr;
    cholmod_dense* solution = nullptr;
    cholmod_dense* work_y = nullptr;
    cholmod_dense* work_e = nullptr;
    std::vector<double> right_hand_side;
    int size = 0;

    // The matrix, lower triangle by columns.
    std::vector<int> column_start, row;
    std::vector<double> value;

    Factor() {
        cholmod_start(&common);
        // Without BLAS the factor has the same bits, whatever BLAS and threads a machine has.
        common.supernodal = CHOLMOD_SIMPLICIAL;
        common.print = 0;
    }
    ~Factor() {
        cholmod_free_factor(&factor, &common);
        cholmod_free_dense(&solution, &common);
        cholmod_free_dense(&work_y, &common);
        cholmod_free_dense(&work_e, &common);
        cholmod_finish(&common);
    }
    Factor(const Factor&) = delete;
    Factor& operator=(const Factor&) = delete;

    void factorise() {
        cholmod_sparse matrix{};
        matrix.nrow = matrix.ncol = static_cast<std::size_t>(size);
        matrix.nzmax = value.size();
        matrix.p = column_start.data();
        matrix.i = row.data();
        matrix.x = value.data();
        matrix.stype = -1;
        matrix.itype = CHOLMOD_INT;
        matrix.xtype = CHOLMOD_REAL;
        matrix.dtype = CHOLMOD_DOUBLE;
        matrix.sorted = 0;
        matrix.packed = 1;
        cholmod_free_factor(&factor, &common);
        factor = cholmod_analyze(&matrix, &common);
        cholmod_factorize(&matrix, factor, &common);
        if (common.status != CHOLMOD_OK)
            throw std::runtime_error("coarse pressure matrix could not be factorised");
    }

    void solve() {
        cholmod_dense b{};
        b.nrow = b.nzmax = b.d = static_cast<std::size_t>(size);
        b.ncol = 1;
        b.x = right_hand_side.data();
        b.xtype = CHOLMOD_REAL;
        b.dtype = CHOLMOD_DOUBLE;
        cholmod_solve2(CHOLMOD_A, factor, &b, nullptr, &solution, nullptr, &work_y, &work_e, &common);
    }
};

CoarseLevel::CoarseLevel(double spacing)
    : size_(cell_spacings * spacing),
      cells_(std::make_unique<Cells>()),
      factor_(std::make_unique<Factor>()) {}
CoarseLevel::~CoarseLevel() = default;

/// Makes room for the sums of so many chunks. Room for more, from an earlier step, is kept.
void CoarseLevel::make_sums(int chunks) {
    chunks_ = chunks;
    if (sums_.size() >= static_cast<std::size_t>(chunks)) return;
    sums_.resize(chunks);
    cells_->stencil.resize(chunks);
}

void CoarseLevel::carry_on(const FineLevel& fine) {
    const Neighbours& n = fine.particles.neighbours;
    const Soil& soil = fine.particles.soil;
    set_rest(cell_, n.soil_count, n.nodes, -1);
    cell_of_id_.resize(soil.count, -1);
    make_sums(n.chunks.count());
    for_each_chunk(n.chunks, [&](int chunk) {
        for_each_soil(n, chunk, [&](int i) { cell_[i] = fine.free[i] ? cell_of_id_[soil.id[i]] : -1; });
        for_each_boundary(n, chunk, [&](int a) {
            const int node = n.first_boundary_node + a;
            cell_[node] = fine.free[node] ? wall_cell_[n.active[a]] : -1;
        });
        find_range(n, chunk);
    });
}

void CoarseLevel::build(const FineLevel& fine) {
    const Neighbours& n = fine.particles.neighbours;
    const RowChunks& chunks = n.chunks;
    place_nodes(fine);
    make_sums(chunks.count());
    for_each_chunk(chunks, [&](int chunk) {
        find_range(n, chunk);
        assemble(fine, chunk);
    });
    collect();
    if (factor_->size > 0) factor_->factorise();
}

/// Numbers the cells that hold free nodes, in order of column and row.
void CoarseLevel::place_nodes(const FineLevel& fine) {
    const Neighbours& n = fine.particles.neighbours;
    const Soil& soil = fine.particles.soil;
    const Wall& wall = fine.particles.wall;
    Cells& cells = *cells_;
    if (cells.seen.size() < n.chunks.list.size()) cells.seen.resize(n.chunks.list.size());
    const auto cell_at = [&](double x, double y) {
        return Cell{static_cast<long>(std::floor(x / size_)), static_cast<long>(std::floor(y / size_))};
    };
    const auto cell_of = [&](int node) {
        if (node < n.soil_count) return cell_at(soil.x[node], soil.y[node]);
        const int b = n.active[node - n.first_boundary_node];
        return cell_at(wall.x[b], wall.y[b]);
    };
    for_each_chunk(n.chunks, [&](int chunk) {
        std::vector<Cell>& seen = cells.seen[chunk];
        seen.clear();  // nodes are in spatial order, so the next is often in the same cell
        for_each_node(n, chunk, [&](int i) {
            if (!fine.free[i]) return;
            const Cell cell = cell_of(i);
            if (seen.empty() || seen.back() != cell) seen.push_back(cell);
        });
        std::sort(seen.begin(), seen.end());
        seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    });
    cells.list.clear();
    for (int c = 0; c < n.chunks.count(); ++c)
        cells.list.insert(cells.list.end(), cells.seen[c].begin(), cells.seen[c].end());
    std::sort(cells.list.begin(), cells.list.end());
    cells.list.erase(std::unique(cells.list.begin(), cells.list.end()), cells.list.end());
    set_rest(cell_, n.soil_count, n.nodes, -1);
    cell_of_id_.resize(soil.count, -1);
    wall_cell_.assign(wall.boundary_count, -1);
    for_each_chunk(n.chunks, [&](int chunk) {
        for_each_node(n, chunk, [&](int i) {
            const auto at = std::lower_bound(cells.list.begin(), cells.list.end(), cell_of(i));
            cell_[i] = fine.free[i] ? static_cast<int>(at - cells.list.begin()) : -1;
        });
        for_each_soil(n, chunk, [&](int i) { cell_of_id_[soil.id[i]] = cell_[i]; });
        for_each_boundary(n, chunk,
                          [&](int a) { wall_cell_[n.active[a]] = cell_[n.first_boundary_node + a]; });
    });
}

/// Which cells the nodes of a chunk are in.
void CoarseLevel::find_range(const Neighbours& n, int chunk) {
    int low = std::numeric_limits<int>::max();
    int high = -1;
    for_each_node(n, chunk, [&](int i) {
        if (cell_[i] < 0) return;
        low = std::min(low, cell_[i]);
        high = std::max(high, cell_[i]);
    });
    sums_[chunk].low = high < 0 ? 0 : low;
    fit(sums_[chunk].sum, high < 0 ? 0 : high - low + 1);
}

/// What the rows of a chunk add to the coarse matrix P^T A P.
void CoarseLevel::assemble(const FineLevel& fine, int chunk) {
    const Neighbours& n = fine.particles.neighbours;
    const Wall& wall = fine.particles.wall;
    const std::vector<Cell>& list = cells_->list;
    std::vector<Stencil>& stencil = cells_->stencil[chunk];
    set_all(stencil, sums_[chunk].sum.size(), Stencil{});
    const auto add = [&](int i, int j, double value) {
        if (cell_[i] < 0 || cell_[j] < 0) return;
        const Cell& own = list[cell_[i]];
        const Cell& other = list[cell_[j]];
        const long dc = other.column - own.column;
        const long dr = other.row - own.row;
        if (std::abs(dc) > reach || std::abs(dr) > reach) return;
        const long later = dc * span + dr;  // by column and row
        if (later >= 0) stencil[cell_[i] - sums_[chunk].low][later] += value;
    };
    for_each_node(n, chunk, [&](int i) { add(i, i, fine.diagonal[i]); });
    const RowChunk& rows = n.chunks.list[chunk];
    for (int b = rows.first_block; b < rows.last_block; ++b) {
        const PairBlock& block = n.blocks[b];
        for_each_pair(block, n,
                      [&](int i, int j, int k) { add(i, j, -static_cast<double>(block.stiffness[k])); });
    }
    for_each_boundary(n, chunk, [&](int a) {
        const int node = n.first_boundary_node + a;
        for (int k = n.boundary_start[a]; k < n.boundary_start[a + 1]; ++k)
            add(node, n.boundary_pairs[k].soil, -static_cast<double>(n.boundary_pairs[k].stiffness));
        for (int k = wall.neighbour_start[n.active[a]]; k < wall.neighbour_start[n.active[a] + 1]; ++k) {
            const int other = n.node_of_boundary[wall.neighbour[k]];
            if (other >= 0) add(node, other, -wall.neighbour_stiffness[k]);
        }
    });
}

/// The coarse matrix: the sum of what the chunks add.
void CoarseLevel::collect() {
    const std::vector<Cell>& list = cells_->list;
    std::vector<Stencil>& whole = cells_->whole;
    set_all(whole, list.size(), Stencil{});
    for (int c = 0; c < chunks_; ++c) {
        for (std::size_t s = 0; s < cells_->stencil[c].size(); ++s) {
            for (int k = 0; k <= half; ++k) whole[sums_[c].low + s][k] += cells_->stencil[c][s][k];
        }
    }
    Factor& f = *factor_;
    f.size = static_cast<int>(list.size());
    f.column_start.assign(1, 0);
    f.row.clear();
    f.value.clear();
    for (int c = 0; c < f.size; ++c) {
        for (int k = 0; k <= half; ++k) {
            const double value = whole[c][k];
            const Cell other{list[c].column + (k + half) / span - reach,
                             list[c].row + (k + half) % span - reach};
            if (value == 0.0) continue;
            const auto at = std::lower_bound(list.begin(), list.end(), other);
            f.row.push_back(static_cast<int>(at - list.begin()));
            f.value.push_back(value);
        }
        f.column_start.push_back(static_cast<int>(f.row.size()));
    }
    set_all(f.right_hand_side, list.size(), 0.0);
}

CoarseCorrection CoarseLevel::solve() {
    Factor& f = *factor_;
    if (f.size == 0) return {};
    std::fill(f.right_hand_side.begin(), f.right_hand_side.end(), 0.0);
    for (int c = 0; c < chunks_; ++c) {
        const CellSums& part = sums_[c];
        for (std::size_t k = 0; k < part.sum.size(); ++k) f.right_hand_side[part.low + k] += part.sum[k];
    }
    f.solve();
    const auto* value = static_cast<const double*>(f.solution->x);
    return {value, std::inner_product(f.right_hand_side.begin(), f.right_hand_side.end(), value, 0.0)};
}

}  // namespace runout
