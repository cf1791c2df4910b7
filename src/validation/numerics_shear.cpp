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
constexpr double middle = 0.2;       // half the width of the part that is looked at, far from the free edges
constexpr double pressure = 1000.0;  // Pa
constexpr double friction_angle_deg = 38.0;
// Time steps in dl / sqrt(p / rho). A run takes at most half of it (pressure wave); with a tenth of that the
// stress of the slowest rate is built up in 20 steps, before the free edges are felt in the middle.
constexpr double longest_step = 0.5;
constexpr double small_step = 0.05;
constexpr int steps = 20;

/// Mean stress of the middle of the block, over p sin(phi).
struct ShearStress {
    double sxx = 0, sxy = 0;
};

/// A unit block with u = rate y under even pressure. The velocity is imposed anew in each step.
class ShearedBlock {
  public:
    /// `inertial_number`: rate dl sqrt(rho / p). `step`: in dl / sqrt(p / rho).
    ShearedBlock(FrictionScheme scheme, double inertial_number, double step);
    void shear() { friction_.predict(cloud_, {.dt = dt_}, predicted_, gradient_); }
    [[nodiscard]] ShearStress stress() const;
    /// Shear strain in one step.
    [[nodiscard]] double strain() const { return rate_ * dt_; }

  private:
    void balance_pressure();

    double rate_, dt_;
    Cloud cloud_;
    Friction friction_;
    NodeVectors predicted_, gradient_;
};

ShearedBlock::ShearedBlock(FrictionScheme scheme, double inertial_number, double step)
    : rate_(inertial_number * cells * std::sqrt(pressure / density)),
      dt_(step / cells / std::sqrt(pressure / density)),
      cloud_(1.0 / cells, lattice(1.0 / cells, {-0.5, -0.5}, {0.5, 0.5}), no_bed()),
      friction_(cloud_.d, YieldStrength(Material{density, radians(friction_angle_deg)}, {}, {}), scheme,
                SolverSettings{}.friction_iterations) {
    Soil& soil = cloud_.soil;
    std::fill_n(soil.pressure.begin(), soil.count, pressure);
    for (int i = 0; i < soil.count; ++i) soil.vx[i] = rate_ * soil.y[i];
    if (scheme == FrictionScheme::projected) balance_pressure();
}

/// The projected scheme adds the pressure gradient to the velocity. At the free edges of the block that of
/// an even pressure does not vanish; it is taken out beforehand.
void ShearedBlock::balance_pressure() {
    Soil& soil = cloud_.soil;
    std::vector<double> node_pressure(cloud_.neighbours.nodes, 0.0);
    std::fill_n(node_pressure.begin(), soil.count, pressure);
    const NodeVectors gradient = cloud_.pressure_gradient(node_pressure);
    for (int i = 0; i < soil.count; ++i) {
        soil.vx[i] += dt_ / density * gradient.x[i];
        soil.vy[i] += dt_ / density * gradient.y[i];
    }
}

ShearStress ShearedBlock::stress() const {
    const Soil& soil = cloud_.soil;
    const double strength = pressure * std::sin(radians(friction_angle_deg));
    ShearStress mean;
    int count = 0;
    for (int i = 0; i < soil.count; ++i) {
        if (std::max(std::abs(soil.x[i]), std::abs(soil.y[i])) > middle) continue;
        mean.sxx += soil.sxx[i] / strength;
        mean.sxy += soil.sxy[i] / strength;
        ++count;
    }
    return {mean.sxx / count, mean.sxy / count};
}

void add_rate(CaseReport& report, FrictionScheme scheme, double inertial_number) {
    const bool projected = scheme == FrictionScheme::projected;
    ShearedBlock block(scheme, inertial_number, small_step);
    for (int k = 0; k < (projected ? steps : 1); ++k) block.shear();
    const ShearStress stress = block.stress();
    const std::string name =
        fmt::format("shear, {}, I = {}: ", projected ? "projected" : "explicit", inertial_number);
    const std::string resolution = fmt::format("L/dl = {}", cells);
    report.entries.push_back(exact(name + "shear stress over p sin(phi)", 1.0, -stress.sxy,
                                   DeviationKind::absolute, 1e-3, resolution));
    report.entries.push_back(exact(name + "normal stress sxx over p sin(phi)", 0.0, stress.sxx,
                                   DeviationKind::absolute, projected ? 0.01 : 1e-5, resolution));
}

/// The projected scheme at the longest step that a run takes.
void add_longest_step(CaseReport& report) {
    ShearedBlock block(FrictionScheme::projected, 0.01, longest_step);
    int taken = 0;
    double strain_at_yield = ValidationEntry::none;
    for (; taken < 100; ++taken) {
        block.shear();
        if (std::isnan(strain_at_yield) && block.stress().sxy < -0.99)
            strain_at_yield = (taken + 1) * block.strain();
    }
    const ShearStress stress = block.stress();
    const std::string name = "shear, projected, I = 0.01, longest step: ";
    const std::string resolution = fmt::format("L/dl = {}", cells);
    report.entries.push_back(exact(name + "shear stress over p sin(phi)", 1.0, -stress.sxy,
                                   DeviationKind::absolute, 0.01, resolution));
    report.entries.push_back(exact(name + "normal stress sxx over p sin(phi)", 0.0, stress.sxx,
                                   DeviationKind::absolute, 0.06, resolution,
                                   "the principal axes turn with the soil in a step"));
    report.entries.push_back(error_entry(name + "shear strain from no stress to 99 % of yield",
                                         strain_at_yield, ValidationEntry::none, resolution));
}

}  // namespace

void check_shear(CaseReport& report) {
    for (const auto scheme : {FrictionScheme::projected, FrictionScheme::explicit_}) {
        for (const double inertial_number : {0.001, 0.01, 0.1}) add_rate(report, scheme, inertial_number);
    }
    add_longest_step(report);
}

}  // namespace runout::numerics
