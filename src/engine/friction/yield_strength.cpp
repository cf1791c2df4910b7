#include "engine/friction/yield_strength.h"

#include <algorithm>
#include <cmath>

namespace runout {

double base_strength_ratio(const Material& material, const Effects& effects, double x) {
    const double own = std::sin(material.friction_angle);
    if (!effects.base_friction) return own;
    double angle = effects.base_friction->angle;
    for (const FrictionRange& range : effects.base_friction->ranges)
        if (x >= range.from && x < range.to) angle = range.angle;
    return std::isnan(angle) ? own : std::min(own, std::tan(angle));
}

double least_strength(const Material& material, const Effects& effects) {
    double strength = std::sin(material.friction_angle);
    if (!effects.base_friction) return strength;
    const auto weaken = [&](double angle) {
        if (!std::isnan(angle)) strength = std::min(strength, std::tan(angle));
    };
    weaken(effects.base_friction->angle);
    for (const FrictionRange& range : effects.base_friction->ranges) weaken(range.angle);
    return strength;
}

std::vector<double> base_strength_ratios(const Material& material, const Effects& effects, const Wall& wall) {
    if (!effects.base_friction) return {};
    std::vector<double> ratios;
    for (int b = 0; b < wall.boundary_count; ++b)
        ratios.push_back(base_strength_ratio(material, effects, wall.x[b]));
    const double own = std::sin(material.friction_angle);
    const bool rough = std::all_of(ratios.begin(), ratios.end(), [=](double ratio) { return ratio == own; });
    if (rough) ratios.clear();
    return ratios;
}

std::vector<char> slipping_base(const Material& material, const Effects& effects, const Wall& wall) {
    const double own = std::sin(material.friction_angle);
    std::vector<char> slips;
    for (const double ratio : base_strength_ratios(material, effects, wall))
        slips.push_back(ratio < own ? 1 : 0);
    return slips;
}

double tension_cut_off(const Material& material, const Effects& effects) {
    if (!effects.cohesion) return 0.0;
    const double uniaxial = effects.cohesion->strength * std::cos(material.friction_angle) /
                            (1.0 + std::sin(material.friction_angle));
    return std::isnan(effects.cohesion->tension) ? uniaxial : effects.cohesion->tension;
}

YieldStrength::YieldStrength(const Material& material, const Effects& effects,
                             std::vector<double> base_ratios)
    : sin_phi_(std::sin(material.friction_angle)),
      cohesion_(effects.cohesion ? effects.cohesion->strength * std::cos(material.friction_angle) : 0.0),
      tension_(tension_cut_off(material, effects)),
      rate_(effects.rate),
      wet_(effects.pore_pressure.has_value()),
      base_ratios_(std::move(base_ratios)) {}

/// mu(I) = sin(phi) + increase / (1 + I0/I), I = 2 |e| d sqrt(rho_s / p) (Jop, Forterre & Pouliquen 2006).
double YieldStrength::friction(double effective_pressure, double strain_rate) const {
    const double number =
        2.0 * strain_rate * rate_->grain_diameter * std::sqrt(rate_->grain_density / effective_pressure);
    return sin_phi_ + rate_->increase * number / (number + rate_->inertial_number);
}

}  // namespace runout
