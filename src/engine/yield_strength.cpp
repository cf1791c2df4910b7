#include "engine/yield_strength.h"

#include <algorithm>
#include <cmath>

#include "engine/parallel.h"

namespace runout {

double base_strength_ratio(const Material& material, const Effects& effects, double x) {
    const double own = std::sin(material.friction_angle);
    if (!effects.base_friction) return own;
    double angle = effects.base_friction->angle;
    for (const FrictionRange& range : effects.base_friction->ranges)
        if (x >= range.from && x < range.to) angle = range.angle;
    return std::isnan(angle) ? own : std::min(own, std::tan(angle));
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

void YieldStrength::find(const Neighbours& n, const std::vector<double>& pressure,
                         const std::vector<double>& pore_pressure, const std::vector<double>& strain_rate,
                         int threads, std::vector<float>& strength) const {
    for_each_piece(n.nodes, threads, [&](int first, int last) {
        for (int i = first; i < last; ++i) {
            const double p = std::max(wet_ ? pressure[i] - pore_pressure[i] : pressure[i], -tension_);
            const double mu = rate_ && p > 0.0 ? friction(p, strain_rate[i]) : sin_phi_;
            strength[i] = static_cast<float>(std::max(0.0, p * mu + cohesion_));
        }
    });
    if (!base_ratios_.empty()) weaken_base(n, pressure, pore_pressure, strength);
}

void YieldStrength::weaken_base(const Neighbours& n, const std::vector<double>& pressure,
                                const std::vector<double>& pore_pressure,
                                std::vector<float>& strength) const {
    const auto weaken = [&](int node, int boundary) {
        const double ratio = base_ratios_[static_cast<std::size_t>(boundary)];
        if (ratio >= sin_phi_) return;
        const double p = std::max(wet_ ? pressure[node] - pore_pressure[node] : pressure[node], -tension_);
        strength[node] = static_cast<float>(std::max(0.0, p * ratio + cohesion_ * ratio / sin_phi_));
    };
    for (int i = 0; i < n.soil_count; ++i) {
        if (n.nearest_boundary[i] >= 0) weaken(i, n.nearest_boundary[i]);
    }
    for (int a = 0; a < n.active_count(); ++a) weaken(n.first_boundary + a, n.active[a]);
}

}  // namespace runout
