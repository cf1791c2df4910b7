#include "measures/deposit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/particles/cell_grid.h"

namespace runout {
namespace {

constexpr double link_spacings = 1.6;
constexpr double bin_spacings = 2.0;
constexpr double deposit_share = 0.01;  // of all particles, that makes a cluster part of the deposit

/// What the debris lies on: the ground, or a barrier on it; an erodible layer counts as ground.
double surface_below(const StateView& state, double x) {
    return std::max(state.ground->elevation(x), state.bed->elevation(x));
}

int root(std::vector<int>& parent, int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

void add_to_bins(DepositProfile& profile, long first, double x, double area) {
    // Shared linearly between the two nearest bins, so that the lattice does not beat with the bins.
    const double at = x / profile.bin_width - 0.5;
    const long low = static_cast<long>(std::floor(at));
    const double upper = at - static_cast<double>(low);
    const auto add = [&](long bin, double share) {
        const long k = std::clamp(bin - first, 0L, static_cast<long>(profile.bins.size()) - 1);
        profile.bins[k].by_mass += share * area / profile.bin_width;
    };
    add(low, 1.0 - upper);
    add(low + 1, upper);
}

}  // namespace

std::vector<char> connected_body(const StateView& state) {
    const int count = static_cast<int>(state.x.size());
    const double link = link_spacings * state.discretisation->spacing;
    const std::vector<double> x(state.x.begin(), state.x.end());
    const std::vector<double> y(state.y.begin(), state.y.end());
    CellGrid grid;
    grid.size = link;
    std::vector<int> order;
    grid.sort(x, y, {0, count}, order);
    std::vector<int> parent(count);
    std::iota(parent.begin(), parent.end(), 0);
    for (int i = 0; i < count; ++i) {
        grid.around(x[i], y[i], 1, [&](int first, int last) {
            for (int k = first; k < last; ++k) {
                const int j = order[k];
                if (j <= i || std::hypot(x[i] - x[j], y[i] - y[j]) > link) continue;
                const int a = root(parent, i);
                const int b = root(parent, j);
                parent[std::max(a, b)] = std::min(a, b);
            }
        });
    }
    std::vector<int> size(count, 0);
    for (int i = 0; i < count; ++i) ++size[root(parent, i)];
    const int largest = *std::max_element(size.begin(), size.end());
    const double least = std::min<double>(largest, std::max(3.0, deposit_share * count));
    std::vector<char> body(count);
    for (int i = 0; i < count; ++i) body[i] = size[root(parent, i)] >= least && state.is_debris(i) ? 1 : 0;
    return body;
}

DepositProfile deposit_profile(const StateView& state, const std::vector<char>& body) {
    DepositProfile profile;
    const double dl = state.discretisation->spacing;
    profile.bin_width = bin_spacings * dl;
    double low = 1e300;
    double high = -1e300;
    for (std::size_t i = 0; i < body.size(); ++i) {
        if (!body[i]) continue;
        low = std::min(low, state.x[i]);
        high = std::max(high, state.x[i]);
    }
    if (low > high) return profile;
    const long first = static_cast<long>(std::floor(low / profile.bin_width));
    const long last = static_cast<long>(std::floor(high / profile.bin_width));
    profile.bins.resize(static_cast<std::size_t>(last - first + 1));
    for (std::size_t k = 0; k < profile.bins.size(); ++k) {
        profile.bins[k].x = (static_cast<double>(first) + static_cast<double>(k) + 0.5) * profile.bin_width;
        profile.bins[k].bed = surface_below(state, profile.bins[k].x);
    }
    for (std::size_t i = 0; i < body.size(); ++i) {
        if (!body[i]) continue;
        add_to_bins(profile, first, state.x[i], dl * dl);
        const long bin_number = static_cast<long>(std::floor(state.x[i] / profile.bin_width)) - first;
        auto& bin = profile.bins[static_cast<std::size_t>(bin_number)];
        bin.by_top = std::max(bin.by_top, state.y[i] + 0.5 * dl - surface_below(state, state.x[i]));
    }
    return profile;
}

double contiguous_front(const DepositProfile& profile, double DepositProfile::Bin::*thickness,
                        double threshold) {
    const auto& bins = profile.bins;
    if (bins.empty()) return 0.0;
    // Parts of the deposit are runs of bins with soil; the most distal part that is thick enough has the
    // front.
    const auto thicker = [&](const auto& a, const auto& b) { return a.*thickness < b.*thickness; };
    auto part_end = bins.end();
    while (part_end != bins.begin()) {
        const auto holds_soil = [](const auto& bin) { return bin.by_top > 0.0; };
        auto part_begin = part_end;
        while (part_begin != bins.begin() && holds_soil(*(part_begin - 1))) --part_begin;
        auto bin = std::max_element(part_begin, part_end, thicker);
        if (bin != part_end && (*bin).*thickness >= threshold) {
            while (bin + 1 != part_end && (*(bin + 1)).*thickness >= threshold) ++bin;
            const double here = (*bin).*thickness;
            const double next = bin + 1 != bins.end() ? (*(bin + 1)).*thickness : 0.0;
            return bin->x + profile.bin_width * (here - threshold) / (here - next);
        }
        part_end = part_begin;
        while (part_end != bins.begin() && !holds_soil(*(part_end - 1))) --part_end;
    }
    return std::max_element(bins.begin(), bins.end(), thicker)->x;
}

double mass_front(const StateView& state, double share) {
    std::vector<double> x;
    for (std::size_t i = 0; i < state.x.size(); ++i)
        if (state.is_debris(i)) x.push_back(state.x[i]);
    const auto beyond = static_cast<std::size_t>(share * static_cast<double>(x.size()));
    std::nth_element(x.begin(), x.begin() + static_cast<long>(beyond), x.end(), std::greater<>());
    return x[beyond];
}

double deposit_area(const StateView& state, const std::vector<char>& body) {
    double area = 0.0;
    for (std::size_t i = 0; i < body.size(); ++i) {
        if (!body[i]) continue;
        area +=
            state.discretisation->volume() / (state.density[i] < surface_density ? 1.0 : state.density[i]);
    }
    return area;
}

double surface_angle(const DepositProfile& profile, double front) {
    const double start = profile.bins.empty() ? front : profile.bins.front().x - 0.5 * profile.bin_width;
    double n = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
    for (const auto& bin : profile.bins) {
        if (bin.x < start + 0.25 * (front - start) || bin.x > start + 0.75 * (front - start)) continue;
        const double y = bin.bed + bin.by_mass;
        n += 1;
        sum_x += bin.x;
        sum_y += y;
        sum_xx += bin.x * bin.x;
        sum_xy += bin.x * y;
    }
    if (n < 3) return std::numeric_limits<double>::quiet_NaN();
    return -std::atan((n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x));
}

double distance_along_bed(const BedLine& bed, double x) {
    double length = 0.0;
    const double low = std::min(0.0, x);
    const double high = std::max(0.0, x);
    for (int s = 0; s < bed.segments(); ++s) {
        const Vec2 a = bed.start(s);
        const Vec2 along = bed.end(s) - a;
        if (along.x() <= 0.0) {  // a vertical face counts where it is passed
            if (a.x() > low && a.x() < high) length += along.norm();
            continue;
        }
        const double from = std::clamp(low, a.x(), a.x() + along.x());
        const double to = std::clamp(high, a.x(), a.x() + along.x());
        length += along.norm() * (to - from) / along.x();
    }
    return x < 0.0 ? -length : length;
}

}  // namespace runout
