#include "validation/columns_pressure.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "validation/profile_misfit.h"

namespace runout {
namespace {

constexpr double neighbourhood = 2.0;  // spacings
constexpr int fewest_neighbours = 6;   // that settle a plane

/// Mean square of what is added; NaN of nothing.
struct MeanSquare {
    double sum = 0;
    long count = 0;
    void add(double value) {
        sum += value * value;
        ++count;
    }
    [[nodiscard]] double root() const {
        return count == 0 ? std::numeric_limits<double>::quiet_NaN()
                          : std::sqrt(sum / static_cast<double>(count));
    }
};

/// Adds the particle's pressure less the plane through those around it; nothing where there are too few.
void add_local(MeanSquare& noise, const Snapshot& s, std::size_t i, double reach, double unit) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    int count = 0;
    for (std::size_t j = 0; j < s.x_m.size(); ++j) {
        const double dx = s.x_m[j] - s.x_m[i];
        const double dy = s.y_m[j] - s.y_m[i];
        if (j == i || dx * dx + dy * dy > reach * reach) continue;
        const Eigen::Vector3d row(1.0, dx / reach, dy / reach);
        normal += row * row.transpose();
        right += row * static_cast<double>(s.pressure_pa[j]);
        ++count;
    }
    if (count < fewest_neighbours) return;
    const Eigen::Vector3d plane = normal.ldlt().solve(right);
    noise.add((s.pressure_pa[i] - plane[0]) / unit);
}

}  // namespace

PressureNoise pressure_noise(const Snapshot& snapshot, const PressureProbe& probe) {
    const std::vector<Vec2> surface = snapshot_surface(snapshot, probe.spacing_m);
    MeanSquare from_lithostatic, local;
    for (std::size_t i = 0; i < snapshot.x_m.size(); ++i) {
        if (snapshot.x_m[i] > probe.x_end_m) continue;
        const double depth = height_at(surface, snapshot.x_m[i], probe.spacing_m) - snapshot.y_m[i];
        from_lithostatic.add((snapshot.pressure_pa[i] - probe.unit_weight * depth) / probe.pressure_unit);
        add_local(local, snapshot, i, neighbourhood * probe.spacing_m, probe.pressure_unit);
    }
    return {from_lithostatic.root(), local.root()};
}

}  // namespace runout
