#include "engine/particles/cell_grid.h"

#include <limits>

#include "engine/threads/node_array.h"
#include "engine/threads/parallel.h"

namespace runout {

void FilledColumns::open(long first, long last) {
    for (const Column& c : filled_) slot_[static_cast<std::size_t>(c.column - first_)] = -1;
    filled_.clear();
    first_ = first;
    last_ = last;
    const auto width = static_cast<std::size_t>(std::max(0L, last - first + 1));
    if (slot_.size() < width) set_rest(slot_, slot_.size(), width, -1);
}

std::size_t FilledColumns::order() {
    std::sort(filled_.begin(), filled_.end(),
              [](const Column& a, const Column& b) { return a.column < b.column; });
    std::size_t cells = 0;
    for (std::size_t s = 0; s < filled_.size(); ++s) {
        Column& c = filled_[s];
        slot_[static_cast<std::size_t>(c.column - first_)] = static_cast<int>(s);
        c.base = cells;
        cells += static_cast<std::size_t>(c.high - c.low) + 1;
    }
    return cells;
}

void CellGrid::cover(const std::vector<double>& x, const std::vector<double>& y,
                     const std::vector<int>& shares) {
    const auto count = static_cast<std::size_t>(shares.back());
    fit(place_of, count);
    fit(cell_of, count);
    find_columns(x, y, shares);
    set_all(start, columns.order() + 1, 0);
    for_each_share(shares, [&](int, int first, int last) {
        for (int i = first; i < last; ++i) {
            const Place& place = place_of[i];
            const FilledColumns::Column& c = *columns.find(place.column);
            cell_of[i] = c.base + static_cast<std::size_t>(place.tier - c.low);
        }
    });
}

/// Where the points stand, and which columns hold something, from where to where.
void CellGrid::find_columns(const std::vector<double>& x, const std::vector<double>& y,
                            const std::vector<int>& shares) {
    const std::size_t count = shares.size() - 1;
    if (parts_.size() < count) parts_.resize(count);
    for_each_share(shares, [&](int t, int first, int last) {
        long left = std::numeric_limits<long>::max();
        long right = std::numeric_limits<long>::min();
        for (int i = first; i < last; ++i) {
            const Place place{static_cast<int>(column(x[i])), static_cast<int>(tier(y[i]))};
            place_of[i] = place;
            left = std::min<long>(left, place.column);
            right = std::max<long>(right, place.column);
        }
        FilledColumns& own = parts_[t].columns;
        if (first == last) return own.open(0, -1);
        own.open(left, right);
        for (int i = first; i < last; ++i) own.add(place_of[i].column, place_of[i].tier, place_of[i].tier);
    });
    long left = std::numeric_limits<long>::max();
    long right = std::numeric_limits<long>::min();
    for (std::size_t t = 0; t < count; ++t) {
        if (parts_[t].columns.filled().empty()) continue;
        left = std::min(left, parts_[t].columns.first());
        right = std::max(right, parts_[t].columns.last());
    }
    if (left > right) return columns.open(0, -1);
    columns.open(left, right);
    for (std::size_t t = 0; t < count; ++t) {
        for (const FilledColumns::Column& c : parts_[t].columns.filled())
            columns.add(c.column, c.low, c.high);
    }
}

void CellGrid::sort(const std::vector<double>& x, const std::vector<double>& y,
                    const std::vector<int>& shares, std::vector<int>& order) {
    cover(x, y, shares);
    fit(order, static_cast<std::size_t>(shares.back()));
    for_each_share(shares, [&](int t, int first, int last) { count_points(parts_[t], first, last); });
    place_cells(shares.size() - 1);
    for_each_share(shares, [&](int t, int first, int last) {
        Part& part = parts_[t];
        for (int i = first; i < last; ++i) order[part.cursor[cell_of[i] - part.low]++] = i;
    });
}

/// How many points [first, last) each cell holds.
void CellGrid::count_points(Part& part, int first, int last) const {
    std::size_t low = std::numeric_limits<std::size_t>::max();
    std::size_t high = 0;
    for (int i = first; i < last; ++i) {
        low = std::min(low, cell_of[i]);
        high = std::max(high, cell_of[i]);
    }
    part.low = first == last ? 0 : low;
    set_all(part.cursor, first == last ? 0 : high - low + 1, 0);
    for (int i = first; i < last; ++i) ++part.cursor[cell_of[i] - low];
}

/// Where the points of each cell begin in the order, those of the first share first.
void CellGrid::place_cells(std::size_t shares) {
    for (std::size_t t = 0; t < shares; ++t) {
        const Part& part = parts_[t];
        for (std::size_t c = 0; c < part.cursor.size(); ++c) start[part.low + c + 1] += part.cursor[c];
    }
    for (std::size_t c = 1; c < start.size(); ++c) start[c] += start[c - 1];
    make_room(next_, start.size());
    next_.assign(start.begin(), start.end());
    for (std::size_t t = 0; t < shares; ++t) {
        Part& part = parts_[t];
        for (std::size_t c = 0; c < part.cursor.size(); ++c) {
            const int points = part.cursor[c];
            part.cursor[c] = next_[part.low + c];
            next_[part.low + c] += points;
        }
    }
}

}  // namespace runout
