#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace runout {

/// Square cells over points of the plane. Cells of one column are contiguous, so that three neighbouring
/// cells of a column are one range of particles. There are cells only where a column holds something, from
/// its lowest point to its highest: a single grain may have flown a thousand times as far as the soil is
/// long.
struct CellGrid {
    /// A column that holds something.
    struct Column {
        int place = 0;  ///< in the window
        long low = 0;   ///< first and last row, in cells from the origin of the plane
        long high = 0;
        std::size_t base = 0;  ///< its first cell
    };

    double size = 1;             ///< edge of a cell, m
    long column0 = 0;            ///< first column of the window, in cells from the origin of the plane
    int columns = 0;             ///< of the window
    std::vector<Column> filled;  ///< from left to right
    std::vector<int> slot;       ///< per column of the window: which of `filled`; -1: holds nothing
    std::vector<int> start;      ///< particles of cell c: [start[c], start[c+1])

    /// Where a point stands, in cells from the origin of the plane.
    struct Place {
        long column, row;
    };
    std::vector<Place> place_of;       ///< of each point covered last
    std::vector<std::size_t> cell_of;  ///< and its cell

    [[nodiscard]] long column(double x) const { return floor_of(x / size); }
    [[nodiscard]] long row(double y) const { return floor_of(y / size); }

    /// As std::floor, without a call: the oldest machines have no instruction for it.
    [[nodiscard]] static long floor_of(double value) {
        const auto towards_zero = static_cast<long>(value);
        return towards_zero - (static_cast<double>(towards_zero) > value ? 1 : 0);
    }

    /// Makes cells for the given points, empty, and says in `cell_of` which each belongs to.
    void cover(const std::vector<double>& x, const std::vector<double>& y, std::size_t count,
               int threads = 1);

    /// Stable counting sort: fills `start`, and `order` with particle indices cell by cell.
    void sort(const std::vector<double>& x, const std::vector<double>& y, std::size_t count,
              std::vector<int>& order, int threads = 1);

    /// Cells from column to column and row to row, both included, in cells from the origin of the plane.
    struct Window {
        long first_column, last_column, first_row, last_row;
    };
    [[nodiscard]] Window window_of(double x, double y) const {
        return {column(x), column(x), row(y), row(y)};
    }

    /// Calls f(first, last) for the ranges of cells, one a column and both ends included, within `reach`
    /// cells of a window.
    template <class Function>
    void cells_around(const Window& window, int reach, const Function& f) const {
        const long left = std::max(window.first_column - column0 - reach, 0L);
        const long right = std::min(window.last_column - column0 + reach, static_cast<long>(columns) - 1);
        for (long c = left; c <= right; ++c) {
            const int s = slot[static_cast<std::size_t>(c)];
            if (s < 0) continue;
            const Column& column = filled[static_cast<std::size_t>(s)];
            const long low = std::max(window.first_row - reach, column.low);
            const long high = std::min(window.last_row + reach, column.high);
            if (low > high) continue;
            f(column.base + static_cast<std::size_t>(low - column.low),
              column.base + static_cast<std::size_t>(high - column.low));
        }
    }

    /// Calls f(first, last) for the particle ranges, one a column, that hold everything within `reach` cells
    /// of a window.
    template <class Function>
    void around(const Window& window, int reach, const Function& f) const {
        cells_around(window, reach, [&](std::size_t low, std::size_t high) {
            if (start[low] < start[high + 1]) f(start[low], start[high + 1]);
        });
    }

    /// The same around the cell of a point: up to 2 reach + 1 ranges.
    template <class Function>
    void around(double x, double y, int reach, const Function& f) const {
        around(window_of(x, y), reach, f);
    }

  private:
    void find_columns();
};

}  // namespace runout
