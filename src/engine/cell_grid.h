#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "engine/node_array.h"
#include "engine/parallel.h"

namespace runout {

/// Square cells over a window of the plane. Cells of one column are contiguous, so that three neighbouring
/// cells of a column are one range of particles. Only columns that hold something have cells: single grains
/// may lie far from each other.
struct CellGrid {
    double size = 1;   ///< edge of a cell, m
    long column0 = 0;  ///< first column and row of the window, in cells from the origin of the plane
    long row0 = 0;
    int columns = 0;
    int rows = 0;
    std::vector<int> slot;   ///< per column of the window: which of those that hold something; -1: none
    std::vector<int> start;  ///< particles of cell c: [start[c], start[c+1])

    std::vector<std::size_t> cell_of;  ///< of each point sorted last

    [[nodiscard]] long column(double x) const { return floor_of(x / size); }
    [[nodiscard]] long row(double y) const { return floor_of(y / size); }

    /// As std::floor, without a call: the oldest machines have no instruction for it.
    [[nodiscard]] static long floor_of(double value) {
        const auto towards_zero = static_cast<long>(value);
        return towards_zero - (static_cast<double>(towards_zero) > value ? 1 : 0);
    }

    /// Sets the window to cover the given points, empty.
    void cover(const std::vector<double>& x, const std::vector<double>& y, std::size_t count) {
        columns = rows = 0;
        start.assign(1, 0);
        slot.clear();
        if (count == 0) return;
        const auto [x_low, x_high] = std::minmax_element(x.begin(), x.begin() + static_cast<long>(count));
        const auto [y_low, y_high] = std::minmax_element(y.begin(), y.begin() + static_cast<long>(count));
        column0 = column(*x_low);
        row0 = row(*y_low);
        columns = static_cast<int>(column(*x_high) - column0) + 1;
        rows = static_cast<int>(row(*y_high) - row0) + 1;
        set_all(slot, static_cast<std::size_t>(columns), -1);
        for (std::size_t i = 0; i < count; ++i) slot[static_cast<std::size_t>(column(x[i]) - column0)] = 0;
        int filled = 0;
        for (int& s : slot) {
            if (s == 0) s = filled++;
        }
        set_all(start, static_cast<std::size_t>(filled) * static_cast<std::size_t>(rows) + 1, 0);
    }

    /// Index of the cell of one of the points that the window covers.
    [[nodiscard]] std::size_t cell(double x, double y) const {
        const auto s = static_cast<std::size_t>(slot[static_cast<std::size_t>(column(x) - column0)]);
        return s * static_cast<std::size_t>(rows) + static_cast<std::size_t>(row(y) - row0);
    }

    /// Stable counting sort: fills `start`, and `order` with particle indices cell by cell.
    void sort(const std::vector<double>& x, const std::vector<double>& y, std::size_t count,
              std::vector<int>& order, int threads = 1) {
        cover(x, y, count);
        order.resize(count);
        fit(cell_of, count);
        for_each_piece(static_cast<int>(count), threads, [&](int first, int last) {
            for (int i = first; i < last; ++i) cell_of[i] = cell(x[i], y[i]);
        });
        for (const std::size_t c : cell_of) ++start[c + 1];
        for (std::size_t c = 1; c < start.size(); ++c) start[c] += start[c - 1];
        for (std::size_t i = count; i-- > 0;) {  // backwards, then `start` is shifted into place below
            order[static_cast<std::size_t>(--start[cell_of[i] + 1])] = static_cast<int>(i);
        }
        // start[c+1] now holds the first particle of cell c; move it down by one.
        for (std::size_t c = 0; c + 1 < start.size(); ++c) start[c] = start[c + 1];
        if (!start.empty()) start.back() = static_cast<int>(count);
    }

    /// Cells from column to column and row to row, both included, in cells from the origin of the plane.
    struct Window {
        long first_column, last_column, first_row, last_row;
    };

    /// Calls f(first, last) for the particle ranges, one a column, that hold everything within `reach` cells
    /// of a window.
    template <class Function>
    void around(const Window& window, int reach, const Function& f) const {
        const long low = std::max(window.first_row - row0 - reach, 0L);
        const long high = std::min(window.last_row - row0 + reach, static_cast<long>(rows) - 1);
        if (low > high) return;
        const long left = std::max(window.first_column - column0 - reach, 0L);
        const long right = std::min(window.last_column - column0 + reach, static_cast<long>(columns) - 1);
        for (long c = left; c <= right; ++c) {
            const int s = slot[static_cast<std::size_t>(c)];
            if (s < 0) continue;
            const std::size_t base = static_cast<std::size_t>(s) * static_cast<std::size_t>(rows);
            const int first = start[base + static_cast<std::size_t>(low)];
            const int last = start[base + static_cast<std::size_t>(high) + 1];
            if (first < last) f(first, last);
        }
    }

    /// The same around the cell of a point: up to 2 reach + 1 ranges.
    template <class Function>
    void around(double x, double y, int reach, const Function& f) const {
        around(Window{column(x), column(x), row(y), row(y)}, reach, f);
    }
};

}  // namespace runout
