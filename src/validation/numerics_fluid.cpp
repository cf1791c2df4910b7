#include "validation/numerics_fluid.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/pairs/operators.h"

namespace runout::numerics {
namespace {

constexpr double smoothing_ratio = 1.3;
constexpr double pressure_wave_courant = 0.5;  // that of Simulation

}  // namespace

std::vector<Vec2> lattice(double spacing, const Vec2& lower, const Vec2& upper) {
    const Vec2 cells = (upper - lower) / spacing;
    std::vector<Vec2> points;
    for (int i = 0; i < std::lround(cells.x()); ++i) {
        for (int j = 0; j < std::lround(cells.y()); ++j)
            points.push_back(lower + spacing * Vec2{i + 0.5, j + 0.5});
    }
    return points;
}

void jitter(std::vector<Vec2>& points, double spacing, double share, unsigned seed) {
    std::mt19937 random(seed);  // not a distribution of the library: those differ from one to the next
    const auto move = [&] {
        return share * spacing * (2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0);
    };
    for (Vec2& p : points) {
        const double dx = move();
        p += Vec2{dx, move()};
    }
}

BedLine no_bed() {
    return BedLine({{-1e3, -1e3}, {-1e3 + 1.0, -1e3}});
}

Cloud::Cloud(double spacing, const std::vector<Vec2>& points, const BedLine& bed_line)
    : d(make_discretisation(spacing, smoothing_ratio, density)), search(d, 1) {
    soil = soil_at(points);
    wall = make_wall(bed_line, d);
    find();
}

void Cloud::find() {
    search.sort(soil);
    search.find(soil, wall, neighbours);
}

NodeVectors Cloud::pressure_gradient(const std::vector<double>& pressure) const {
    const auto nodes = static_cast<std::size_t>(neighbours.nodes);
    NodeVectors gradient{std::vector(nodes, 0.0), std::vector(nodes, 0.0)};
    for (const PairBlock& block : neighbours.blocks)
        pair_kernels().pressure_gradient(pair_rows(block, neighbours), pressure.data(), gradient.x.data(),
                                         gradient.y.data());
    return gradient;
}

Fluid::Fluid(double spacing, const std::vector<Vec2>& points, const BedLine& bed, double speed, double length,
             double gravity)
    : cloud(spacing, points, bed),
      gravity_(gravity),
      friction_(cloud.d, YieldStrength(Material{density, 0.0}, {}, {}), FrictionScheme::projected,
                SolverSettings{}.friction_iterations),
      pressure_(cloud.d, speed * speed / length, length, SolverSettings{}.pressure_tolerance) {}

double Fluid::time_step() const {
    double speed2 = 0.0;
    for (int i = 0; i < cloud.soil.count; ++i)
        speed2 = std::max(speed2, std::pow(cloud.soil.vx[i], 2) + std::pow(cloud.soil.vy[i], 2));
    const double passage = SolverSettings{}.courant * cloud.d.spacing / std::sqrt(speed2);
    if (highest_pressure_ <= 0.0) return passage;
    return std::min(passage,
                    pressure_wave_courant * cloud.d.spacing / std::sqrt(highest_pressure_ / density));
}

void Fluid::step(double end) {
    Soil& soil = cloud.soil;
    cloud.find();
    const double dt = std::min(time_step(), end - time_);
    friction_.predict(cloud, {.dt = dt, .body = {0.0, -gravity_}}, predicted_, gradient_);
    highest_pressure_ = pressure_.solve(cloud, predicted_, {.dt = dt}, gradient_).highest;
    for (int i = 0; i < soil.count; ++i) {
        soil.vx[i] = predicted_.x[i] - dt / density * gradient_.x[i];
        soil.vy[i] = predicted_.y[i] - dt / density * gradient_.y[i];
        soil.x[i] += dt * soil.vx[i];
        soil.y[i] += dt * soil.vy[i];
    }
    guard_wall();
    time_ += dt;
}

/// As Simulation's on a bed that takes nothing of the impulse along itself.
void Fluid::guard_wall() {
    Soil& soil = cloud.soil;
    for (int i = 0; i < soil.count; ++i) {
        const int wall_index = cloud.neighbours.nearest_boundary[i];
        if (wall_index < 0) continue;
        const BedLine::Nearest near =
            cloud.wall.bed_line.nearest({soil.x[i], soil.y[i]}, cloud.wall.segment[wall_index], 8);
        if (near.distance >= 0.0) continue;
        const double back = std::min(-near.distance, 0.5 * cloud.d.spacing);
        const double inward = std::max(0.0, -(soil.vx[i] * near.normal.x() + soil.vy[i] * near.normal.y()));
        soil.x[i] += back * near.normal.x();
        soil.y[i] += back * near.normal.y();
        soil.vx[i] += inward * near.normal.x();
        soil.vy[i] += inward * near.normal.y();
    }
}

double Fluid::kinetic_energy() const {
    double sum = 0.0;
    for (int i = 0; i < cloud.soil.count; ++i)
        sum += std::pow(cloud.soil.vx[i], 2) + std::pow(cloud.soil.vy[i], 2);
    return 0.5 * sum * cloud.d.volume();
}

}  // namespace runout::numerics
