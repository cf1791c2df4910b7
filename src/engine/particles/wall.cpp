#include "engine/particles/wall.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/particles/kernel.h"

namespace runout {
namespace {

constexpr int wall_layers =
    4;  // one of boundary particles, three of dummies: deeper than the kernel's support

/// The bed line moved back by a distance. Corners are mitred, or bevelled where a mitre would be long.
Polyline offset_line(const BedLine& bed, double distance) {
    const int count = bed.segments();
    Polyline corners;
    const auto corner = [&](int before, int after) {
        const Vec2 n = bed.normal(before);
        const Vec2 m = bed.normal(after);
        const Vec2 at = bed.start(after);
        const double cosine = 1.0 + n.dot(m);
        if (cosine > 0.5) {
            corners.emplace_back(at - distance * (n + m) / cosine);
        } else {  // a spike: bevel
            corners.emplace_back(at - distance * n);
            corners.emplace_back(at - distance * m);
        }
    };
    if (!bed.closed()) corners.emplace_back(bed.start(0) - distance * bed.normal(0));
    for (int s = bed.closed() ? 0 : 1; s < count; ++s) corner((s + count - 1) % count, s);
    if (bed.closed()) {
        corners.push_back(corners.front());
    } else {
        corners.emplace_back(bed.end(count - 1) - distance * bed.normal(count - 1));
    }
    return corners;
}

/// Points along a chain, its corners among them. Between two corners they stand evenly, about one spacing
/// apart; the free ends of an open chain are walked from their corner by exact spacings.
Polyline walk(const Polyline& chain, double spacing, bool closed) {
    Polyline points;
    const std::size_t last = chain.size() - 2;
    for (std::size_t i = 0; i <= last; ++i) {
        const Vec2 along = chain[i + 1] - chain[i];
        const double ratio = along.norm() / spacing;
        const bool free_start = !closed && i == 0 && last > 0;
        const bool free_end = !closed && i == last;
        if (free_start || free_end) {
            const int gaps = static_cast<int>(ratio + 1e-9);
            const Vec2 from = free_start ? chain[i + 1] : chain[i];
            const Vec2 gap = (free_start ? -1.0 : 1.0) / ratio * along;
            for (int k = 0; k <= gaps; ++k) {
                if (free_start && k == 0) continue;  // the corner belongs to the next piece
                points.push_back(from + k * gap);
            }
            if (free_start) std::reverse(points.begin(), points.end());
        } else {
            const int gaps = std::max(1, static_cast<int>(std::lround(ratio)));
            for (int k = 0; k < gaps; ++k)
                points.push_back(chain[i] + along * (static_cast<double>(k) / gaps));
        }
    }
    return points;
}

/// Layer of wall particles, without those that a fold of the offset line brought too near to the bed or to
/// each other.
Polyline layer_points(const BedLine& bed, double depth, double spacing) {
    Polyline kept;
    for (const Vec2& point : walk(offset_line(bed, depth), spacing, bed.closed())) {
        if (std::abs(bed.nearest(point).distance) < depth - 0.3 * spacing) continue;
        const std::size_t tail = kept.size() > 64 ? kept.size() - 64 : 0;
        const bool crowded =
            std::any_of(kept.begin() + static_cast<long>(tail), kept.end(),
                        [&](const Vec2& other) { return (point - other).norm() < 0.6 * spacing; });
        const bool closes = !kept.empty() && (point - kept.front()).norm() < 0.6 * spacing;
        if (!crowded && !closes) kept.push_back(point);
    }
    return kept;
}

void place_particles(Wall& wall, const BedLine& bed, double spacing) {
    for (int layer = 0; layer < wall_layers; ++layer) {
        for (const Vec2& point : layer_points(bed, (layer + 0.5) * spacing, spacing)) {
            wall.x.push_back(point.x());
            wall.y.push_back(point.y());
        }
        if (layer == 0) wall.boundary_count = wall.size();
    }
}

int nearest_boundary(const Wall& wall, const CellGrid& grid, const std::vector<int>& order, double x,
                     double y) {
    int best = 0;
    double best2 = std::numeric_limits<double>::infinity();
    grid.around(x, y, 1, [&](int first, int last) {
        for (int k = first; k < last; ++k) {
            const int b = order[static_cast<std::size_t>(k)];
            const double d2 = std::pow(wall.x[b] - x, 2) + std::pow(wall.y[b] - y, 2);
            if (d2 < best2) {
                best2 = d2;
                best = b;
            }
        }
    });
    return best;
}

void tie_dummies(Wall& wall, double reach) {
    CellGrid grid;
    grid.size = reach;
    std::vector<int> order;
    grid.sort(wall.x, wall.y, {0, wall.boundary_count}, order);
    wall.group.resize(wall.x.size());
    for (int q = 0; q < wall.size(); ++q) {
        wall.group[q] =
            q < wall.boundary_count ? q : nearest_boundary(wall, grid, order, wall.x[q], wall.y[q]);
    }
}

/// Sums over wall neighbours of each boundary particle, once for the whole run.
void sum_wall_neighbours(Wall& wall, const Discretisation& d) {
    const WendlandKernel kernel(d.smoothing_length);
    wall.kernel_sum.assign(static_cast<std::size_t>(wall.boundary_count), 0.0);
    wall.moment.assign(4 * static_cast<std::size_t>(wall.boundary_count), 0.0);
    wall.neighbour_start.assign(1, 0);
    for (int b = 0; b < wall.boundary_count; ++b) {
        wall.grid.around(wall.x[b], wall.y[b], 1, [&](int first, int last) {
            for (int k = first; k < last; ++k) {
                const int q = wall.order[static_cast<std::size_t>(k)];
                const double dx = wall.x[b] - wall.x[q];
                const double dy = wall.y[b] - wall.y[q];
                const double r2 = dx * dx + dy * dy;
                const double r = std::sqrt(r2);
                if (r >= kernel.support()) continue;
                wall.kernel_sum[b] += kernel.value(r);
                const double f = kernel.slope(r) * d.volume();
                double* m = &wall.moment[4 * static_cast<std::size_t>(b)];
                m[0] -= f * dx * dx;
                m[1] -= f * dx * dy;
                m[2] -= f * dy * dx;
                m[3] -= f * dy * dy;
                if (q < wall.boundary_count && q != b) {
                    wall.neighbour.push_back(q);
                    wall.neighbour_stiffness.push_back(d.stiffness(kernel.slope(r), r2));
                }
            }
        });
        wall.neighbour_start.push_back(static_cast<int>(wall.neighbour.size()));
    }
}

}  // namespace

Wall make_wall(const BedLine& bed, const Discretisation& d) {
    Wall wall;
    wall.bed_line = bed;
    place_particles(wall, bed, d.spacing);
    tie_dummies(wall, 2.0 * wall_layers * d.spacing);
    wall.grid.size = WendlandKernel(d.smoothing_length).support();
    wall.grid.sort(wall.x, wall.y, {0, wall.size()}, wall.order);
    for (const int q : wall.order) {
        wall.ordered_x.push_back(wall.x[q]);
        wall.ordered_y.push_back(wall.y[q]);
    }
    for (int b = 0; b < wall.boundary_count; ++b) {
        wall.segment.push_back(bed.nearest({wall.x[b], wall.y[b]}).segment);
    }
    sum_wall_neighbours(wall, d);
    const auto boundary_count = static_cast<std::size_t>(wall.boundary_count);
    wall.pressure.assign(boundary_count, 0.0);
    wall.sxx.assign(boundary_count, 0.0);
    wall.sxy.assign(boundary_count, 0.0);
    return wall;
}

}  // namespace runout
