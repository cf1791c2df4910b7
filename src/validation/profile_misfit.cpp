#include "validation/profile_misfit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace runout {
namespace {

constexpr double link_spacings = 1.6;  // as for the deposit of a run
constexpr double bin_spacings = 2.0;

/// Particles that lie within `reach` of another one.
std::vector<std::size_t> touching(const Snapshot& snapshot, double reach) {
    std::vector<std::size_t> order(snapshot.x_m.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return snapshot.x_m[i]; });
    std::vector<char> touches(order.size(), 0);
    for (std::size_t a = 0; a < order.size(); ++a) {
        const std::size_t i = order[a];
        for (std::size_t b = a + 1; b < order.size(); ++b) {
            const std::size_t j = order[b];
            const double dx = snapshot.x_m[j] - snapshot.x_m[i];
            if (dx > reach) break;
            if (std::hypot(dx, snapshot.y_m[j] - snapshot.y_m[i]) <= reach) touches[i] = touches[j] = 1;
        }
    }
    std::erase_if(order, [&](std::size_t i) { return touches[i] == 0; });
    return order;
}

}  // namespace

std::vector<Vec2> deposit_surface(const std::vector<DepositRow>& deposit) {
    std::vector<Vec2> points;
    points.reserve(deposit.size());
    for (const DepositRow& row : deposit)
        points.emplace_back(row.chainage_m, row.bed_elevation_m + row.thickness_by_top_m);
    return points;
}

std::vector<Vec2> snapshot_surface(const Snapshot& snapshot, double spacing) {
    const double width = bin_spacings * spacing;
    std::vector<Vec2> points;
    // In order of x, so the bins come one after the other.
    for (const std::size_t i : touching(snapshot, link_spacings * spacing)) {
        const double x = (std::floor(snapshot.x_m[i] / width) + 0.5) * width;
        const double top = snapshot.y_m[i] + 0.5 * spacing;
        if (points.empty() || x > points.back().x() + 0.5 * width) points.emplace_back(x, top);
        points.back().y() = std::max(points.back().y(), top);
    }
    return points;
}

std::vector<Vec2> drawn_to_bed(std::vector<Vec2> surface, double spacing) {
    if (surface.empty()) return surface;
    surface.insert(surface.begin(), Vec2(0.0, surface.front().y()));
    surface.emplace_back(surface.back().x() + 0.5 * bin_spacings * spacing, 0.0);
    return surface;
}

double height_at(const std::vector<Vec2>& line, double x, double tail) {
    if (line.empty()) return 0.0;
    if (x <= line.front().x()) return line.front().y();
    const auto next = std::ranges::lower_bound(line, x, {}, [](const Vec2& p) { return p.x(); });
    if (next == line.end()) return line.back().y() * std::max(0.0, 1.0 - (x - line.back().x()) / tail);
    const Vec2& a = *(next - 1);
    return a.y() + (next->y() - a.y()) * (x - a.x()) / (next->x() - a.x());
}

double area_between(const Surface& a, const Surface& b, double end) {
    constexpr int strips = 2000;
    const double dx = end / strips;
    double sum = 0.0;
    for (int k = 0; k < strips; ++k) {
        const double x = (k + 0.5) * dx;
        sum += std::abs(height_at(a.points, x, a.tail) - height_at(b.points, x, b.tail)) * dx;
    }
    return sum;
}

}  // namespace runout
