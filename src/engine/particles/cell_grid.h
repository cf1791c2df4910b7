#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace runout {

/// The columns of cells that hold something; each goes from its lowest filled cell to its highest.
class FilledColumns {
  public:
    struct Column {
        long column = 0;       ///< in cells from the origin of the plane
        long low = 0;          ///< lowest tier, likewise
        long high = 0;         ///< highest tier
        std::size_t base = 0;  ///< number of its lowest cell
    };

    /// Empties it, and makes room for columns from `first` to `last`.
    void open(long first, long last);
    /// A column holds something in the tiers from `low` to `high`.
    void add(long column, long low, long high) {
        int& s = slot_[static_cast<std::size_t>(column - first_)];
        if (s < 0) {
            s = static_cast<int>(filled_.size());
            filled_.push_back({column, low, high});
        }
        Column& c = filled_[static_cast<std::size_t>(s)];
        c.low = std::min(c.low, low);
        c.high = std::max(c.high, high);
    }
    /// Sorts the columns from left to right and numbers their cells. Returns how many cells there are.
    std::size_t order();

    [[nodiscard]] const std::vector<Column>& filled() const { return filled_; }
    [[nodiscard]] long first() const { return first_; }
    [[nodiscard]] long last() const { return last_; }
    /// Null where the column, from first() to last(), holds nothing.
    [[nodiscard]] const Column* find(long column) const {
        const int s = slot_[static_cast<std::size_t>(column - first_)];
        return s < 0 ? nullptr : &filled_[static_cast<std::size_t>(s)];
    }

  private:
    long first_ = 0;
    long last_ = -1;
    std::vector<Column> filled_;
    std::vector<int> slot_;  ///< per column from first() on: which of `filled`; -1: holds nothing
};

/// Square cells over points of the plane. Particles are sorted by column, so that neighbouring cells of a
/// column are one range of particles. A column that holds nothing has no cells, and each other has cells from
/// its lowest point to its highest only: a single grain may have flown a thousand times as far as the soil is
/// long.
struct CellGrid {
    double size = 1;  ///< edge of a cell, m
    FilledColumns columns;
    std::vector<int> start;  ///< particles of cell c: [start[c], start[c+1])

    /// Where a point stands, in cells from the origin of the plane.
    struct Place {
        int column, tier;
    };
    std::vector<Place> place_of;       ///< of each point covered last
    std::vector<std::size_t> cell_of;  ///< and its cell

    [[nodiscard]] long column(double x) const { return floor_of(x / size); }
    [[nodiscard]] long tier(double y) const { return floor_of(y / size); }

    /// As std::floor, but without a call; the oldest machines have no instruction for that.
    [[nodiscard]] static long floor_of(double value) {
        const auto towards_zero = static_cast<long>(value);
        return towards_zero - (static_cast<double>(towards_zero) > value ? 1 : 0);
    }

    /// Makes cells for the given points and sets `place_of` and `cell_of`. `shares` gives each thread its
    /// points (see even_shares); the last of it is their number.
    void cover(const std::vector<double>& x, const std::vector<double>& y, const std::vector<int>& shares);

    /// The same, and fills `start`, and `order` with the points' indices cell by cell (a stable counting
    /// sort).
    void sort(const std::vector<double>& x, const std::vector<double>& y, const std::vector<int>& shares,
              std::vector<int>& order);

    /// Cells from column to column and tier to tier, both included, in cells from the origin of the plane.
    struct Window {
        long first_column, last_column, first_tier, last_tier;
    };
    [[nodiscard]] Window window_of(double x, double y) const {
        return {column(x), column(x), tier(y), tier(y)};
    }

    /// Calls f(first, last) for each column near a window: the range of its cells within `reach` cells of the
    /// window, both ends included.
    template <class Function>
    void cells_around(const Window& window, int reach, const Function& f) const {
        const long left = std::max(window.first_column - reach, columns.first());
        const long right = std::min(window.last_column + reach, columns.last());
        for (long c = left; c <= right; ++c) {
            const FilledColumns::Column* column = columns.find(c);
            if (column == nullptr) continue;
            const long low = std::max(window.first_tier - reach, column->low);
            const long high = std::min(window.last_tier + reach, column->high);
            if (low > high) continue;
            f(column->base + static_cast<std::size_t>(low - column->low),
              column->base + static_cast<std::size_t>(high - column->low));
        }
    }

    /// Calls f(first, last) for each column near a window: the particles [first, last) of its cells within
    /// `reach` cells of the window.
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
    /// What one thread finds for its share of the points.
    struct Part {
        FilledColumns columns;
        std::size_t low = 0;      ///< lowest cell
        std::vector<int> cursor;  ///< per cell from `low` on: points, then the place of the next in the order
    };
    void find_columns(const std::vector<double>& x, const std::vector<double>& y,
                      const std::vector<int>& shares);
    void count_points(Part& part, int first, int last) const;
    void place_cells(std::size_t shares);

    std::vector<Part> parts_;
    std::vector<int> next_;
};

}  // namespace runout
