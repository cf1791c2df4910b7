#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/node_array.h"

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

    [[nodiscard]] long column(double x) const { return static_cast<long>(std::floor(x / size)); }
    [[nodiscard]] long row(double y) const { return static_cast<long>(std::floor(y / size)); }

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
              std::vector<int>& order) {
        cover(x, y, count);
        order.resize(count);
        for (std::size_t i = 0; i < count; ++i) ++start[cell(x[i], y[i]) + 1];
        for (std::size_t c = 1; c < start.size(); ++c) start[c] += start[c - 1];
        for (std::size_t i = count; i-- > 0;) {  // backwards, then `start` is shifted into place below
            order[static_cast<std::size_t>(--start[cell(x[i], y[i]) + 1])] = static_cast<int>(i);
        }
        // start[c+1] now holds the first particle of cell c; move it down by one.
        for (std::size_t c = 0; c + 1 < start.size(); ++c) start[c] = start[c + 1];
        if (!start.empty()) start.back() = static_cast<int>(count);
    }

    /// Calls f(first, last) for the up to 2 reach + 1 particle ranges that hold everything within `reach`
    /// cells.
    template <class Function>
    void around(double x, double y, int reach, const Function& f) const {
        const long cx = column(x) - column0;
        const long cy = row(y) - row0;
        const long low = std::max(cy - reach, 0L);
        const long high = std::min(cy + reach, static_cast<long>(rows) - 1);
        if (low > high) return;
        for (long c = std::max(cx - reach, 0L); c <= std::min(cx + reach, static_cast<long>(columns) - 1);
             ++c) {
            const int s = slot[static_cast<std::size_t>(c)];
            if (s < 0) continue;
            const std::size_t base = static_cast<std::size_t>(s) * static_cast<std::size_t>(rows);
            const int first = start[base + static_cast<std::size_t>(low)];
            const int last = start[base + static_cast<std::size_t>(high) + 1];
            if (first < last) f(first, last);
        }
    }
};

}  // namespace runout
