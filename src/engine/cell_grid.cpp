#include "engine/cell_grid.h"

#include "engine/node_array.h"
#include "engine/parallel.h"

namespace runout {

void CellGrid::cover(const std::vector<double>& x, const std::vector<double>& y, std::size_t count) {
    for (const Column& c : filled) slot[static_cast<std::size_t>(c.place)] = -1;
    filled.clear();
    columns = 0;
    start.assign(1, 0);
    if (count == 0) return;
    const auto [x_low, x_high] = std::minmax_element(x.begin(), x.begin() + static_cast<long>(count));
    column0 = column(*x_low);
    columns = static_cast<int>(column(*x_high) - column0) + 1;
    if (slot.size() < static_cast<std::size_t>(columns))
        set_rest(slot, slot.size(), static_cast<std::size_t>(columns), -1);
    for (std::size_t i = 0; i < count; ++i) {
        const auto place = static_cast<int>(column(x[i]) - column0);
        const long r = row(y[i]);
        int& s = slot[static_cast<std::size_t>(place)];
        if (s < 0) {
            s = static_cast<int>(filled.size());
            filled.push_back({place, r, r});
        }
        Column& c = filled[static_cast<std::size_t>(s)];
        c.low = std::min(c.low, r);
        c.high = std::max(c.high, r);
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
    start.back() = static_cast<int>(count);
}

}  // namespace runout
