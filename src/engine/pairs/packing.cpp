#include "engine/pairs/packing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "engine/pairs/neighbours.h"
#include "engine/particles/bed_line.h"
#include "engine/particles/wall.h"

namespace runout {
namespace {

constexpr double jitter_size = 0.25;  // in spacings

struct Axes {
    Vec2 origin, along, up;
};

double edge_length(const Polygon& outline, std::size_t i) {
    return (outline[(i + 1) % outline.size()] - outline[i]).norm();
}

/// Longest edge that lies on the bed; for a mass in the air, the longest of all.
std::size_t base_edge(const Mass& mass) {
    const BedLine bed(mass.ground);
    const double tolerance = 1e-6 * std::sqrt(mass.area);
    std::size_t best = 0;
    double best_rank = -1.0;
    for (std::size_t i = 0; i < mass.outline.size(); ++i) {
        const Vec2 a = mass.outline[i];
        const Vec2 b = mass.outline[(i + 1) % mass.outline.size()];
        const bool on_bed = std::abs(bed.nearest(a).distance) < tolerance &&
                            std::abs(bed.nearest(b).distance) < tolerance &&
                            std::abs(bed.nearest(0.5 * (a + b)).distance) < tolerance;
        const bool gentle = std::abs(b.x() - a.x()) > 0.3 * (b - a).norm();  // a scarp is no base
        const double rank = (b - a).norm() + (on_bed ? 1e6 : 0.0) + (on_bed && gentle ? 1e6 : 0.0);
        if (rank > best_rank) {
            best_rank = rank;
            best = i;
        }
    }
    return best;
}

bool is_rectangle(const Polygon& outline) {
    if (outline.size() != 4) return false;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 a = outline[(i + 1) % 4] - outline[i];
        const Vec2 b = outline[(i + 2) % 4] - outline[(i + 1) % 4];
        if (std::abs(a.dot(b)) > 1e-9 * a.norm() * b.norm()) return false;
    }
    return true;
}

bool contains(const Polygon& outline, const Vec2& p) {
    bool inside = false;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Vec2& a = outline[i];
        const Vec2& b = outline[j];
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
            inside = !inside;
        }
    }
    return inside;
}

Packing stretched_lattice(const Polygon& outline, const Axes& axes, std::size_t base, double spacing) {
    const double length = edge_length(outline, base);
    const double height = edge_length(outline, (base + 1) % 4);
    const int count_along = std::max(1, static_cast<int>(std::lround(length / spacing)));
    const int count_up = std::max(1, static_cast<int>(std::lround(height / spacing)));
    Packing packing;
    for (int i = 0; i < count_along; ++i) {
        for (int j = 0; j < count_up; ++j) {
            const Vec2 p = axes.origin + axes.along * (length * (i + 0.5) / count_along) +
                           axes.up * (height * (j + 0.5) / count_up);
            packing.points.push_back(p);
        }
    }
    packing.spacing = std::sqrt(length * height / (static_cast<double>(count_along) * count_up));
    return packing;
}

Packing lattice_inside(const Polygon& outline, const Axes& axes, double spacing) {
    double low_a = 0, high_a = 0, low_u = 0, high_u = 0;
    for (const Vec2& corner : outline) {
        const double a = (corner - axes.origin).dot(axes.along);
        const double u = (corner - axes.origin).dot(axes.up);
        low_a = std::min(low_a, a);
        high_a = std::max(high_a, a);
        low_u = std::min(low_u, u);
        high_u = std::max(high_u, u);
    }
    Packing packing;
    for (int i = static_cast<int>(low_a / spacing) - 1; i * spacing < high_a; ++i) {
        for (int j = static_cast<int>(low_u / spacing) - 1; j * spacing < high_u; ++j) {
            const Vec2 p = axes.origin + axes.along * ((i + 0.5) * spacing) + axes.up * ((j + 0.5) * spacing);
            if (!contains(outline, p)) continue;
            packing.points.push_back(p);
        }
    }
    packing.spacing = spacing;
    return packing;
}

