#include "engine/effects/pore_pressure.h"

#include <algorithm>
#include <cmath>

namespace runout {
namespace {

constexpr double column_spacings = 2.0;

/// Linear between the points, constant beyond them.
double interpolate(const std::vector<Vec2>& points, double x) {
    if (x <= points.front().x()) return points.front().y();
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (x > points[i].x()) continue;
        const Vec2 &a = points[i - 1], &b = points[i];
        return a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x());
    }
    return points.back().y();
}

}  // namespace

void ColumnThickness::measure(const Neighbours& n, const Soil& soil, const Discretisation& discretisation) {
    width_ = column_spacings * discretisation.spacing;
    const auto [low, high] = std::minmax_element(soil.x.begin(), soil.x.begin() + soil.count);
    first_ = *low - width_;
    thickness_.assign(static_cast<std::size_t>((*high - *low) / width_) + 4, 0.0);
    const double added = discretisation.volume() / width_;
    for (int i = 0; i < soil.count; ++i) {
        if (n.density[i] < body_density) continue;
        const double at = (soil.x[i] - first_) / width_;
        const auto column = static_cast<std::size_t>(at);
        const double upper = at - static_cast<double>(column);
        thickness_[column] += (1.0 - upper) * added;
        thickness_[column + 1] += upper * added;
    }
}

double ColumnThickness::at(double x) const {
    const double at = std::clamp((x - first_) / width_, 0.0, static_cast<double>(thickness_.size()) - 1.001);
    const auto column = static_cast<std::size_t>(at);
    const double upper = at - static_cast<double>(column);
    return (1.0 - upper) * thickness_[column] + upper * thickness_[column + 1];
}

PoreWater::PoreWater(const PorePressure& effect, const Discretisation& discretisation, double gravity,
                     const std::vector<Vec2>& starts)
    : effect_(effect), discretisation_(discretisation), gravity_(gravity) {
    append(starts);
}

void PoreWater::append(const std::vector<Vec2>& starts) {
    for (const Vec2& start : starts)
        ratio_.push_back(effect_.field.empty() ? effect_.ratio : interpolate(effect_.field, start.x()));
}

const std::vector<double>& PoreWater::find(const ParticleSystem& particles, double time) {
    const Neighbours& n = particles.neighbours;
    const Soil& soil = particles.soil;
    const Wall& wall = particles.wall;
    thickness_.measure(n, soil, discretisation_);
    const double excess = effect_.base_excess * std::exp(-time / effect_.dissipation_time);
    const double weight = discretisation_.density * gravity_;
    const auto depth = [&](double x, double y) {
        return std::max(0.0, wall.bed_line.elevation(x) + thickness_.at(x) - y);
    };
    pressure_.assign(n.nodes, 0.0);
    for (int i = 0; i < soil.count; ++i) {
        const double ratio = ratio_[soil.id[i]] + (n.nearest_boundary[i] >= 0 ? excess : 0.0);
        if (ratio > 0.0) pressure_[i] = ratio * weight * depth(soil.x[i], soil.y[i]);
    }
    for (int a = 0; a < n.active_count(); ++a) {
        // The bed has the water of the soil on it: the mean over its pairs.
        double sum = 0.0;
        for (int k = n.boundary_start[a]; k < n.boundary_start[a + 1]; ++k)
            sum += ratio_[soil.id[n.boundary_pairs[k].soil]];
        const int pairs = n.boundary_start[a + 1] - n.boundary_start[a];
        const double ratio = sum / std::max(1, pairs) + excess;
        const int b = n.active[a];
        pressure_[n.first_boundary_node + a] = ratio * weight * depth(wall.x[b], wall.y[b]);
    }
    return pressure_;
}

}  // namespace runout
