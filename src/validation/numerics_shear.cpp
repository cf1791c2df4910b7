// Simple shear: the stress of Coulomb soil does not depend on the rate.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "validation/numerics_checks.h"
#include "validation/numerics_fluid.h"

namespace runout::numerics {
namespace {

constexpr int cells = 60;
constexpr double middle = 0.2;  // half the width of the part that is looked at: far from the free edges
constexpr double pressure = 1000.0;       // Pa
constexpr double friction_angle_deg = 38.0;

/// Mean stress of the middle of a sheared block, over p sin(phi).
struct ShearStress {
    double sxx = 0, sxy = 0;
    double spread = 0;  ///< greatest deviation of |s| from its mean
};

/// Time step at which pressure crosses half a spacing: the limit that holds in slow soil.
double pressure_wave_step(double dl) {
    return 0.5 * dl / std::sqrt(pressure / density);
}

/// A unit block with u = rate y under even pressure, whose gradient at the free edges is taken out of the
/// velocity, as a pressure that balances it would. The velocity is imposed anew in each of `calls`.
ShearStress shear(FrictionScheme scheme, double rate, double dt, int calls, int iterations) {
    Cloud cloud(1.0 / cells, lattice(1.0 / cells, {-0.5, -0.5}, {0.5, 0.5}), no_bed());
    RunSettings settings;
    settings.gravity = 0.0;
    settings.friction = scheme;
    Friction friction(cloud.d, Material{density, radians(friction_angle_deg)}, {}, settings, 1);
    Soil& soil = cloud.soil;
    std::fill_n(soil.pressure.begin(), soil.count, pressure);
    std::vector<double> node_pressure(cloud.n.nodes, 0.0), vx, vy, gx, gy;
    std::fill_n(node_pressure.begin(), soil.count, pressure);
    cloud.pressure_gradient(node_pressure, gx, gy);
    const bool balanced = scheme == FrictionScheme::projected;
    for (int i = 0; i < soil.count; ++i) {
        soil.vx[i] = rate * soil.y[i] + (balanced ? dt / density * gx[i] : 0.0);
        soil.vy[i] = balanced ? dt / density * gy[i] : 0.0;
    }
    for (int k = 0; k < calls; ++k) friction.predict(cloud.n, soil, cloud.wall, dt, vx, vy, iterations);

    ShearStress mean;
    int count = 0;
    const double strength = pressure * std::sin(radians(friction_angle_deg));
    for (int i = 0; i < soil.count; ++i) {
        if (std::max(std::abs(soil.x[i]), std::abs(soil.y[i])) > middle) continue;
        mean.sxx += soil.sxx[i] / strength;
        mean.sxy += soil.sxy[i] / strength;
        ++count;
    }
    mean.sxx /= count;
    mean.sxy /= count;
    return mean;
}

}  // namespace

void check_shear(CaseReport& report) {
    for (const double inertial_number : {0.001, 0.01, 0.1}) {
        const double dl = 1.0 / cells;
        const double rate = inertial_number * std::sqrt(pressure / density) / dl;
        const double dt = pressure_wave_step(dl);
        for (int calls : {1, 5, 20, 50, 100, 400}) {
            auto p = shear(FrictionScheme::projected, rate, dt, calls, 0);
            auto q = shear(FrictionScheme::projected, rate, 0.1*dt, calls, 0);
            fmt::print("I {} calls {} sxx {:.5f} sxy {:.5f}    dt/10 {:.5f} {:.5f}\n", inertial_number, calls, p.sxx, p.sxy, q.sxx, q.sxy);
        }
        auto e = shear(FrictionScheme::explicit_, rate, dt, 1, 0);
        fmt::print("explicit sxx {:.7f} sxy {:.7f}\n", e.sxx, e.sxy);
    }
}

}  // namespace runout::numerics
