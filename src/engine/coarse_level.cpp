#include "engine/coarse_level.h"

#include <cholmod.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "engine/node_array.h"

namespace runout {
namespace {

constexpr int reach = 2;  // cells that a pair can span: supports merge through boundary particles
constexpr int span = 2 * reach + 1;

struct Cell {
    long column, row;
    friend bool operator==(const Cell&, const Cell&) = default;
    friend auto operator<=>(const Cell&, const Cell&) = default;
};

/// Couplings of a cell with the 5 x 5 cells around it.
using Stencil = std::array<double, span * span>;

}  // namespace

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

    // What `build` works with, kept from call to call.
    std::vector<Cell> cell_of, cells;
    std::vector<Stencil> stencil;

    Factor() {
        cholmod_start(&common);
        // No BLAS in the factor: the same bits whatever BLAS and threads a machine has.
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

CoarseLevel::CoarseLevel() : factor_(std::make_unique<Factor>()) {}
CoarseLevel::~CoarseLevel() = default;

namespace {

/// Numbers the cells that hold free nodes, in order of column and row.
void number_cells(const std::vector<Cell>& cell_of, const std::vector<char>& free, std::vector<Cell>& cells,
                  std::vector<int>& aggregate) {
    cells.clear();  // nodes in spatial order: the next is often in the same cell
    for (std::size_t i = 0; i < cell_of.size(); ++i) {
        if (free[i] && (cells.empty() || cells.back() != cell_of[i])) cells.push_back(cell_of[i]);
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    set_all(aggregate, cell_of.size(), -1);
    for (std::size_t i = 0; i < cell_of.size(); ++i) {
        if (!free[i]) continue;
        aggregate[i] =
            static_cast<int>(std::lower_bound(cells.begin(), cells.end(), cell_of[i]) - cells.begin());
    }
}

}  // namespace

void CoarseLevel::build(const Neighbours& n, const Soil& soil, const Wall& wall,
                        const std::vector<double>& diagonal, const std::vector<char>& free, double cell,
                        std::vector<int>& aggregate) {
    Factor& f = *factor_;
    std::vector<Cell>& cell_of = f.cell_of;
    std::vector<Cell>& cells = f.cells;
    std::vector<Stencil>& stencil = f.stencil;
    set_all(cell_of, n.nodes, Cell{0, 0});
    const auto place = [&](int node, double x, double y) {
        cell_of[node] = {static_cast<long>(std::floor(x / cell)), static_cast<long>(std::floor(y / cell))};
    };
    for (int i = 0; i < soil.count; ++i) place(i, soil.x[i], soil.y[i]);
    for (int a = 0; a < n.active_count(); ++a) {
        place(n.first_boundary + a, wall.x[n.active[a]], wall.y[n.active[a]]);
    }
    number_cells(cell_of, free, cells, aggregate);

    set_all(stencil, cells.size(), Stencil{});
    const auto add = [&](int i, int j, double value) {
        if (aggregate[i] < 0 || aggregate[j] < 0) return;
        const long dc = cell_of[j].column - cell_of[i].column;
        const long dr = cell_of[j].row - cell_of[i].row;
        if (std::abs(dc) > reach || std::abs(dr) > reach) return;
        stencil[aggregate[i]][(dc + reach) * span + dr + reach] += value;
    };
    for (int i = 0; i < n.nodes; ++i) add(i, i, diagonal[i]);
    for (const PairBlock& block : n.blocks) {
        for (int slice = 0; slice < slices_per_block; ++slice) {
            for (int e = block.offset[slice]; e < block.offset[slice + 1]; ++e) {
                if (block.stiffness[e] == 0.0F) continue;
                const int i = block.first_row + slice * lanes + (e - block.offset[slice]) % lanes;
                const int j = block.column[e];
                add(i, j, -static_cast<double>(block.stiffness[e]));
                if (j >= n.first_boundary) add(j, i, -static_cast<double>(block.stiffness[e]));
            }
        }
    }
    for (int a = 0; a < n.active_count(); ++a) {
        const int b = n.active[a];
        for (int k = wall.neighbour_start[b]; k < wall.neighbour_start[b + 1]; ++k) {
            const auto other = std::lower_bound(n.active.begin(), n.active.end(), wall.neighbour[k]);
            if (other == n.active.end() || *other != wall.neighbour[k]) continue;
            add(n.first_boundary + a, n.first_boundary + static_cast<int>(other - n.active.begin()),
                -wall.neighbour_stiffness[k]);
        }
    }

    f.size = static_cast<int>(cells.size());
    f.column_start.assign(1, 0);
    f.row.clear();
    f.value.clear();
    for (int c = 0; c < f.size; ++c) {
        for (int k = 0; k < span * span; ++k) {
            const double value = stencil[c][k];
            const Cell other{cells[c].column + k / span - reach, cells[c].row + k % span - reach};
            if (value == 0.0 || other < cells[c]) continue;
            const auto at = std::lower_bound(cells.begin(), cells.end(), other);
            f.row.push_back(static_cast<int>(at - cells.begin()));
            f.value.push_back(value);
        }
        f.column_start.push_back(static_cast<int>(f.row.size()));
    }
    set_all(f.right_hand_side, cells.size(), 0.0);
    if (f.size > 0) f.factorise();
}

CoarseCorrection CoarseLevel::solve(const std::vector<CellSums>& sums) {
    Factor& f = *factor_;
    if (f.size == 0) return {};
    std::fill(f.right_hand_side.begin(), f.right_hand_side.end(), 0.0);
    for (const CellSums& part : sums) {
        for (std::size_t k = 0; k < part.sum.size(); ++k) f.right_hand_side[part.low + k] += part.sum[k];
    }
    f.solve();
    const auto* value = static_cast<const double*>(f.solution->x);
    return {value, std::inner_product(f.right_hand_side.begin(), f.right_hand_side.end(), value, 0.0)};
}

}  // namespace runout
