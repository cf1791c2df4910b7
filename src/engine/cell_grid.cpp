#include "engine/cell_grid.h"

#include "engine/node_array.h"
#include "engine/parallel.h"

namespace runout {

void CellGrid::cover(const std::vector<double>& x, const std::vector<double>& y, std::size_t count,
                     int threads) {
    fit(place_of, count);
    fit(cell_of, count);
    const auto size_of_all = static_cast<int>(count);
    for_each_piece(size_of_all, threads, [&](int first, int last) {
        for (int i = first; i < last; ++i) place_of[i] = {column(x[i]), row(y[i])};
    });
    find_columns();
    for_each_piece(size_of_all, threads, [&](int first, int last) {
        for (int i = first; i < last; ++i) {
            const Place& place = place_of[i];
            const Column& c = filled[slot[place.column - column0]];
            cell_of[i] = c.base + static_cast<std::size_t>(place.row - c.low);
        }
    });
}

/// Which columns hold something, from where to where.
void CellGrid::find_columns() {
    for (const Column& c : filled) slot[static_cast<std::size_t>(c.place)] = -1;
    filled.clear();
    columns = 0;
    start.assign(1, 0);
    if (place_of.empty()) return;
    const auto [left, right] = std::minmax_element(
        place_of.begin(), place_of.end(), [](const Place& a, const Place& b) { return a.column < b.column; });
    column0 = left->column;
    columns = static_cast<int>(right->column - column0) + 1;
    if (slot.size() < static_cast<std::size_t>(columns))
        set_rest(slot, slot.size(), static_cast<std::size_t>(columns), -1);
    for (const Place& place : place_of) {
        int& s = slot[static_cast<std::size_t>(place.column - column0)];
        if (s < 0) {
            s = static_cast<int>(filled.size());
            filled.push_back({static_cast<int>(place.column - column0), place.row, place.row});
        }
        Column& c = filled[static_cast<std::size_t>(s)];
        c.low = std::min(c.low, place.row);
        c.high = std::max(c.high, place.row);
    }
    std::sort(filled.begin(), filled.end(),
              [](const Column& a, const Column& b) { return a.place < b.place; });
    std::size_t cells = 0;
    for (std::size_t s = 0; s < filled.size(); ++s) {
        Column& c = filled[s];
        slot[static_cast<std::size_t>(c.place)] = static_cast<int>(s);
        c.base = cells;
        cells += static_cast<std::size_t>(c.high - c.low) + 1;
    }
    set_all(start, cells + 1, 0);
}

void CellGrid::sort(const std::vector<double>& x, const std::vector<double>& y, std::size_t count,
                    std::vector<int>& order, int threads) {
    cover(x, y, count, threads);
    order.resize(count);
    for (const std::size_t c : cell_of) ++start[c + 1];
    for (std::size_t c = 1; c < start.size(); ++c) start[c] += start[c - 1];
    for (std::size_t i = count; i-- > 0;) {  // backwards, then `start` is shifted into place below
        order[static_cast<std::size_t>(--start[cell_of[i] + 1])] = static_cast<int>(i);
    }
    // start[c+1] now holds the first particle of cell c; move it down by one.
    for (std::size_t c = 0; c + 1 < start.size(); ++c) start[c] = start[c + 1];
    start.back() = static_cast<int>(count);
}

}  // namespace runout