/// Of lattices with slightly different spacings, the one whose number of points inside is nearest to area /
/// spacing^2.
Packing fitted_lattice(const Mass& mass, const Axes& axes, double spacing) {
    const double wanted = mass.area / (spacing * spacing);
    Packing best;
    double best_miss = 1e300;
    for (int k = 0; k <= 40; ++k) {
        const double stretch = 1.0 + 0.0025 * ((k + 1) / 2) * (k % 2 == 0 ? 1.0 : -1.0);
        Packing trial = lattice_inside(mass.outline, axes, spacing * stretch);
        const double miss = std::abs(static_cast<double>(trial.points.size()) - wanted) + 0.01 * k;
        if (trial.points.empty() || miss >= best_miss) continue;
        best_miss = miss;
        best = std::move(trial);
    }
    if (best.points.empty()) {  // a sliver between the lattice lines
        Vec2 centre{0, 0};
        for (const Vec2& corner : mass.outline) centre += corner / static_cast<double>(mass.outline.size());
        best.points = {centre};
    }
    best.spacing = std::sqrt(mass.area / static_cast<double>(best.points.size()));
    return best;
}

/// Moves particles from where it is crowded to where it is not, until none moves by more than 0.002 spacings.
void settle(Packing& packing, const Polygon& outline, double smoothing_ratio) {
    const Discretisation d = make_discretisation(packing.spacing, smoothing_ratio, 1.0);
    const Wall shell = make_wall(BedLine(outline, true), d);
    Soil soil = soil_at(packing.points);
    NeighbourSearch search(d, 1);
    Neighbours n;
    for (int turn = 0; turn < 200; ++turn) {
        search.sort(soil);
        search.find(soil, shell, n);
        double largest = 0.0;
        for (int i = 0; i < soil.count; ++i) {
            // The sum of gradW points to where it is crowded.
            Vec2 shift = -0.5 * d.volume() * Vec2{n.surface_x[i], n.surface_y[i]};
            const double size = shift.norm();
            if (size > 0.1 * d.spacing) shift *= 0.1 * d.spacing / size;
            if (!contains(outline, Vec2{soil.x[i], soil.y[i]} + shift))
                continue;  // squeezed out of a sharp tip
            soil.x[i] += shift.x();
            soil.y[i] += shift.y();
            largest = std::max(largest, shift.norm());
        }
        if (largest < 0.002 * d.spacing) break;
    }
    for (int i = 0; i < soil.count; ++i) packing.points[i] = {soil.x[i], soil.y[i]};
}

/// A number in [0, 1). The same on every machine, which those of the standard library's distributions are
/// not.
double uniform_in_unit(std::mt19937_64& generator) {
    return static_cast<double>(generator() >> 11U) * 0x1p-53;
}

void jitter(Packing& packing, const Polygon& outline, int seed) {
    std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
    for (Vec2& point : packing.points) {
        const Vec2 shift{jitter_size * (2.0 * uniform_in_unit(generator) - 1.0),
                         jitter_size * (2.0 * uniform_in_unit(generator) - 1.0)};
        const Vec2 moved = point + packing.spacing * shift;
        if (contains(outline, moved)) point = moved;
    }
}

}  // namespace

Packing pack_mass(const Mass& mass, double spacing, double smoothing_ratio, int seed) {
    const std::size_t base = base_edge(mass);
    const Vec2 from = mass.outline[base];
    const Vec2 along = (mass.outline[(base + 1) % mass.outline.size()] - from).normalized();
    const Axes axes{from, along, {-along.y(), along.x()}};
    const bool rectangle = is_rectangle(mass.outline);
    Packing packing = rectangle ? stretched_lattice(mass.outline, axes, base, spacing)
                                : fitted_lattice(mass, axes, spacing);
    if (rectangle && seed == 0) return packing;
    if (seed != 0) jitter(packing, mass.outline, seed);
    settle(packing, mass.outline, smoothing_ratio);
    return packing;
}

}  // namespace runout
