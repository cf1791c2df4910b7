#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "engine/particles/wall.h"
#include "engine/problem.h"

namespace runout {

/// Strength on the bed at x over the effective pressure: tan(delta) where that is less than sin(phi), else
/// sin(phi).
double base_strength_ratio(const Material& material, const Effects& effects, double x);

/// Strength on the bed over the pressure, where it is least: sin(phi), or tan(delta) of a weaker base.
double least_strength(const Material& material, const Effects& effects);

/// base_strength_ratio per boundary particle. Empty where the whole bed is rough.
std::vector<double> base_strength_ratios(const Material& material, const Effects& effects, const Wall& wall);

/// Per boundary particle, 1 where the base is weaker than the soil, see Wall::slips. Empty where the whole
/// bed is rough.
std::vector<char> slipping_base(const Material& material, const Effects& effects, const Wall& wall);

/// Greatest mean tension that the soil bears, Pa: as given, or that of uniaxial tension at yield,
/// c cos(phi)/(1 + sin(phi)). 0 without cohesion.
double tension_cut_off(const Material& material, const Effects& effects);

/// Yield stress of Coulomb soil,
///   |s| <= c cos(phi) + max(p - u, -T) mu,   mu = sin(phi), or mu(I) where friction depends on the rate.
/// On a weaker base tan(delta) takes the place of sin(phi), and cohesion is reduced in the same proportion.
class YieldStrength {
  public:
    YieldStrength(const Material& material, const Effects& effects, std::vector<double> base_ratios);

    /// Yield stress, Pa, of the boundary particle of this index in the wall, or of soil (-1).
    /// `pore_pressure`, Pa, and `strain_rate`, |e|, 1/s, count only where their effects are there.
    /// `pressure`: Pa.
    [[nodiscard]] double at(int wall_index, double pressure, double pore_pressure, double strain_rate) const {
        const double p = std::max(wet_ ? pressure - pore_pressure : pressure, -tension_);
        if (wall_index >= 0 && !base_ratios_.empty()) {
            const double ratio = base_ratios_[static_cast<std::size_t>(wall_index)];
            if (ratio < sin_phi_) return std::max(0.0, p * ratio + cohesion_ * ratio / sin_phi_);
        }
        const double mu = rate_ && p > 0.0 ? friction(p, strain_rate) : sin_phi_;
        return std::max(0.0, p * mu + cohesion_);
    }

    [[nodiscard]] bool wet() const { return wet_; }
    [[nodiscard]] bool cohesive() const { return cohesion_ > 0.0; }
    [[nodiscard]] bool depends_on_rate() const { return rate_.has_value(); }

  private:
    [[nodiscard]] double friction(double effective_pressure, double strain_rate) const;

    double sin_phi_;
    double cohesion_;  ///< c cos(phi), Pa
    double tension_;   ///< Pa
    std::optional<RateDependence> rate_;
    bool wet_;
    std::vector<double> base_ratios_;
};

}  // namespace runout
